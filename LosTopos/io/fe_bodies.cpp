#include "LosTopos/io/fe_bodies.h"

#include <algorithm>

#include "LosTopos/io/read_error.h"
#include "LosTopos/io/surface_checks.h"
#include "LosTopos/io/surface_data.h"

namespace lostopos {

std::string FeBodies::add(std::uint32_t facet, Side side, std::int64_t body) {
  if (body < 0 || body > largest_region) return "there can be no body " + std::to_string(body);
  std::uint32_t& there = sides_[facet][static_cast<std::size_t>(side)];
  if (there != none && there != body)
    return "a facet would have two bodies on one side, " + std::to_string(there) + " and " + std::to_string(body) +
           "; normals point out of the body that names the facet without a minus";
  there = static_cast<std::uint32_t>(body);
  return {};
}

std::vector<Labels> FeBodies::labels(const std::string& file, const FeNumbers& facets) {
  const auto has_none = [](const auto& sides) { return sides[0] == none && sides[1] == none; };
  if (std::ranges::all_of(sides_, has_none)) return std::vector<Labels>(sides_.size(), default_labels);
  std::ranges::stable_sort(bodies_, {}, &Body::region);
  require_different(file, &Body::region);
  std::ranges::stable_sort(bodies_, {}, &Body::number);
  require_different(file, &Body::number);
  std::vector<std::size_t> lines(sides_.size());
  for (const FeNumbers::Entry& facet : facets.entries()) lines[facet.index] = facet.line;
  std::vector<Labels> labels;
  labels.reserve(sides_.size());
  for (std::size_t facet = 0; facet < sides_.size(); ++facet) {
    const auto [back, front] = sides_[facet];
    if (has_none(sides_[facet]))
      throw_at_line(file, lines[facet], "the facet belongs to no body, others do; a film has two regions");
    const Labels pair{region_of(back, file, lines[facet]), region_of(front, file, lines[facet])};
    const std::string problem = label_problem(pair.p.index(), pair.q.index());
    if (!problem.empty()) throw_at_line(file, lines[facet], problem);
    labels.push_back(pair);
  }
  return labels;
}

void FeBodies::require_different(const std::string& file, std::uint32_t Body::*what) const {
  const auto twice = std::ranges::adjacent_find(bodies_, {}, what);
  if (twice == bodies_.end()) return;
  throw_at_line(file, std::max(twice->line, std::next(twice)->line),
                "a body is number " + std::to_string((*twice).*what) + ", or was originally, as is another one");
}

Region FeBodies::region_of(std::uint32_t body, const std::string& file, std::size_t line) const {
  if (body == none) return air;
  const auto found = std::ranges::lower_bound(bodies_, body, {}, &Body::number);
  if (found == bodies_.end() || found->number != body)
    throw_at_line(file, line, "the facet's body " + std::to_string(body) + " does not exist");
  return Region{found->region};
}

}  // namespace lostopos
