#include <algorithm>
#include <utility>

#include "Base/lists/equal_entries.h"
#include "LosTopos/geometry/predicates.h"
#include "LosTopos/io/repair/repairs.h"
#include "LosTopos/io/surface_edit.h"

namespace lostopos {
namespace {

using Corners3 = std::array<std::uint32_t, 3>;

// The triangles at every edge.
class EdgeTriangles {
 public:
  explicit EdgeTriangles(const std::vector<Corners3>& triangles) {
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i)
        entries_.push_back({std::minmax({triangles[t][i], triangles[t][(i + 1) % 3]}), t});
    std::ranges::sort(entries_, {}, [](const Entry& entry) { return std::pair(entry.ends, entry.triangle); });
  }
  std::vector<std::size_t> at(std::uint32_t a, std::uint32_t b) const {
    std::vector<std::size_t> triangles;
    const std::pair<std::uint32_t, std::uint32_t> ends = std::minmax(a, b);
    for (const Entry& entry : base::equal_entries(entries_, ends, &Entry::ends)) triangles.push_back(entry.triangle);
    return triangles;
  }

 private:
  struct Entry {
    std::pair<std::uint32_t, std::uint32_t> ends;
    std::size_t triangle;
  };
  std::vector<Entry> entries_;
};

// Of corners on a line: the one between the others, and these.
struct Line {
  std::uint32_t from, middle, to;
};

class FlatTriangles {
 public:
  explicit FlatTriangles(SurfaceData& data) : data_(data), edges_(data.triangles) {
    for (const Corners3& triangle : data.triangles) flat_.push_back(is_flat(triangle));
  }

  // Removes those that border on others only, and splits these; a triangle is changed once. Returns how many went.
  std::size_t pass() {
    std::vector<bool> done(data_.triangles.size(), false);
    std::vector<Corners3> triangles;
    std::vector<std::size_t> parents;
    std::size_t removed = 0;
    for (std::size_t t = 0; t < data_.triangles.size(); ++t) {
      if (!flat_[t] || done[t]) continue;
      const Line line = line_of(data_.triangles[t]);
      std::vector<std::size_t> beyond = edges_.at(line.from, line.to);
      std::erase(beyond, t);
      if (std::ranges::any_of(beyond, [&](std::size_t other) { return flat_[other] || done[other]; })) continue;
      ++removed;
      done[t] = true;
      for (const std::size_t other : beyond) {
        done[other] = true;
        for (const std::uint32_t end : {line.from, line.to}) {
          triangles.push_back(data_.triangles[other]);
          std::ranges::replace(triangles.back(), end, line.middle);
          parents.push_back(other);
        }
      }
    }
    if (removed == 0) return 0;
    std::vector<Corners3> all;
    std::vector<std::size_t> all_parents;
    for (std::size_t t = 0; t < data_.triangles.size(); ++t) {
      if (done[t]) continue;
      all.push_back(data_.triangles[t]);
      all_parents.push_back(t);
    }
    all.insert(all.end(), triangles.begin(), triangles.end());
    all_parents.insert(all_parents.end(), parents.begin(), parents.end());
    replace_triangles(data_, std::move(all), all_parents);
    return removed;
  }

 private:
  const Vec3& position(std::uint32_t v) const { return data_.positions[v]; }
  bool is_flat(const Corners3& t) const { return collinear(position(t[0]), position(t[1]), position(t[2])); }
  Line line_of(const Corners3& t) const {
    Line line{};
    double longest = -1;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = t[i], to = t[(i + 1) % 3];
      const double length = (position(to) - position(from)).stableNorm();
      if (length <= longest) continue;
      longest = length;
      line = {from, t[(i + 2) % 3], to};
    }
    return line;
  }

  SurfaceData& data_;
  EdgeTriangles edges_;
  std::vector<bool> flat_;
};

}  // namespace

std::size_t remove_flat_triangles(SurfaceData& data) {
  constexpr int most_passes = 100;  // a row of flat triangles needs one for each
  std::size_t removed = 0;
  for (int pass = 0; pass < most_passes; ++pass) {
    const std::size_t now = FlatTriangles(data).pass();
    if (now == 0) break;
    removed += now;
  }
  return removed;
}

}  // namespace lostopos
