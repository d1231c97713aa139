#include <algorithm>
#include <cmath>

#include "LosTopos/io/read_error.h"
#include "LosTopos/io/rec.h"
#include "LosTopos/io/rec_layout.h"
#include "LosTopos/io/surface_checks.h"

namespace lostopos {
namespace {

using RegionPair = std::pair<Region, Region>;

// The region pairs (p < q) that have a triangle at each vertex: ascending, each once.
class PairsAtVertices {
 public:
  explicit PairsAtVertices(const SurfaceData& data, std::uint64_t vertex_count) : first_(vertex_count + 1, 0) {
    for (const auto& corners : data.triangles)
      for (const std::uint32_t corner : corners) ++first_[corner + 1];
    for (std::size_t v = 0; v < vertex_count; ++v) first_[v + 1] += first_[v];
    pairs_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t t = 0; t < data.triangles.size(); ++t) {
      const auto [p, q] = data.labels[t];
      for (const std::uint32_t corner : data.triangles[t]) pairs_[next[corner]++] = {std::min(p, q), std::max(p, q)};
    }
    for (std::size_t v = 0; v < vertex_count; ++v) std::ranges::sort(at(v));
  }

  /// With repetitions.
  std::span<RegionPair> at(std::size_t v) { return std::span(pairs_).subspan(first_[v], first_[v + 1] - first_[v]); }

 private:
  std::vector<std::size_t> first_;
  std::vector<RegionPair> pairs_;
};

class RecReader {
 public:
  explicit RecReader(const std::filesystem::path& path) : bytes_(path), layout_(find_rec_layout(bytes_)) {}

  // The triangles come before the vertices here: they say which circulations to keep.
  SurfaceData read() {
    reject(vertex_count_problem(layout_.vertices));
    reject(triangle_count_problem(layout_.triangles));
    read_triangles();
    data_.positions.reserve(layout_.vertices);
    bytes_.seek(layout_.vertices_at);
    if (layout_.flavour == RecFlavour::Tracker) {
      for (std::uint64_t v = 0; v < layout_.vertices; ++v) data_.positions.push_back(read_position("vertex", v));
    } else {
      data_.declared_regions = static_cast<std::uint32_t>(layout_.regions);
      read_vertices_with_circulation();
      read_held();
    }
    require_edges_in_range(data_, bytes_.name());
    return std::move(data_);
  }

 private:
  void read_triangles() {
    bytes_.seek(layout_.triangles_at);
    data_.triangles.reserve(layout_.triangles);
    data_.labels.reserve(layout_.triangles);
    for (std::uint64_t t = 0; t < layout_.triangles; ++t) {
      record_ = bytes_.position();
      std::array<std::int64_t, 3> corners{};
      for (std::int64_t& corner : corners) corner = static_cast<std::int64_t>(bytes_.read<std::uint64_t>());
      const auto p = bytes_.read<std::int32_t>(), q = bytes_.read<std::int32_t>();
      reject(corner_problem(corners, layout_.vertices), "triangle", t);
      reject(label_problem(p, q), "triangle", t);
      if (layout_.flavour == RecFlavour::SoapFilm && static_cast<std::uint64_t>(std::max(p, q)) >= layout_.regions)
        reject("label " + std::to_string(std::max(p, q)) + ", but the file declares regions 0 to " +
                   std::to_string(static_cast<std::int64_t>(layout_.regions) - 1),
               "triangle", t);
      data_.triangles.push_back(checked_corners(corners));
      data_.labels.push_back(checked_labels(p, q));
    }
  }

  Vec3 read_position(const char* element, std::uint64_t number) {
    record_ = bytes_.position();
    Vec3 position;
    for (int i = 0; i < 3; ++i) position[i] = bytes_.read<double>();
    reject(position_problem(position), element, number);
    return position;
  }

  void read_vertices_with_circulation() {
    PairsAtVertices pairs(data_, layout_.vertices);
    PairArray& array = data_.pair_arrays.emplace_back();
    array.name = rec_pair_array;
    array.offsets.reserve(layout_.vertices + 1);
    array.offsets.push_back(0);
    for (std::uint64_t v = 0; v < layout_.vertices; ++v) {
      data_.positions.push_back(read_position("vertex", v));
      read_circulation(v, pairs.at(v), array.values);
      array.offsets.push_back(array.values.size());
    }
  }

  // One vertex' n × n block, of which the part above the diagonal counts. `meet`: the pairs there, ascending.
  void read_circulation(std::uint64_t vertex, std::span<const RegionPair> meet, std::vector<PairValue>& values) {
    auto next_meeting = meet.begin();
    for (std::uint64_t i = 0; i < layout_.regions; ++i) {
      bytes_.skip((i + 1) * sizeof(double));
      for (std::uint64_t j = i + 1; j < layout_.regions; ++j) {
        record_ = bytes_.position();
        const auto value = bytes_.read<double>();
        const RegionPair pair{Region{i}, Region{j}};
        const bool meets = next_meeting != meet.end() && *next_meeting == pair;
        while (next_meeting != meet.end() && *next_meeting == pair) ++next_meeting;
        if (value == 0.0 && !meets) continue;
        if (!std::isfinite(value))
          reject("the circulation of regions " + std::to_string(i) + " and " + std::to_string(j) + " is not finite",
                 "vertex", vertex);
        values.push_back({pair.first, pair.second, value});
      }
    }
  }

  void read_held() {
    bytes_.seek(layout_.held_at);
    data_.held.reserve(layout_.held);
    for (std::uint64_t i = 0; i < layout_.held; ++i) {
      record_ = bytes_.position();
      const auto vertex = bytes_.read<std::uint64_t>();
      if (vertex >= layout_.vertices)
        reject("it names vertex " + std::to_string(vertex) + " of " + std::to_string(layout_.vertices), "held vertex",
               i);
      const Vec3 position = read_position("held vertex", i);
      data_.held.push_back({static_cast<std::uint32_t>(vertex), position});
    }
  }

  void reject(const std::string& problem) const {
    if (!problem.empty()) throw_at_byte(bytes_.name(), record_, problem);
  }
  void reject(const std::string& problem, const char* element, std::uint64_t number) const {
    if (!problem.empty()) reject(std::string(element) + " " + std::to_string(number) + ": " + problem);
  }

  ByteReader bytes_;
  RecLayout layout_;
  SurfaceData data_;
  std::uint64_t record_ = 0;  // where the present record starts
};

}  // namespace

SurfaceData read_rec(const std::filesystem::path& path) {
  return RecReader(path).read();
}

}  // namespace lostopos
