#pragma once

#include <span>
#include <vector>

#include "LosTopos/collision/contact.h"
#include "LosTopos/collision/motion.h"
#include "LosTopos/collision/safe_move.h"

namespace lostopos {

/// Groups of vertices that collide with each other, directly or through others, during the attempt to make one motion
/// safe. Zones only grow. Held vertices do not join zones, for nothing is passed on through them.
class ImpactZones {
 public:
  explicit ImpactZones(Motion& motion) : motion_(motion) {}

  /// Adds the contacts, joins the zones they connect, and solves every zone that has a new one for all its contacts.
  /// Counts in `statistics`. Returns whether a motion has been changed.
  bool solve_inelastic(std::span<const Contact> contacts, MoveStatistics& statistics);

  /// Joins zones likewise, and lets every zone that has a new contact move as a rigid body from now on. Returns whether
  /// anything is new: false when all contacts lie within zones that are rigid already.
  bool make_rigid(std::span<const Contact> contacts, MoveStatistics& statistics);

 private:
  struct Zone {
    std::vector<Contact> contacts;
    std::vector<Vertex> vertices;  // free ones, and the held ones that it has met
    std::size_t free_count = 0;
    bool rigid = false;
  };
  using ZoneIndex = std::uint32_t;

  ZoneIndex zone_of(Vertex v);
  ZoneIndex join(const Contact& contact);
  ZoneIndex merge(ZoneIndex a, ZoneIndex b);
  std::vector<ZoneIndex> take_in(std::span<const Contact> contacts);

  Motion& motion_;
  std::vector<ZoneIndex> zone_of_vertex_;
  std::vector<Zone> zones_;
};

}  // namespace lostopos
