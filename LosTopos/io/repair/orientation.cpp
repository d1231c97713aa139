#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "LosTopos/io/repair/repairs.h"
#include "LosTopos/mesh/audit.h"
#include "LosTopos/mesh/region_lines.h"

namespace lostopos {
namespace {

bool same_regions(const Labels& a, const Labels& b) {
  return a == b || a == b.flipped();
}

// The region that two films have in common; none where they have both, or neither.
std::optional<Region> common_region(const Labels& a, const Labels& b) {
  if (same_regions(a, b)) return std::nullopt;
  if (b.has(a.p)) return a.p;
  if (b.has(a.q)) return a.q;
  return std::nullopt;
}

void turn_triangle(SurfaceData& data, std::size_t t) {
  std::swap(data.triangles[t][1], data.triangles[t][2]);
}

// Films: triangles of the same two regions that are joined by edges which no other triangle has.
class Films {
 public:
  explicit Films(const SurfaceMesh& mesh)
      : mesh_(mesh), film_of_(mesh.triangle_slots(), none), turned_(mesh.triangle_slots(), false) {
    for (Triangle t : mesh.triangles())
      if (film_of_[t.index()] == none) follow(t);
    vote_at_junctions();
  }

  bool turned(Triangle t) const { return turned_[t.index()]; }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  // The regions before and behind t on a turn about e.
  Labels around(Triangle t, Edge e) const {
    return mesh_.runs_along(t, e) != turned_[t.index()] ? mesh_.labels(t) : mesh_.labels(t).flipped();
  }

  // Gives all triangles of a film the sense of rotation that most of them have.
  void follow(Triangle first) {
    const std::size_t film = films_++;
    std::vector<Triangle> members{first};
    film_of_[first.index()] = film;
    std::size_t turned = 0;
    for (std::size_t i = 0; i < members.size(); ++i) {
      for (Edge e : mesh_.edges(members[i])) {
        const auto both = mesh_.triangles(e);
        if (both.size() != 2) continue;
        const Triangle next = both[0] == members[i] ? both[1] : both[0];
        if (film_of_[next.index()] != none || !same_regions(mesh_.labels(next), mesh_.labels(first))) continue;
        film_of_[next.index()] = film;
        turned_[next.index()] = around(next, e) == around(members[i], e);
        turned += turned_[next.index()] ? 1 : 0;
        members.push_back(next);
      }
    }
    if (2 * turned > members.size())
      for (Triangle t : members) turned_[t.index()] = !turned_[t.index()];
  }

  // Two neighbours at a junction have the region between them in common, which tells how either has to be turned.
  void vote_at_junctions() {
    std::vector<long> votes(films_, 0);  // for staying, less those for being turned
    for (Edge e : mesh_.edges())
      if (mesh_.triangles(e).size() > 2) vote(e, votes);
    for (Triangle t : mesh_.triangles())
      if (votes[film_of_[t.index()]] < 0) turned_[t.index()] = !turned_[t.index()];
  }

  void vote(Edge e, std::vector<long>& votes) const {
    constexpr double least_angle = 1e-6;  // between films whose order can be told
    struct Film {
      double angle;
      Triangle triangle;
    };
    const auto [a, b] = mesh_.vertices(e);
    const Vec3 axis = mesh_.position(b) - mesh_.position(a);
    const Vec3 u = axis.unitOrthogonal(), w = axis.normalized().cross(u);
    std::vector<Film> films;
    for (Triangle t : mesh_.triangles(e)) {
      const Vec3 arm = mesh_.position(mesh_.opposite_vertex(t, e)) - mesh_.position(a);
      films.push_back({std::atan2(arm.dot(w), arm.dot(u)), t});
    }
    std::ranges::sort(films, {}, &Film::angle);
    for (std::size_t i = 0; i < films.size(); ++i) {
      const Film &film = films[i], &next = films[(i + 1) % films.size()];
      const double gap = next.angle - film.angle + (i + 1 == films.size() ? 2 * std::numbers::pi : 0);
      const auto between = common_region(mesh_.labels(film.triangle), mesh_.labels(next.triangle));
      if (!between || gap < least_angle) continue;
      votes[film_of_[film.triangle.index()]] += around(film.triangle, e).q == *between ? 1 : -1;
      votes[film_of_[next.triangle.index()]] += around(next.triangle, e).p == *between ? 1 : -1;
    }
  }

  const SurfaceMesh& mesh_;
  std::vector<std::size_t> film_of_;
  std::vector<bool> turned_;
  std::size_t films_ = 0;
};

// The closed parts of the surface in which no three films meet, as triangle numbers.
std::vector<std::vector<std::size_t>> lone_bubbles(const SurfaceMesh& mesh) {
  std::vector<bool> seen(mesh.triangle_slots(), false);
  std::vector<std::vector<std::size_t>> bubbles;
  for (Triangle first : mesh.triangles()) {
    if (seen[first.index()]) continue;
    std::vector<Triangle> members{first};
    seen[first.index()] = true;
    bool alone = true;
    for (std::size_t i = 0; i < members.size(); ++i)
      for (Edge e : mesh.edges(members[i])) {
        alone = alone && mesh.triangles(e).size() == 2;
        for (Triangle next : mesh.triangles(e)) {
          if (seen[next.index()]) continue;
          seen[next.index()] = true;
          members.push_back(next);
        }
      }
    if (!alone) continue;
    bubbles.emplace_back();
    for (Triangle t : members) bubbles.back().push_back(t.index());
  }
  return bubbles;
}

std::size_t contradictions(const SurfaceData& data) {
  constexpr std::size_t most = 10'000;
  return contradictions_on_lines(to_mesh(data), true, most).size();
}

}  // namespace

std::size_t orient_films(SurfaceData& data) {
  const SurfaceMesh mesh = to_mesh(data);
  const Films films(mesh);
  std::size_t turned = 0;
  for (Triangle t : mesh.triangles()) {
    if (!films.turned(t)) continue;
    turn_triangle(data, t.index());
    ++turned;
  }
  return turned;
}

std::size_t orient_bubbles(SurfaceData& data) {
  constexpr std::size_t most_bubbles = 200;  // each costs a search of the whole surface
  constexpr int most_rounds = 3;
  const SurfaceMesh mesh = to_mesh(data);
  if (!audit(mesh).has(Defect::inside_out)) return 0;  // of that, an audit speaks only where all else is in order
  const auto bubbles = lone_bubbles(mesh);
  if (bubbles.empty() || bubbles.size() > most_bubbles) return 0;
  std::size_t wrong = contradictions(data), turned = 0;
  for (int round = 0; round < most_rounds && wrong > 0; ++round)
    for (const auto& bubble : bubbles) {
      for (const std::size_t t : bubble) turn_triangle(data, t);
      const std::size_t now = contradictions(data);
      if (now < wrong) {
        wrong = now;
        ++turned;
      } else {
        for (const std::size_t t : bubble) turn_triangle(data, t);
      }
    }
  return turned;
}

}  // namespace lostopos
