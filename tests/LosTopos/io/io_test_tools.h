#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numeric>
#include <sstream>
#include <string>

#include "Base/error.h"
#include "LosTopos/io/byte_order.h"
#include "LosTopos/io/film_faces.h"
#include "LosTopos/io/rec.h"
#include "LosTopos/io/surface_data.h"
#include "tests/support/scratch_folder.h"

namespace lostopos {

/// Each test gets an empty folder of its own, removed afterwards.
class IoTest : public ::testing::Test {
 protected:
  std::filesystem::path path(const std::string& name) const { return folder_ / name; }
  std::filesystem::path write(const std::string& name, const std::string& content) const {
    std::ofstream(path(name), std::ios::binary) << content;
    return path(name);
  }
  std::size_t files_in_folder() const {
    return static_cast<std::size_t>(
        std::distance(std::filesystem::directory_iterator(folder_), std::filesystem::directory_iterator()));
  }

  const ::test::ScratchFolder scratch_;
  const std::filesystem::path folder_ = scratch_.path();
};

inline std::string content_of(const std::filesystem::path& path) {
  std::ostringstream content;
  content << std::ifstream(path, std::ios::binary).rdbuf();
  return content.str();
}

/// The message of the InputError that `action` throws; empty, and a failure, when it throws none.
inline std::string input_error(const std::function<void()>& action) {
  try {
    action();
  } catch (const base::InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << "no InputError was thrown";
  return {};
}

inline void expect_contains(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' is missing in: " << text;
}

/// `text` with `to` in the place of the first `from`, which has to be there.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t place = text.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  return text.replace(place, from.size(), to);
}

/// Bytes of a binary file, number by number.
class Bytes {
 public:
  template <class T>
  Bytes& put(T value) {
    append_bytes(bytes_, value);
    return *this;
  }
  Bytes& text(const std::string& text) {
    bytes_ += text;
    return *this;
  }
  const std::string& str() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Two tetrahedra, regions 1 and 2, that share a face; positions that need all digits; one vertex without triangles.
inline SurfaceData two_tetrahedra() {
  SurfaceData data;
  data.positions = {{0.0, 0.0, 0.0},         {1.0, 0.0, 0.1},   {-0.0, 1.0 / 3.0, 5e-324},
                    {0.1, 0.2, 1.0 + 1e-16}, {0.3, 0.3, -1e40}, {-1e40, 2.2250738585072014e-308, 7}};
  data.triangles = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 0, 4}};
  const Region one{1}, two{2};
  data.labels = {{one, air}, {one, air}, {one, air}, {one, two}, {air, two}, {air, two}, {air, two}};
  return data;
}

/// The same with circulation, held vertices and a region that has no triangles.
inline SurfaceData two_tetrahedra_with_circulation() {
  SurfaceData data = two_tetrahedra();
  data.declared_regions = 4;
  const Region one{1}, two{2}, three{3};
  data.pair_arrays.resize(1);
  data.pair_arrays[0].name = rec_pair_array;
  data.pair_arrays[0].offsets = {0, 3, 6, 9, 10, 11, 12};
  data.pair_arrays[0].values = {{air, one, 0.25}, {air, two, 0.0},  {one, two, 3.0},     {air, one, -1.5},
                                {air, two, 1e-9}, {one, two, -2.0}, {air, one, 0.1},     {air, two, 0.2},
                                {one, two, 0.3},  {air, one, 7.0},  {air, two, 1.0 / 7}, {two, three, 11.0}};
  data.held = {{4, {0.3, 0.3, -1.0}}, {0, {0.0, 1e-17, 2.0}}};
  return data;
}

/// As it is in an OBJ file: film by film, normals out of the higher region.
inline SurfaceData film_by_film(const SurfaceData& data) {
  SurfaceData turned = data;
  const std::vector<std::uint32_t> films = film_numbers(data);
  std::vector<std::size_t> order(films.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, {}, [&films](std::size_t t) { return films[t]; });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto [a, b, c] = data.triangles[order[i]];
    const bool turn = data.labels[order[i]].p < data.labels[order[i]].q;
    turned.triangles[i] = turn ? std::array{a, c, b} : std::array{a, b, c};
    turned.labels[i] = turn ? data.labels[order[i]].flipped() : data.labels[order[i]];
  }
  return turned;
}

/// EXPECTs the same positions (to the bit), triangles and labels.
inline void expect_same_surface(const SurfaceData& a, const SurfaceData& b) {
  ASSERT_EQ(a.positions.size(), b.positions.size());
  for (std::size_t v = 0; v < a.positions.size(); ++v)
    for (int i = 0; i < 3; ++i)
      EXPECT_EQ(std::bit_cast<std::uint64_t>(a.positions[v][i]), std::bit_cast<std::uint64_t>(b.positions[v][i]))
          << "vertex " << v << ", axis " << i;
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.labels, b.labels);
}

}  // namespace lostopos
