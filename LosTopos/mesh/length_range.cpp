#include "LosTopos/mesh/length_range.h"

#include <sstream>

#include "Base/error.h"

namespace lostopos {
namespace {

// A vertex' coordinates in full: two that differ are not shown alike.
std::string text_of(const Vec3& position) {
  std::ostringstream text;
  text.precision(17);
  text << '(' << position[0] << ", " << position[1] << ", " << position[2] << ')';
  return text.str();
}

std::string range_text() {
  std::ostringstream text;
  text << smallest_length << " to " << largest_length;
  return text.str();
}

}  // namespace

std::string position_problem(const Vec3& position) {
  if ((position.array().abs() <= largest_length).all()) return {};
  if (!position.allFinite()) return "the position is " + text_of(position) + "; its coordinates have to be finite";
  std::ostringstream text;
  text << "the position is " << text_of(position) << "; its coordinates have to be between " << -largest_length
       << " and " << largest_length << ": give the surface in another unit of length";
  return text.str();
}

std::string edge_problem(const Vec3& from, const Vec3& to) {
  const double extent = (to - from).cwiseAbs().maxCoeff();
  if (extent == 0 || extent >= smallest_length) return {};
  std::ostringstream text;
  text << "the edge from " << text_of(from) << " is " << extent << " long; lengths of " << range_text()
       << " can be computed with: give the surface in another unit of length";
  return text.str();
}

std::string resolution_problem(double resolution) {
  if (resolution >= smallest_length && resolution <= largest_length) return {};
  std::ostringstream text;
  text << "the resolution is " << resolution << "; lengths of " << range_text() << " can be computed with";
  return text.str();
}

void require_lengths_in_range(const SurfaceMesh& mesh) {
  for (const Vertex v : mesh.vertices())
    if (const std::string problem = position_problem(mesh.position(v)); !problem.empty())
      throw base::InputError("vertex " + std::to_string(v.index()) + ": " + problem);
  for (const Edge e : mesh.edges()) {
    const auto& [a, b] = mesh.vertices(e);
    if (const std::string problem = edge_problem(mesh.position(a), mesh.position(b)); !problem.empty())
      throw base::InputError("edge " + std::to_string(e.index()) + ": " + problem);
  }
}

}  // namespace lostopos
