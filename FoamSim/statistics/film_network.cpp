#include "FoamSim/statistics/film_network.h"

#include "Base/lists/disjoint_sets.h"
#include "Base/lists/erase_repeated.h"
#include "FoamSim/sheet/surface_geometry.h"
#include "LosTopos/mesh/measures.h"

namespace foamsim {

using lostopos::Edge;
using lostopos::SurfaceMesh;
using lostopos::Triangle;
using lostopos::Vertex;

namespace {

class Network {
 public:
  Network(const SurfaceMesh& mesh, std::span<const std::uint8_t> solid)
      : mesh_(mesh),
        solid_(solid),
        borders_at_(mesh.vertex_slots(), 0),
        film_sets_(mesh.triangle_slots()),
        border_sets_(mesh.edge_slots()) {
    for (Edge e : mesh.edges())
      if (mesh.is_junction(e))
        for (Vertex v : mesh.vertices(e)) ++borders_at_[v.index()];
    collect_films();
    collect_borders();
    for (Vertex v : mesh.vertices())
      if (is_plateau_vertex(v)) out_.vertices.push_back(v);
    connect();
  }

  FilmNetwork take() { return std::move(out_); }

 private:
  bool is_film(Triangle t) const { return !is_solid(t, solid_); }
  bool is_plateau_vertex(Vertex v) const { return borders_at_[v.index()] > 2; }

  void collect_films() {
    for (Edge e : mesh_.edges()) {
      const auto at = mesh_.triangles(e);
      if (at.size() == 2 && is_film(at[0]) && is_film(at[1]) &&
          RegionPair(mesh_.labels(at[0])) == RegionPair(mesh_.labels(at[1])))
        film_sets_.unite(at[0].index(), at[1].index());
    }
    film_of_.assign(mesh_.triangle_slots(), 0);
    for (Triangle t : mesh_.triangles()) {
      if (!is_film(t)) continue;
      const std::size_t first = film_sets_.find(t.index());
      if (first == t.index()) {
        film_of_[first] = out_.films.size();
        out_.films.push_back({.regions = RegionPair(mesh_.labels(t)), .borders = {}, .vertices = {}});
      }
      film_of_[t.index()] = film_of_[first];
      out_.films[film_of_[first]].area += lostopos::area(mesh_, t);
    }
  }

  // Through vertices at which one border goes on.
  void collect_borders() {
    std::vector<Edge> last(mesh_.vertex_slots());
    for (Edge e : mesh_.edges()) {
      if (!mesh_.is_junction(e)) continue;
      for (Vertex v : mesh_.vertices(e)) {
        if (borders_at_[v.index()] != 2) continue;
        if (last[v.index()].valid()) border_sets_.unite(e.index(), last[v.index()].index());
        last[v.index()] = e;
      }
    }
    border_of_.assign(mesh_.edge_slots(), 0);
    for (Edge e : mesh_.edges()) {
      if (!mesh_.is_junction(e)) continue;
      const std::size_t first = border_sets_.find(e.index());
      if (first == e.index()) {
        border_of_[first] = out_.borders.size();
        out_.borders.emplace_back();
      }
      border_of_[e.index()] = border_of_[first];
      PlateauBorder& border = out_.borders[border_of_[first]];
      border.length += lostopos::length(mesh_, e);
      for (Vertex v : mesh_.vertices(e))
        if (borders_at_[v.index()] != 2) border.closed = false;
    }
  }

  void connect() {
    for (Edge e : mesh_.edges()) {
      if (!mesh_.is_junction(e)) continue;
      for (Triangle t : mesh_.triangles(e)) {
        if (!is_film(t)) continue;
        Film& film = out_.films[film_of_[t.index()]];
        film.borders.push_back(border_of_[e.index()]);
        for (Vertex v : mesh_.vertices(e))
          if (is_plateau_vertex(v)) film.vertices.push_back(v);
      }
    }
    for (Film& film : out_.films) {
      base::sort_unique(film.borders);
      base::sort_unique(film.vertices);
    }
  }

  const SurfaceMesh& mesh_;
  std::span<const std::uint8_t> solid_;
  std::vector<int> borders_at_;  // edges of borders, by vertex slot
  base::DisjointSets film_sets_, border_sets_;
  std::vector<std::size_t> film_of_, border_of_;  // by triangle and edge slot
  FilmNetwork out_;
};

}  // namespace

FilmNetwork film_network(const SurfaceMesh& mesh, std::span<const std::uint8_t> solid) {
  return Network(mesh, solid).take();
}

}  // namespace foamsim
