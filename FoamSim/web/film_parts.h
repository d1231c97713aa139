#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "LosTopos/io/surface_data.h"

namespace foamsim::web {

/// Films of a surface: triangles between the same two regions that are joined by edges of just two triangles.
struct FilmParts {
  static constexpr std::uint32_t none = 0xffffffff;

  struct Film {
    std::uint32_t low, high;  ///< its regions
    double area;              ///< L²
  };

  std::vector<Film> films;
  std::vector<std::uint32_t> film;                    ///< by triangle; none for a solid's
  std::vector<std::array<std::uint32_t, 2>> borders;  ///< edges of more than two films' triangles, ascending
  std::vector<std::uint32_t> inner_film;              ///< by vertex: the film it is inside of, none elsewhere
};

/// Triangles whose array "solid" is not 0 belong to no film.
FilmParts find_films(const lostopos::SurfaceData& surface);

/// Twice the triangle's area times its normal, L².
lostopos::Vec3 doubled_area_vector(const lostopos::SurfaceData& surface, std::size_t triangle);

}  // namespace foamsim::web
