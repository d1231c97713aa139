#include "LosTopos/collision/impact_zones.h"

#include <algorithm>
#include <limits>

#include "Base/lists/erase_repeated.h"
#include "LosTopos/collision/rigid_motion.h"
#include "LosTopos/collision/zone_solver.h"

namespace lostopos {
namespace {

constexpr std::uint32_t no_zone = std::numeric_limits<std::uint32_t>::max();

template <class T>
void move_to_end(std::vector<T>& to, std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
  from = {};
}

}  // namespace

ImpactZones::ZoneIndex ImpactZones::zone_of(Vertex v) {
  ZoneIndex& zone = zone_of_vertex_[v.index()];
  if (zone == no_zone) {
    zone = static_cast<ZoneIndex>(zones_.size());
    zones_.push_back({{}, {v}, 1, false});
  }
  return zone;
}

ImpactZones::ZoneIndex ImpactZones::merge(ZoneIndex a, ZoneIndex b) {
  if (a == b) return a;
  if (zones_[a].vertices.size() < zones_[b].vertices.size()) std::swap(a, b);
  for (Vertex v : zones_[b].vertices) {
    if (!motion_.held(v)) zone_of_vertex_[v.index()] = a;
  }
  move_to_end(zones_[a].vertices, zones_[b].vertices);
  move_to_end(zones_[a].contacts, zones_[b].contacts);
  zones_[a].free_count += zones_[b].free_count;
  zones_[a].rigid = false;  // as a whole
  return a;
}

// The zone of all its free vertices; no_zone when it has none.
ImpactZones::ZoneIndex ImpactZones::join(const Contact& contact) {
  ZoneIndex zone = no_zone;
  for (Vertex v : contact.pair.vertices) {
    if (motion_.held(v)) continue;
    zone = zone == no_zone ? zone_of(v) : merge(zone, zone_of(v));
  }
  if (zone == no_zone) return zone;
  for (Vertex v : contact.pair.vertices) {
    auto& vertices = zones_[zone].vertices;
    if (!motion_.held(v) || std::ranges::find(vertices, v) != vertices.end()) continue;
    vertices.push_back(v);
    zones_[zone].rigid = false;  // it has someone to follow now
  }
  zones_[zone].contacts.push_back(contact);
  return zone;
}

// Returns the zones that have a new contact, each once, ascending.
std::vector<ImpactZones::ZoneIndex> ImpactZones::take_in(std::span<const Contact> contacts) {
  if (zone_of_vertex_.empty()) zone_of_vertex_.assign(motion_.ends().size(), no_zone);
  for (const Contact& contact : contacts) join(contact);
  std::vector<ZoneIndex> touched;
  for (const Contact& contact : contacts) {
    for (Vertex v : contact.pair.vertices) {
      if (!motion_.held(v)) touched.push_back(zone_of(v));
    }
  }
  base::sort_unique(touched);
  return touched;
}

bool ImpactZones::solve_inelastic(std::span<const Contact> contacts, MoveStatistics& statistics) {
  bool changed = false;
  for (ZoneIndex index : take_in(contacts)) {
    changed |= solve_contacts(motion_, zones_[index].contacts);
    ++statistics.inelastic_zones;
    statistics.largest_zone = std::max(statistics.largest_zone, zones_[index].free_count);
  }
  return changed;
}

bool ImpactZones::make_rigid(std::span<const Contact> contacts, MoveStatistics& statistics) {
  bool changed = false;
  for (ZoneIndex index : take_in(contacts)) {
    Zone& zone = zones_[index];
    statistics.largest_zone = std::max(statistics.largest_zone, zone.free_count);
    if (zone.rigid) continue;
    zone.rigid = true;
    changed = true;
    ++statistics.rigid_zones;
    move_rigidly(motion_, zone.vertices);
  }
  return changed;
}

}  // namespace lostopos
