#include "FoamSim/conservative/near_field.h"

#include <algorithm>

#include "Base/parallel/for_each.h"

namespace foamsim {

using lostopos::Vec3;

namespace {

bool next_to_border(const FilmConnectivity& films, std::size_t v) {
  for (std::uint32_t corner : films.around(v))
    for (std::uint32_t w : films.corners[corner / 3])
      if (films.first_sheet[w + 1] - films.first_sheet[w] != 1) return true;
  return false;
}

}  // namespace

void NearField::add_potential(const FilmConnectivity& films, const FilmShape& shape, std::span<const Vec3> strength,
                              std::span<Vec3> potential) {
  if (delta_ == 0) return;
  mean_.assign(films.sheet_count(), Vec3::Zero());
  slope_.assign(films.sheet_count(), 0.0);
  base::parallel_for_each(films.vertex_slots(), film_grain, [&](std::size_t v) {
    if (next_to_border(films, v)) return;
    for (std::uint32_t corner : films.around(v)) {
      const std::uint32_t sheet = films.sheets[corner / 3][corner % 3];
      mean_[sheet] += strength[corner / 3] / 3;
      slope_[sheet] += shape.area[corner / 3] / 3;
    }
    for (std::size_t sheet = films.first_sheet[v]; sheet < films.first_sheet[v + 1]; ++sheet) {
      const double area = slope_[sheet];
      mean_[sheet] /= std::max(area, least_area_);
      slope_[sheet] = area > least_area_ ? -mean_[sheet].squaredNorm() : 0.0;
    }
  });
  base::parallel_for_each(films.corners.size(), film_grain, [&](std::size_t t) {
    const auto& [a, b, c] = films.sheets[t];
    potential[t] += delta_ / 6 * (mean_[a] + mean_[b] + mean_[c]);
  });
}

double NearField::area_slope(const FilmConnectivity& films, std::size_t t) const {
  if (delta_ == 0) return 0;
  const auto& [a, b, c] = films.sheets[t];
  return delta_ / 12 * (slope_[a] + slope_[b] + slope_[c]);
}

}  // namespace foamsim
