#include "tests/fuzz/harnesses.h"

#include <array>

namespace fuzz {

std::span<const Harness> harnesses() {
  static constexpr std::array<Harness, 15> all{{{"ply", feed_ply},
                                                {"obj", feed_obj},
                                                {"rec", feed_rec},
                                                {"arec", feed_arec},
                                                {"vtp", feed_vtp},
                                                {"vtu", feed_vtu},
                                                {"fe", feed_fe},
                                                {"pvd", feed_pvd},
                                                {"toml", feed_toml},
                                                {"grid", feed_grid},
                                                {"options", feed_options},
                                                {"tracker_options", feed_tracker_options},
                                                {"checkpoint_file", feed_checkpoint_file},
                                                {"checkpoint", feed_checkpoint},
                                                {"tracker_checkpoint", feed_tracker_checkpoint}}};
  return all;
}

}  // namespace fuzz
