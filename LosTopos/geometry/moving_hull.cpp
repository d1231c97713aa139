#include "LosTopos/geometry/moving_hull.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "LosTopos/geometry/ccd.h"
#include "LosTopos/geometry/hull_pose.h"
#include "LosTopos/geometry/separation.h"

namespace lostopos {
namespace {

using Kind = HullFeature::Kind;

// An advance by less than these shares of the time left makes it worth looking at further certificates: those that turn
// with the nearest feature, then those of all features.
constexpr double good_share = 0.25;
constexpr double poor_share = 0.01;

// So many steps in a row below this share mean contact as far as rounding lets one see: shapes that come within some
// 1e-14 of each other and part again would else be followed in steps as small.
constexpr double negligible_share = 0x1p-30;
constexpr double negligible_ratio = 0x1p-40;  // to the time itself, for contacts at the very end
constexpr int max_negligible_steps = 12;

// The way through the time interval.
class Advance {
 public:
  explicit Advance(const MovingHull& hull) : hull_(hull) {}

  std::optional<HullContact> run();

 private:
  // Each takes its certificate if it reaches further than the best so far.
  void try_fixed_plane(Vec3 n);
  void try_turning_plane(MovingVector n);
  void try_volume();
  void try_all(const HullPose& pose);

  bool below_share(double share) const { return end_ - time_ < share * (1 - time_); }

  const MovingHull& hull_;
  std::optional<CoplanarityCubic> cubic_;  // made when first needed
  double time_ = 0;                        // certified so far
  double end_ = 0;                         // certified by the best certificate from there
  Vec3 direction_ = Vec3::Zero();
};

void Advance::try_fixed_plane(Vec3 n) {
  const double size = n.lpNorm<Eigen::Infinity>();
  if (!(size > 0)) return;
  n /= size;
  const double end = advance_by_fixed_plane(hull_, n, time_);
  if (!(end > end_)) return;
  end_ = end;
  direction_ = n;
}

void Advance::try_turning_plane(MovingVector n) {
  const double size = std::max(n.start.lpNorm<Eigen::Infinity>(), n.end.lpNorm<Eigen::Infinity>());
  if (!(size > 0)) return;
  n.start /= size;
  n.end /= size;
  const double end = advance_by_turning_plane(hull_, n, time_);
  if (!(end > end_)) return;
  end_ = end;
  direction_ = n.at(end);
}

void Advance::try_volume() {
  if (!cubic_) cubic_.emplace(hull_);
  const double end = cubic_->advance(time_);
  if (!(end > end_)) return;
  end_ = end;
  direction_ = cubic_->sign_at(time_) * hull_.e1.at(end).cross(hull_.e2.at(end));
}

void Advance::try_all(const HullPose& pose) {
  try_volume();
  try_fixed_plane(pose.direction({Kind::face}));
  for (int i = 0; i < pose.edge_count(); ++i) {
    try_fixed_plane(pose.direction({Kind::edge, i}));
    try_turning_plane(pose.turning_edge_direction(i));
  }
  for (int i = 0; i < pose.corner_count(); ++i) try_fixed_plane(pose.direction({Kind::corner, i}));
}

std::optional<HullContact> Advance::run() {
  int negligible_steps = 0;
  for (int step = 0; step < max_advances && negligible_steps < max_negligible_steps; ++step) {
    const HullPose pose(hull_, time_);
    const HullFeature nearest = pose.nearest_feature();
    end_ = time_;
    try_fixed_plane(pose.direction(nearest));
    if (below_share(good_share)) {
      if (nearest.kind == Kind::face) try_volume();
      if (nearest.kind == Kind::edge) try_turning_plane(pose.turning_edge_direction(nearest.index));
    }
    if (below_share(poor_share)) try_all(pose);
    if (end_ >= 1) return std::nullopt;
    if (!(end_ > time_)) break;
    negligible_steps =
        end_ - time_ < negligible_share * (1 - time_) + negligible_ratio * time_ ? negligible_steps + 1 : 0;
    time_ = end_;
  }
  return HullContact{time_, direction_};
}

}  // namespace

bool separated_along_an_axis(const MovingHull& hull) {
  // Differences of doubles have exact signs, and so have their convex combinations when they are all the same.
  Vec3 low = hull.corners[0].start;
  Vec3 high = low;
  for (std::size_t i = 0; i < static_cast<std::size_t>(hull.size); ++i) {
    const MovingVector& corner = hull.corners[i];
    low = low.cwiseMin(corner.start).cwiseMin(corner.end);
    high = high.cwiseMax(corner.start).cwiseMax(corner.end);
  }
  return (low.array() > 0).any() || (high.array() < 0).any();
}

std::optional<HullContact> first_contact_with_origin(const MovingHull& hull) {
  return Advance(hull).run();
}

}  // namespace lostopos
