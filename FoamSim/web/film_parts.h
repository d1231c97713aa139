#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "LosTopos/io/surface_data.h"

namespace foamsim::web {

/// Films of a surface, those of `lostopos::film_numbers`.
struct FilmParts {
  static constexpr std::uint32_t none = 0xffffffff;

  std::size_t films = 0;
  std::vector<std::uint32_t> film;                    ///< by triangle; none for a solid's
  std::vector<std::array<std::uint32_t, 2>> borders;  ///< Plateau borders' edges, ascending
  std::vector<std::uint32_t> inner_film;              ///< by vertex: the film it is inside of, none elsewhere
};

/// `solid` by triangle: not zero for those that belong to no film.
FilmParts find_films(const lostopos::SurfaceData& surface, const std::vector<std::uint8_t>& solid);

}  // namespace foamsim::web
