#include "LosTopos/collision/broad_phase.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "LosTopos/collision/box_overlap.h"
#include "LosTopos/collision/grid_cell.h"
#include "LosTopos/collision/rounded_box.h"

namespace lostopos {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
constexpr double infinity = std::numeric_limits<double>::infinity();

// Levels of cells, each twice the size of the one before; `base_level` suits the median box.
constexpr int level_count = 64;
constexpr int base_level = 24;
// The base level also takes boxes down to 1/8 of what it could take, and so on below: few levels for a query to visit.
constexpr int levels_per_small_step = 3;
// Cells of the base level over the median extent: a query then reads some five cells of a dozen triangles each.
constexpr double cell_per_median_extent = 2.5;

// Not less than the exact extent.
double largest_extent(const Box& box) {
  return std::nextafter((box.high - box.low).maxCoeff(), infinity);
}

}  // namespace

// A hashed grid with levels. A box is kept in one cell only, that of its low corner, on a level whose cells are at
// least twice its size (but for the last level); a query looks at the cells that low corners of boxes which reach it
// can be in. What a cell holds lies together in memory, in single precision rounded outwards, so that most boxes are
// dismissed, or found, without looking at their slot: what a build finds in one piece, and what comes later where
// something has gone or in chunks behind, until there is so much of it that everything is laid out anew. Cells whose
// hashes coincide share a place, which costs time, not correctness, for every box found is tested.
struct BroadPhase::Grid {
  struct Slot {
    Box box;
    std::uint32_t next_in_level = none, previous_in_level = none;  ///< in no particular order
    std::uint32_t bucket = none;                                   ///< none: the triangle is not held
    std::uint32_t entry = none;
    std::int32_t level = 0;
  };
  // Of a bucket; its entries end where the next one's begin.
  struct Cell {
    std::uint32_t first_entry = 0;
    std::uint32_t chunk = none;  ///< the last one added; none: there is none
  };
  struct Level {
    std::size_t count = 0;
    std::uint32_t first = none;
    double largest_extent = 0;  ///< of the boxes it has held since it was last empty
    double inverse_cell = 0;
  };
  // What is laid out, by bucket, and then chunks of entries that came later, each with its predecessor in its bucket.
  static constexpr std::uint32_t chunk_size = 4;
  static constexpr int most_looked_at = 64;  ///< entries, for a free one: a crowded bucket would cost too much

  std::vector<Slot> slots;
  std::vector<RoundedBox> entries;  ///< with the numbers of their slots
  std::vector<Cell> cells{1};       ///< of each bucket, and one more, the end of the last
  std::vector<std::uint32_t> chunk_before;
  std::array<Level, level_count> levels;
  double base_extent = 0;  ///< the largest box of the base level
  std::size_t held = 0;

  std::size_t buckets() const { return cells.size() - 1; }
  bool holds(std::uint32_t slot) const { return slot < slots.size() && slots[slot].bucket != none; }
  std::uint32_t laid_out() const { return cells.back().first_entry; }
  std::uint32_t first_of_chunk(std::uint32_t chunk) const { return laid_out() + chunk_size * chunk; }
  std::size_t most_in_chunks() const { return 64 + held / 2; }
  bool is_scattered() const { return entries.size() - laid_out() > most_in_chunks(); }

  int level_of(double extent) const {
    const double ratio = extent / base_extent;
    if (!(ratio < 0x1p+39)) return level_count - 1;
    if (ratio <= 0x1p-24) return 0;
    int up = std::ilogb(ratio);
    if (std::ldexp(1.0, up) < ratio) ++up;  // rounded up
    if (up < 0) up = -(-up / levels_per_small_step) * levels_per_small_step;
    return std::clamp(base_level + up, 0, level_count - 1);
  }

  std::uint32_t bucket_of(int level, const Vec3& low) const {
    const double inverse_cell = levels[static_cast<std::size_t>(level)].inverse_cell;
    return static_cast<std::uint32_t>(cell_hash(level, cell_coordinate(low[0], inverse_cell),
                                                cell_coordinate(low[1], inverse_cell),
                                                cell_coordinate(low[2], inverse_cell)) &
                                      (buckets() - 1));
  }

  // Finds the slot's level and bucket, and counts it there.
  void assign(std::uint32_t index) {
    Slot& slot = slots[index];
    const double extent = largest_extent(slot.box);
    slot.level = level_of(extent);
    Level& level = levels[static_cast<std::size_t>(slot.level)];
    level.largest_extent = level.count == 0 ? extent : std::max(level.largest_extent, extent);
    ++level.count;
    slot.bucket = bucket_of(slot.level, slot.box.low);
    slot.entry = none;
    slot.previous_in_level = none;
    slot.next_in_level = std::exchange(level.first, index);
    if (slot.next_in_level != none) slots[slot.next_in_level].previous_in_level = index;
    ++held;
  }

  // Calls do_with(first, end) for every run of the bucket's entries, the latest chunk first, until it returns true.
  template <class Do>
  void for_runs(std::size_t bucket, const Do& do_with) const {
    for (std::uint32_t chunk = cells[bucket].chunk; chunk != none; chunk = chunk_before[chunk])
      if (do_with(first_of_chunk(chunk), first_of_chunk(chunk + 1))) return;
    do_with(cells[bucket].first_entry, cells[bucket + 1].first_entry);
  }

  // One that something has left, or of a new chunk.
  std::uint32_t free_entry(std::uint32_t bucket) {
    std::uint32_t found = none;
    int left = most_looked_at;
    for_runs(bucket, [&](std::uint32_t first, std::uint32_t end) {
      for (std::uint32_t i = first; i < end && found == none && left > 0; ++i, --left)
        if (entries[i].is_clear()) found = i;
      return found != none || left == 0;
    });
    if (found != none) return found;
    const auto chunk = static_cast<std::uint32_t>(chunk_before.size());
    chunk_before.push_back(std::exchange(cells[bucket].chunk, chunk));
    entries.resize(entries.size() + chunk_size);
    return first_of_chunk(chunk);
  }

  void link(std::uint32_t index) {
    assign(index);
    Slot& slot = slots[index];
    slot.entry = free_entry(slot.bucket);
    entries[slot.entry] = RoundedBox(slot.box, index);
  }

  void unlink(std::uint32_t index) {
    Slot& slot = slots[index];
    entries[slot.entry].clear();
    Level& level = levels[static_cast<std::size_t>(slot.level)];
    (slot.previous_in_level == none ? level.first : slots[slot.previous_in_level].next_in_level) = slot.next_in_level;
    if (slot.next_in_level != none) slots[slot.next_in_level].previous_in_level = slot.previous_in_level;
    slot.bucket = none;
    --level.count;
    --held;
  }

  // A box that stays in its cell is changed in place.
  bool change_in_place(std::uint32_t index, const Box& box) {
    Slot& slot = slots[index];
    const double extent = largest_extent(box);
    if (level_of(extent) != slot.level || bucket_of(slot.level, box.low) != slot.bucket) return false;
    Level& level = levels[static_cast<std::size_t>(slot.level)];
    level.largest_extent = std::max(level.largest_extent, extent);
    slot.box = box;
    entries[slot.entry].enclose(box);
    return true;
  }

  // Puts all held boxes next to those of the same bucket.
  void lay_out() {
    cells.assign(cells.size(), {});
    chunk_before.clear();
    for (const Slot& slot : slots)
      if (slot.bucket != none) ++cells[slot.bucket + 1].first_entry;
    for (std::size_t i = 1; i < cells.size(); ++i) cells[i].first_entry += cells[i - 1].first_entry;
    entries.reserve(held + most_in_chunks());
    entries.resize(held);
    // From behind, so that within a bucket slots rise.
    for (std::uint32_t i = static_cast<std::uint32_t>(slots.size()); i-- > 0;) {
      Slot& slot = slots[i];
      if (slot.bucket == none) continue;
      slot.entry = --cells[slot.bucket + 1].first_entry;
      entries[slot.entry] = RoundedBox(slot.box, i);
    }
    // Each bucket's first entry stands in the place of the next one's now.
    for (std::size_t i = 0; i + 1 < cells.size(); ++i) cells[i].first_entry = cells[i + 1].first_entry;
    cells.back().first_entry = static_cast<std::uint32_t>(held);
  }

  // Sizes cells after the median of the held boxes (with `more` to come), and links them all anew.
  void rebuild(std::size_t more) {
    std::vector<double> extents;
    extents.reserve(held);
    for (const Slot& slot : slots) {
      if (slot.bucket != none) extents.push_back(largest_extent(slot.box));
    }
    base_extent = 1;
    if (!extents.empty()) {
      const auto middle = extents.begin() + static_cast<std::ptrdiff_t>(extents.size() / 2);
      std::nth_element(extents.begin(), middle, extents.end());
      base_extent = std::clamp(*middle * cell_per_median_extent / 2, 0x1p-900, 0x1p+900);
    }
    for (int i = 0; i < level_count; ++i) {
      levels[static_cast<std::size_t>(i)] = {0, none, 0, 1 / (2 * std::ldexp(base_extent, i - base_level))};
    }
    std::size_t size = 64;
    while (size < held + more) size *= 2;
    cells.assign(size + 1, {});
    held = 0;
    for (std::uint32_t i = static_cast<std::uint32_t>(slots.size()); i-- > 0;) {
      if (slots[i].bucket != none) assign(i);
    }
    lay_out();
  }

  void append_bucket(std::size_t bucket, const BoxQuery& query, std::vector<Triangle>& found) const {
    for_runs(bucket, [&](std::uint32_t first, std::uint32_t end) {
      for (std::uint32_t i = first; i < end; ++i) {
        const RoundedBox& entry = entries[i];
        if (!query.may_meet(entry)) continue;
        if (query.surely_meets(entry) || overlap(slots[entry.number()].box, query.box()))
          found.emplace_back(entry.number());
      }
      return false;
    });
  }

  void append_level(int index, const BoxQuery& query, std::vector<Triangle>& found) const {
    const Box& box = query.box();
    const Level& level = levels[static_cast<std::size_t>(index)];
    std::array<std::int64_t, 3> from, to;
    double reached = 1;
    for (int i = 0; i < 3; ++i) {
      const auto axis = static_cast<std::size_t>(i);
      // Rounding is monotone, so no low corner of a box that reaches the query is in a cell before this one.
      from[axis] = cell_coordinate(box.low[i] - level.largest_extent, level.inverse_cell);
      to[axis] = cell_coordinate(box.high[i], level.inverse_cell);
      reached *= static_cast<double>(to[axis] - from[axis]) + 1;
    }
    if (reached >= static_cast<double>(level.count)) {
      for (std::uint32_t i = level.first; i != none; i = slots[i].next_in_level) {
        if (overlap(slots[i].box, box)) found.push_back(Triangle(i));
      }
      return;
    }
    // Cells are far apart in memory: what is needed next is asked for some cells ahead.
    constexpr std::size_t most_ahead = 16;
    std::array<std::size_t, most_ahead> ahead;
    std::size_t count = 0;
    const std::size_t mask = buckets() - 1;
    for (std::int64_t x = from[0]; x <= to[0]; ++x) {
      for (std::int64_t y = from[1]; y <= to[1]; ++y) {
        for (std::int64_t z = from[2]; z <= to[2]; ++z) {
          ahead[count] = cell_hash(index, x, y, z) & mask;
          __builtin_prefetch(&cells[ahead[count]]);
          if (++count == most_ahead) append_buckets({ahead.data(), std::exchange(count, 0)}, query, found);
        }
      }
    }
    append_buckets({ahead.data(), count}, query, found);
  }

  void append_buckets(std::span<const std::size_t> some, const BoxQuery& query, std::vector<Triangle>& found) const {
    for (std::size_t bucket : some) {
      __builtin_prefetch(entries.data() + cells[bucket].first_entry);
      if (const std::uint32_t chunk = cells[bucket].chunk; chunk != none)
        __builtin_prefetch(entries.data() + first_of_chunk(chunk));
    }
    for (std::size_t bucket : some) append_bucket(bucket, query, found);
  }
};

BroadPhase::BroadPhase() : grid_(std::make_unique<Grid>()) {}
BroadPhase::BroadPhase(BroadPhase&&) noexcept = default;
BroadPhase& BroadPhase::operator=(BroadPhase&&) noexcept = default;
BroadPhase::~BroadPhase() = default;

void BroadPhase::build(const SurfaceMesh& mesh, std::span<const Vec3> from, std::span<const Vec3> to, double margin) {
  Grid& grid = *grid_;
  grid.slots.assign(mesh.triangle_slots(), {});
  grid.held = 0;
  for (Triangle t : mesh.triangles()) {
    Box box = triangle_box(mesh, t, from, margin);
    if (from.data() != to.data()) {
      const Box end = triangle_box(mesh, t, to, margin);
      box = {box.low.cwiseMin(end.low), box.high.cwiseMax(end.high)};
    }
    grid.slots[t.index()].box = box;
    grid.slots[t.index()].bucket = 0;  // to be linked
    ++grid.held;
  }
  grid.rebuild(0);
}

void BroadPhase::set(Triangle t, const Box& box) {
  Grid& grid = *grid_;
  if (t.index() >= grid.slots.size()) grid.slots.resize(t.index() + std::size_t{1});
  if (grid.holds(t.index())) {
    if (grid.change_in_place(t.index(), box)) return;
    grid.unlink(t.index());
  }
  // Doubling keeps the cost of it constant for each triangle taken in, and so does waiting for a share of the boxes.
  if (grid.buckets() <= grid.held || grid.is_scattered()) grid.rebuild(grid.held + 1);
  grid.slots[t.index()].box = box;
  grid.link(t.index());
}

void BroadPhase::remove(Triangle t) {
  if (grid_->holds(t.index())) grid_->unlink(t.index());
}

void BroadPhase::query_unsorted(const Box& box, std::vector<Triangle>& found) const {
  const BoxQuery query(box);
  for (int level = 0; level < level_count; ++level) {
    if (grid_->levels[static_cast<std::size_t>(level)].count > 0) grid_->append_level(level, query, found);
  }
}

void BroadPhase::query(const Box& box, std::vector<Triangle>& found) const {
  const auto before = static_cast<std::ptrdiff_t>(found.size());
  query_unsorted(box, found);
  std::sort(found.begin() + before, found.end());
  found.erase(std::unique(found.begin() + before, found.end()), found.end());
}

const Box& BroadPhase::box(Triangle t) const {
  return grid_->slots[t.index()].box;
}

std::size_t BroadPhase::memory_bytes() const {
  return sizeof(Grid) + grid_->slots.capacity() * sizeof(Grid::Slot) + grid_->entries.capacity() * sizeof(RoundedBox) +
         grid_->cells.capacity() * sizeof(Grid::Cell) + grid_->chunk_before.capacity() * sizeof(std::uint32_t);
}

Box triangle_box(const SurfaceMesh& mesh, Triangle t, std::span<const Vec3> positions, double margin) {
  const auto& [a, b, c] = mesh.vertices(t);
  const Vec3& pa = positions[a.index()];
  const Vec3& pb = positions[b.index()];
  const Vec3& pc = positions[c.index()];
  return {(pa.cwiseMin(pb).cwiseMin(pc).array() - margin).matrix(),
          (pa.cwiseMax(pb).cwiseMax(pc).array() + margin).matrix()};
}

}  // namespace lostopos
