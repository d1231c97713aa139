#include "LosTopos/topology/coincident_triangles.h"

#include <algorithm>

namespace lostopos {
namespace {

// +1 for the same cyclic order of the same vertices, -1 for the opposite one, 0 for other vertices.
int relative_order(const std::array<Vertex, 3>& a, const std::array<Vertex, 3>& b) {
  for (std::size_t shift = 0; shift < 3; ++shift) {
    if (a[0] != b[shift]) continue;
    if (a[1] == b[(shift + 1) % 3] && a[2] == b[(shift + 2) % 3]) return 1;
    if (a[1] == b[(shift + 2) % 3] && a[2] == b[(shift + 1) % 3]) return -1;
  }
  return 0;
}

// What is left of two films that lie on each other, with the region between them gone. Equal labels: nothing.
std::optional<Labels> combined(Labels a, Labels b) {
  if (a.q == b.p) return Labels{a.p, b.q};
  if (a.p == b.q) return Labels{b.p, a.q};
  return {};
}

}  // namespace

std::optional<std::size_t> cancel_coincident(ChangePlan& plan) {
  auto& triangles = plan.triangles;
  std::size_t gone = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t j = i + 1; j < triangles.size(); ++j) {
      const int order = relative_order(triangles[i].vertices, triangles[j].vertices);
      if (order == 0) continue;
      const Labels other = order > 0 ? triangles[j].labels : triangles[j].labels.flipped();
      const auto labels = combined(triangles[i].labels, other);
      if (!labels) return {};
      triangles.erase(triangles.begin() + static_cast<std::ptrdiff_t>(j));
      ++gone;
      j = i;  // a third one may coincide with what is left
      if (labels->p != labels->q) {
        triangles[i].labels = *labels;
        triangles[i].moved_only = false;
        continue;
      }
      triangles.erase(triangles.begin() + static_cast<std::ptrdiff_t>(i));
      ++gone;
      --i;  // wraps at the front, and the loop's increment brings it back
      break;
    }
  }
  return gone;
}

}  // namespace lostopos
