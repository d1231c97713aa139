#include "LosTopos/io/fe_keywords.h"

#include <algorithm>
#include <array>
#include <span>

#include "LosTopos/io/read_error.h"

namespace lostopos {
namespace {

constexpr std::array<std::string_view, 5> elements{"declaration", "vertex", "edge", "facet", "body"};

// Of the view, of what Evolver is to do, or of what is so here anyway.
constexpr std::array<std::string_view, 22> passed_declarations{"soapfilm",
                                                               "linear",
                                                               "scale",
                                                               "total_time",
                                                               "view_matrix",
                                                               "slice_coeff",
                                                               "clip_coeff",
                                                               "parameter",
                                                               "vertices_predicted",
                                                               "edges_predicted",
                                                               "facets_predicted",
                                                               "scale_limit",
                                                               "jiggle",
                                                               "bodies_predicted",
                                                               "facetedges_predicted",
                                                               "evolver_version",
                                                               "keep_originals",
                                                               "gravity_constant",
                                                               "quantities_predicted",
                                                               "method_instances_predicted",
                                                               "constraint_tolerance",
                                                               "random_seed"};

constexpr const char* other_elements = "facets are plain triangles here";
constexpr const char* other_space = "space is open and has three dimensions here";
constexpr const char* other_limits = "there are no constraints or boundaries here but vertices that are 'fixed'";
constexpr const char* other_energies = "films have no energy here but tension";
constexpr const char* own_words = "let Evolver read this file and dump it: its dumps are read";

struct Refused {
  std::string_view keyword;
  const char* reason;
};

constexpr std::array<Refused, 28> refused_declarations{{{"constraint", other_limits},
                                                        {"boundary", other_limits},
                                                        {"torus", other_space},
                                                        {"torus_filled", other_space},
                                                        {"torus_periods", other_space},
                                                        {"periods", other_space},
                                                        {"symmetry_group", other_space},
                                                        {"group_generators", other_space},
                                                        {"space_dimension", other_space},
                                                        {"surface_dimension", other_elements},
                                                        {"string", other_elements},
                                                        {"quadratic", other_elements},
                                                        {"lagrange", other_elements},
                                                        {"simplex_representation", other_elements},
                                                        {"quantity", other_energies},
                                                        {"method_instance", other_energies},
                                                        {"define", other_energies},
                                                        {"surface_energy", other_energies},
                                                        {"wulff", other_energies},
                                                        {"metric", other_energies},
                                                        {"conformal_metric", other_energies},
                                                        {"klein_metric", other_energies},
                                                        {"phasefile", other_energies},
                                                        {"pressure", other_energies},
                                                        {"mean_curvature_integral", other_energies},
                                                        {"square_curvature", other_energies},
                                                        {"#define", own_words},
                                                        {"#include", own_words}}};

// What is to be done with an attribute.
enum class Treatment {
  kept,
  passed,      // says nothing here
  zero_alone,  // says nothing here as long as it is zero
  refused
};

struct AttributeRule {
  std::string_view keyword;
  Treatment treatment;
  int values = 0;  // behind the keyword, of what is passed over
  FeAttribute meaning = FeAttribute::none;
  const char* reason = "";
};

constexpr std::array<AttributeRule, 6> vertex_attributes{{{"fixed", Treatment::kept, 0, FeAttribute::fixed},
                                                          {"original", Treatment::passed, 1},
                                                          {"bare", Treatment::passed},
                                                          {"constraint", Treatment::refused, 0, {}, other_limits},
                                                          {"constraints", Treatment::refused, 0, {}, other_limits},
                                                          {"boundary", Treatment::refused, 0, {}, other_limits}}};

constexpr std::array<AttributeRule, 10> edge_attributes{{{"fixed", Treatment::passed},
                                                         {"no_refine", Treatment::passed},
                                                         {"bare", Treatment::passed},
                                                         {"color", Treatment::passed, 1},
                                                         {"original", Treatment::passed, 1},
                                                         {"tension", Treatment::zero_alone, 1, {}, other_energies},
                                                         {"density", Treatment::zero_alone, 1, {}, other_energies},
                                                         {"constraint", Treatment::refused, 0, {}, other_limits},
                                                         {"constraints", Treatment::refused, 0, {}, other_limits},
                                                         {"boundary", Treatment::refused, 0, {}, other_limits}}};

constexpr std::array<AttributeRule, 15> facet_attributes{{{"tension", Treatment::kept, 0, FeAttribute::tension},
                                                          {"density", Treatment::kept, 0, FeAttribute::tension},
                                                          {"frontbody", Treatment::kept, 0, FeAttribute::front_body},
                                                          {"backbody", Treatment::kept, 0, FeAttribute::back_body},
                                                          {"fixed", Treatment::passed},
                                                          {"no_refine", Treatment::passed},
                                                          {"nodisplay", Treatment::passed},
                                                          {"color", Treatment::passed, 1},
                                                          {"frontcolor", Treatment::passed, 1},
                                                          {"backcolor", Treatment::passed, 1},
                                                          {"original", Treatment::passed, 1},
                                                          {"constraint", Treatment::refused, 0, {}, other_limits},
                                                          {"constraints", Treatment::refused, 0, {}, other_limits},
                                                          {"boundary", Treatment::refused, 0, {}, other_limits},
                                                          {"phase", Treatment::refused, 0, {}, other_energies}}};

constexpr const char* other_bodies = "bodies keep their volumes here, and have no weight";

constexpr std::array<AttributeRule, 8> body_attributes{{{"original", Treatment::kept, 0, FeAttribute::original},
                                                        {"volume", Treatment::passed, 1},
                                                        {"lagrange_multiplier", Treatment::passed, 1},
                                                        {"centerofmass", Treatment::passed},
                                                        {"volconst", Treatment::zero_alone, 1, {}, other_bodies},
                                                        {"density", Treatment::zero_alone, 1, {}, other_bodies},
                                                        {"pressure", Treatment::refused, 0, {}, other_bodies},
                                                        {"phase", Treatment::refused, 0, {}, other_energies}}};

std::span<const AttributeRule> attributes_of(FeSection section) {
  switch (section) {
    case FeSection::vertices:
      return vertex_attributes;
    case FeSection::edges:
      return edge_attributes;
    case FeSection::facets:
      return facet_attributes;
    case FeSection::bodies:
      return body_attributes;
    case FeSection::head:
      break;
  }
  return {};
}

std::string known_attributes(FeSection section) {
  std::string list;
  for (const AttributeRule& attribute : attributes_of(section))
    if (attribute.treatment != Treatment::refused) list.append(list.empty() ? "" : ", ").append(attribute.keyword);
  return list;
}

[[noreturn]] void refuse_keyword(const FeText& text, std::string_view keyword, const char* reason) {
  text.fail(in_quotes(keyword) + " has no place in a surface: " + reason);
}

}  // namespace

std::optional<FeSection> fe_section(std::string_view keyword) {
  if (keyword == "vertices") return FeSection::vertices;
  if (keyword == "edges") return FeSection::edges;
  if (keyword == "faces" || keyword == "facets") return FeSection::facets;
  if (keyword == "bodies") return FeSection::bodies;
  return std::nullopt;
}

std::string_view fe_element(FeSection section) {
  return elements[static_cast<std::size_t>(section)];
}

bool is_fe_declaration(std::string_view keyword) {
  return std::ranges::find(passed_declarations, keyword) != passed_declarations.end() ||
         std::ranges::find(refused_declarations, keyword, &Refused::keyword) != refused_declarations.end();
}

void pass_fe_declaration(FeText& text, std::string_view keyword) {
  const bool passed = std::ranges::find(passed_declarations, keyword) != passed_declarations.end();
  const auto refused = std::ranges::find(refused_declarations, keyword, &Refused::keyword);
  if (refused != refused_declarations.end()) {
    if (keyword == "space_dimension" && text.integer("a number of dimensions") == 3) return;
    if (keyword == "surface_dimension" && text.integer("a number of dimensions") == 2) return;
    refuse_keyword(text, keyword, refused->reason);
  }
  if (!passed)
    text.fail(in_quotes(keyword) + " is no declaration that is known here; " + own_words +
              ", or leave the line out where it says nothing of the surface");
}

FeAttribute take_fe_attribute(FeText& text, FeSection section, std::string_view keyword) {
  const auto known = attributes_of(section);
  const auto found = std::ranges::find(known, keyword, &AttributeRule::keyword);
  if (found == known.end())
    text.fail(in_quotes(keyword) + " is no attribute of the " + std::string(fe_element(section)) +
              " that is known here; known are " + known_attributes(section));
  if (found->treatment == Treatment::refused) refuse_keyword(text, keyword, found->reason);
  if (found->treatment == Treatment::zero_alone) {
    if (text.number("a value") != 0) refuse_keyword(text, keyword, found->reason);
    return FeAttribute::none;
  }
  for (int i = 0; i < found->values; ++i)
    if (text.next_word().empty())
      text.fail("the line ends where the value of " + in_quotes(keyword) + " should follow");
  return found->meaning;
}

}  // namespace lostopos
