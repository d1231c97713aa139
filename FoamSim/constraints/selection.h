#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "LosTopos/mesh/hold.h"
#include "LosTopos/mesh/surface_mesh.h"

namespace foamsim {

/// Which vertices of a start mesh are meant, as a text: one or more of
///
///     held                    what the scene or mesh file marks as held
///     free-edges              on an edge with a single triangle
///     vertices 3 4 5          by number
///     x < 0, y >= 1.5, …      in a half-space; x, y or z, and <, <=, > or >=
///
/// joined by `and`. To be evaluated once, on the start mesh; remeshing carries the result as a vertex attribute.
class Selection {
 public:
  /// Throws base::InputError that quotes the text and says what would be right.
  explicit Selection(std::string_view text);

  /// The vertices that are meant, ascending. `held`: by vertex slot, may be empty where nothing is held. Throws
  /// base::InputError where there are none, or for a number that no vertex has.
  std::vector<lostopos::Vertex> of(const lostopos::SurfaceMesh& mesh, std::span<const lostopos::Hold> held) const;

  /// The text in its shortest form; parsed again it means the same.
  std::string text() const;

 private:
  struct Held {};
  struct FreeEdges {};
  struct Numbers {
    std::vector<std::uint32_t> vertices;
  };
  struct HalfSpace {
    int coordinate;
    std::string relation;
    double bound;  // L
    bool contains(const lostopos::Vec3& x) const;
  };
  using Term = std::variant<Held, FreeEdges, Numbers, HalfSpace>;

  static Term parse_term(std::span<const std::string> words, std::string_view all);
  void keep(const Term& term, const lostopos::SurfaceMesh& mesh, std::span<const lostopos::Hold> held,
            std::vector<char>& meant) const;

  std::vector<Term> terms_;
};

/// What of each vertex is held according to a mesh on which a tracker works, by slot: the attribute "hold".
std::vector<lostopos::Hold> held_marks(const lostopos::SurfaceMesh& mesh);

}  // namespace foamsim
