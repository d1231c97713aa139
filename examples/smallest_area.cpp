#include <algorithm>

#include "models.h"

namespace {

// Of the areas that the regions at a vertex have by themselves the smallest, for all of them: balanced like `averaged`.
class SmallestArea final : public foamsim::VertexArea {
 public:
  void evaluate(const foamsim::VertexStar& star, std::span<double> area) const override {
    foamsim::area_of_own_triangles(star, area);
    std::ranges::fill(area, *std::ranges::min_element(area));
  }
};

}  // namespace

foamsim::VertexAreaEntry smallest_area() {
  return {"smallest", "the smallest of the regions' own areas", {}, [](const foamsim::VertexAreaSetup&) {
            return std::unique_ptr<foamsim::VertexArea>(std::make_unique<SmallestArea>());
          }};
}
