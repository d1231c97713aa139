#pragma once

#include <optional>
#include <vector>

#include "FoamSim/effects/effect.h"

namespace foamsim {

/// When bubbles burst, and which.
struct BurstSchedule {
  double start = 5;                            ///< of the first, T
  double interval = 10;                        ///< between one and the next, T, > 0
  std::vector<double> times = {};              ///< not empty: these, ascending, in place of the two above
  std::vector<lostopos::Region> regions = {};  ///< not empty: these in turn, one each time, and no more; else at random
  std::uint64_t seed = 0;                      ///< of the choice
};

/// Bubbles burst, one each time, at the start of the first step that begins then or later: their films towards the air
/// break at once, and what they enclosed is air. At random every region with a film towards the air is equally likely;
/// the last one stays. The choice depends on the seed and on how many have burst, not on the library.
class Burst final : public Effect {
 public:
  /// Throws base::InputError for the air, for a region twice, and for fewer times than regions or the other way round.
  explicit Burst(BurstSchedule schedule);
  std::string_view name() const override { return "burst"; }
  bool lets_burst() const override { return true; }
  /// Throws base::InputError for a listed region that the surface does not have.
  void begin(const EffectStep& step) override;
  /// Throws base::Error for a listed region that has no film towards the air any more.
  std::vector<lostopos::Region> bursts(const EffectStep& step) override;
  /// What has burst, and when.
  nlohmann::json state() const override;
  void restore(const nlohmann::json& state) override;

 private:
  struct Done {
    lostopos::Region region;
    double time;  // T
  };
  // Of the n-th burst; nothing: there are no more.
  std::optional<double> time_of(std::size_t n) const;
  // Which of the candidates bursts next.
  lostopos::Region choose(const EffectStep& step, std::vector<lostopos::Region>& candidates) const;

  BurstSchedule schedule_;
  std::vector<Done> done_;
};

}  // namespace foamsim
