#include "Base/error.h"
#include "Base/io/atomic_file.h"
#include "LosTopos/io/byte_order.h"
#include "LosTopos/io/rec.h"

namespace lostopos {
namespace {

class RecWriter {
 public:
  RecWriter(std::ostream& out, const SurfaceData& data, RecFlavour flavour)
      : out_(out), data_(data), regions_(flavour == RecFlavour::SoapFilm ? region_count(data) : 0), flavour_(flavour) {}

  void write() {
    if (flavour_ == RecFlavour::SoapFilm) put_count(regions_);
    put_count(data_.positions.size());
    for (std::size_t v = 0; v < data_.positions.size(); ++v) {
      put_position(data_.positions[v]);
      if (flavour_ == RecFlavour::SoapFilm) put_circulation(v);
    }
    put_count(data_.triangles.size());
    for (std::size_t t = 0; t < data_.triangles.size(); ++t) {
      for (const std::uint32_t corner : data_.triangles[t]) append_bytes(record_, std::uint64_t{corner});
      append_bytes(record_, static_cast<std::int32_t>(data_.labels[t].p.index()));
      append_bytes(record_, static_cast<std::int32_t>(data_.labels[t].q.index()));
      flush();
    }
    if (flavour_ == RecFlavour::SoapFilm) put_held();
  }

 private:
  void put_count(std::uint64_t count) {
    append_bytes(record_, count);
    flush();
  }

  void put_position(const Vec3& position) {
    for (int i = 0; i < 3; ++i) append_bytes(record_, position[i]);
    flush();
  }

  // Row by row: a whole block may not fit into memory.
  void put_circulation(std::size_t v) {
    const std::span<const PairValue> values = pairs_ == nullptr ? std::span<const PairValue>() : pairs_->at(v);
    auto next = values.begin();
    for (std::uint32_t i = 0; i < regions_; ++i) {
      for (std::uint32_t j = 0; j < regions_; ++j) {
        const bool here = next != values.end() && next->p.index() == i && next->q.index() == j;
        append_bytes(record_, here ? next->value : 0.0);
        if (here) ++next;
      }
      flush();
    }
  }

  void put_held() {
    put_count(data_.held.size());
    for (const HeldVertex& held : data_.held) {
      append_bytes(record_, std::uint64_t{held.vertex});
      put_position(held.position);
    }
  }

  void flush() {
    out_ << record_;
    record_.clear();
  }

  std::ostream& out_;
  const SurfaceData& data_;
  std::uint32_t regions_;
  const PairArray* pairs_ = find_pair_array(data_, rec_pair_array);  // null: zeros are written
  RecFlavour flavour_;
  std::string record_;
};

void require_affordable(const SurfaceData& data) {
  const double regions = region_count(data);
  const double bytes = static_cast<double>(data.positions.size()) * regions * regions * sizeof(double);
  if (bytes > largest_rec_bytes)
    throw base::InputError("a .rec file would take " + std::to_string(static_cast<std::uint64_t>(bytes / 0x1p30)) +
                           " GiB, since it has a number for every pair of the " + std::to_string(region_count(data)) +
                           " regions at every vertex; choose another format");
}

}  // namespace

void write_rec(const std::filesystem::path& path, const SurfaceData& data, RecFlavour flavour) {
  validate(data);
  if (flavour == RecFlavour::SoapFilm) require_affordable(data);
  base::AtomicFile file(path);
  RecWriter(file.stream(), data, flavour).write();
  file.commit();
}

}  // namespace lostopos
