#include "FoamSim/constraints/selection.h"

#include <algorithm>

#include "Base/error.h"
#include "Base/io/number_text.h"
#include "Base/names/words.h"

namespace foamsim {

using lostopos::Edge;
using lostopos::Hold;
using lostopos::SurfaceMesh;
using lostopos::Vertex;

namespace {

constexpr std::string_view coordinate_names = "xyz";

std::string what_selections_are() {
  return "a selection is made of 'held', 'free-edges', 'vertices 3 4 5' and half-spaces as 'x < 0', joined by 'and'";
}

[[noreturn]] void throw_bad(std::string_view part, std::string_view all) {
  throw base::InputError("'" + std::string(part) + "' in the selection '" + std::string(all) + "' means nothing; " +
                         what_selections_are());
}

}  // namespace

bool Selection::HalfSpace::contains(const lostopos::Vec3& x) const {
  const double value = x[coordinate];
  if (relation == "<") return value < bound;
  if (relation == "<=") return value <= bound;
  if (relation == ">") return value > bound;
  return value >= bound;
}

Selection::Selection(std::string_view text) {
  const std::vector<std::string> words = base::words_of(text);
  for (auto begin = words.begin(); begin != words.end();) {
    const auto end = std::find(begin, words.end(), "and");
    terms_.push_back(parse_term({begin, end}, text));
    if (end == words.end()) return;
    begin = end + 1;
  }
  throw base::InputError("the selection '" + std::string(text) + "' is not complete; " + what_selections_are());
}

Selection::Term Selection::parse_term(std::span<const std::string> words, std::string_view all) {
  const std::string part = base::joined(words);
  if (part == "held") return Held{};
  if (part == "free-edges") return FreeEdges{};
  if (words.size() > 1 && words[0] == "vertices") {
    Numbers numbers;
    for (const std::string& word : words.subspan(1)) {
      const auto number = base::parse_integer(word);
      if (!number || *number < 0 || *number > UINT32_MAX) throw_bad(part, all);
      numbers.vertices.push_back(static_cast<std::uint32_t>(*number));
    }
    return numbers;
  }
  // "x < 0" and "x<0" alike.
  const std::string half_space = base::joined(words, "");
  const auto coordinate = half_space.empty() ? std::string_view::npos : coordinate_names.find(half_space[0]);
  const auto bound_at = half_space.find_first_not_of("<>=", 1);
  if (coordinate == std::string_view::npos || bound_at == std::string::npos) throw_bad(part, all);
  const std::string relation = half_space.substr(1, bound_at - 1);
  const auto bound = base::parse_double(std::string_view(half_space).substr(bound_at));
  const bool known = relation == "<" || relation == "<=" || relation == ">" || relation == ">=";
  if (!known || !bound) throw_bad(part, all);
  return HalfSpace{static_cast<int>(coordinate), relation, *bound};
}

void Selection::keep(const Term& term, const SurfaceMesh& mesh, std::span<const Hold> held,
                     std::vector<char>& meant) const {
  std::vector<char> of_term(meant.size(), 0);
  if (std::holds_alternative<Held>(term)) {
    for (std::size_t v = 0; v < held.size(); ++v) of_term[v] = lostopos::is_held(held[v]) ? 1 : 0;
  } else if (std::holds_alternative<FreeEdges>(term)) {
    for (Edge e : mesh.edges())
      if (mesh.triangles(e).size() == 1)
        for (Vertex v : mesh.vertices(e)) of_term[v.index()] = 1;
  } else if (const auto* numbers = std::get_if<Numbers>(&term)) {
    for (std::uint32_t number : numbers->vertices) {
      if (number >= mesh.vertex_slots() || !mesh.alive(Vertex(number)))
        throw base::InputError("the selection '" + text() + "' names vertex " + std::to_string(number) +
                               ", which the start mesh does not have; its vertices are 0 to " +
                               std::to_string(mesh.vertex_slots() - 1));
      of_term[number] = 1;
    }
  } else {
    const auto& half = std::get<HalfSpace>(term);
    for (Vertex v : mesh.vertices()) of_term[v.index()] = half.contains(mesh.position(v)) ? 1 : 0;
  }
  for (std::size_t v = 0; v < meant.size(); ++v) meant[v] = static_cast<char>(meant[v] & of_term[v]);
}

std::vector<Vertex> Selection::of(const SurfaceMesh& mesh, std::span<const Hold> held) const {
  std::vector<char> meant(mesh.vertex_slots(), 0);
  for (Vertex v : mesh.vertices()) meant[v.index()] = 1;
  for (const Term& term : terms_) keep(term, mesh, held, meant);
  std::vector<Vertex> vertices;
  for (Vertex v : mesh.vertices())
    if (meant[v.index()] != 0) vertices.push_back(v);
  if (vertices.empty()) {
    const auto marked = std::ranges::count_if(held, [](Hold hold) { return lostopos::is_held(hold); });
    throw base::InputError("the selection '" + text() + "' matches no vertex of the start mesh, which has " +
                           std::to_string(mesh.vertex_count()) + " (" + std::to_string(marked) +
                           " of them marked as held)");
  }
  return vertices;
}

std::string Selection::text() const {
  std::string text;
  for (const Term& term : terms_) {
    if (!text.empty()) text += " and ";
    if (std::holds_alternative<Held>(term)) text += "held";
    if (std::holds_alternative<FreeEdges>(term)) text += "free-edges";
    if (const auto* numbers = std::get_if<Numbers>(&term)) {
      text += "vertices";
      for (std::uint32_t number : numbers->vertices) text += " " + std::to_string(number);
    }
    if (const auto* half = std::get_if<HalfSpace>(&term)) {
      text += std::string(1, coordinate_names[static_cast<std::size_t>(half->coordinate)]) + " " + half->relation + " ";
      base::append_number(text, half->bound);
    }
  }
  return text;
}

std::vector<Hold> held_marks(const SurfaceMesh& mesh) {
  std::vector<Hold> marks(mesh.vertex_slots(), Hold::none);
  for (const lostopos::NamedAttributeColumn* column : mesh.named_vertex_attributes())
    if (column->name() == "hold")
      for (std::size_t v = 0; v < marks.size(); ++v) marks[v] = static_cast<Hold>(column->number(v, 0));
  return marks;
}

}  // namespace foamsim
