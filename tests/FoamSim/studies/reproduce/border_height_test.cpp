#include "FoamSim/studies/reproduce/border_height.h"

#include <gtest/gtest.h>

#include "FoamSim/scenes/shapes/solids.h"
#include "LosTopos/shapes/triple_junction.h"

namespace foamsim {
namespace {

TEST(BorderHeight, OfRowsOneAwayIsOneThirdOfTheThreeFilmsHeights) {
  // Away from the border's ends a vertex has 3 films × 3 triangles of area 1/2 (of rows `stretch` away: stretch/2) and
  // an edge of length 1: (2/9)(3 + 3 + 3 stretch)/2.
  const double even = mean_border_height(lostopos::triple_junction({120, 120, 120}).mesh);
  const double stretched = mean_border_height(lostopos::triple_junction({120, 120, 120}, 1, 4).mesh);
  EXPECT_NEAR(even, 1, 1e-12);
  EXPECT_NEAR(stretched / even, 2, 1e-12) << "the mean of 1, 1 and 4";
}

TEST(BorderHeight, WithoutABorderIsZero) {
  EXPECT_EQ(mean_border_height(icosphere(1)), 0);
}

}  // namespace
}  // namespace foamsim
