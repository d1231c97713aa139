#include <algorithm>
#include <cmath>
#include <map>
#include <ostream>

#include "Base/error.h"
#include "Base/io/atomic_file.h"
#include "Base/io/number_text.h"
#include "Base/lists/erase_repeated.h"
#include "LosTopos/io/fe.h"
#include "LosTopos/mesh/measures.h"

namespace lostopos {
namespace {

using Ends = std::array<std::uint32_t, 2>;

void append_whole(std::string& text, std::int64_t value) {
  base::append_number(text += ' ', value);
}

const DataArray* triangle_array(const SurfaceData& data, std::string_view name) {
  for (const DataArray& array : data.triangle_arrays)
    if (array.name == name && array.components == 1) return &array;
  return nullptr;
}

bool is_tension(double value) {
  return std::isfinite(value) && value >= 0;
}

class FeWriter {
 public:
  FeWriter(std::ostream& out, const SurfaceData& data)
      : out_(out), data_(data), tensions_(triangle_array(data, tension_array)), solid_(triangle_array(data, "solid")) {
    if (tensions_ != nullptr && !std::ranges::all_of(tensions_->values, is_tension))
      throw base::InputError("a tension in the array 'tension' is negative or not finite");
    for (const auto& corners : data.triangles)
      for (std::size_t i = 0; i < 3; ++i) edges_.push_back(ends_of(corners[i], corners[(i + 1) % 3]));
    std::ranges::sort(edges_);
    mark_fixed();
    base::erase_repeated(edges_);
  }

  void write() {
    out_ << "// A surface for Surface Evolver: body n is region n, and region 0, the open air, is none.\n";
    write_vertices();
    write_edges();
    write_facets();
    write_bodies();
  }

 private:
  static Ends ends_of(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

  bool is_solid(std::size_t t) const { return solid_ != nullptr && solid_->values[t] != 0; }

  // Held ones, those of solids, and where films end: edges that are there once.
  void mark_fixed() {
    fixed_.assign(data_.positions.size(), false);
    for (const HeldVertex& held : data_.held) fixed_[held.vertex] = true;
    for (std::size_t t = 0; t < data_.triangles.size(); ++t)
      if (is_solid(t))
        for (const std::uint32_t corner : data_.triangles[t]) fixed_[corner] = true;
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      const bool again = e + 1 < edges_.size() && edges_[e + 1] == edges_[e];
      if (again || (e > 0 && edges_[e - 1] == edges_[e])) continue;
      for (const std::uint32_t end : edges_[e]) fixed_[end] = true;
    }
  }

  // Its number, with a minus where it runs the other way.
  std::int64_t edge(std::uint32_t from, std::uint32_t to) const {
    const auto place = std::ranges::lower_bound(edges_, ends_of(from, to));
    const std::int64_t number = place - edges_.begin() + 1;
    return from < to ? number : -number;
  }

  void write_vertices() {
    out_ << "vertices\n";
    for (std::size_t v = 0; v < data_.positions.size(); ++v) {
      start_line(v + 1);
      for (int i = 0; i < 3; ++i) base::append_number(line_ += ' ', data_.positions[v][i]);
      end_line(fixed_[v] ? " fixed" : "");
    }
  }

  void write_edges() {
    out_ << "edges\n";
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      start_line(e + 1);
      for (const std::uint32_t end : edges_[e]) append_whole(line_, std::int64_t{end} + 1);
      end_line("");
    }
  }

  void write_facets() {
    out_ << "faces\n";
    for (std::size_t t = 0; t < data_.triangles.size(); ++t) {
      start_line(t + 1);
      const auto& corners = data_.triangles[t];
      for (std::size_t i = 0; i < 3; ++i) append_whole(line_, edge(corners[i], corners[(i + 1) % 3]));
      const double tension = is_solid(t) ? 0 : tensions_ != nullptr ? tensions_->values[t] : 1;
      if (tension != 1) base::append_number(line_ += " tension ", tension);
      end_line(is_solid(t) ? " fixed" : "");
    }
  }

  void write_bodies() {
    std::map<Region, std::vector<std::int64_t>> facets;  // ascending, the air left out
    for (std::size_t t = 0; t < data_.triangles.size(); ++t) {
      const auto number = static_cast<std::int64_t>(t + 1);
      const auto& [p, q] = data_.labels[t];
      if (p != air) facets[p].push_back(number);
      if (q != air) facets[q].push_back(-number);
    }
    const std::vector<RegionVolume> volumes = closed_region_volumes(to_mesh(data_));
    out_ << "bodies\n";
    for (const auto& [region, numbers] : facets) {
      start_line(region.index());
      for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (i > 0 && i % facets_a_line == 0) line_ += " \\\n ";
        append_whole(line_, numbers[i]);
      }
      const auto closed = std::ranges::lower_bound(volumes, region, {}, &RegionVolume::region);
      if (closed != volumes.end() && closed->region == region) base::append_number(line_ += " volume ", closed->volume);
      end_line("");
    }
  }

  void start_line(std::size_t number) {
    line_.clear();
    base::append_number(line_, static_cast<std::int64_t>(number));
  }
  void end_line(const char* attribute) { out_ << (line_ += attribute) << '\n'; }

  static constexpr std::size_t facets_a_line = 10;

  std::ostream& out_;
  const SurfaceData& data_;
  const DataArray* tensions_;
  const DataArray* solid_;
  std::vector<Ends> edges_;  // ascending
  std::vector<bool> fixed_;
  std::string line_;
};

}  // namespace

void write_fe(const std::filesystem::path& path, const SurfaceData& data) {
  validate(data);
  base::AtomicFile file(path);
  FeWriter(file.stream(), data).write();
  file.commit();
}

}  // namespace lostopos
