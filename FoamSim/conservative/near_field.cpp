#include "FoamSim/conservative/near_field.h"

#include <algorithm>

#include "Base/parallel/for_each.h"

namespace foamsim {

using lostopos::Vec3;

namespace {

constexpr double more = 0.5;  // how much of S (1 − S) is added to S

}  // namespace

void NearField::add_potential(const FilmConnectivity& films, const FilmShape& shape, std::span<const Vec3> strength,
                              std::span<Vec3> potential) {
  if (delta_ == 0) return;
  find_means(films, shape, strength);
  find_means_of_means(films, shape);
  base::parallel_for_each(films.corners.size(), film_grain, [&](std::size_t t) {
    const auto& [a, b, c] = films.sheets[t];
    const Vec3 again = (second_mean_[a] + second_mean_[b] + second_mean_[c]) / 3;
    potential[t] += delta_ / 2 * ((1 + more) * smooth_[t] - more * again);
  });
}

void NearField::find_means(const FilmConnectivity& films, const FilmShape& shape, std::span<const Vec3> strength) {
  mean_.assign(films.sheet_count(), Vec3::Zero());
  inverse_area_.assign(films.sheet_count(), 0.0);
  base::parallel_for_each(films.vertex_slots(), film_grain, [&](std::size_t v) {
    if (films.inner[v] == 0) return;
    for (std::uint32_t corner : films.around(v)) {
      const std::uint32_t sheet = films.sheets[corner / 3][corner % 3];
      mean_[sheet] += strength[corner / 3] / 3;
      inverse_area_[sheet] += shape.area[corner / 3] / 3;
    }
    for (std::size_t sheet = films.first_sheet[v]; sheet < films.first_sheet[v + 1]; ++sheet) {
      inverse_area_[sheet] = 1 / std::max(inverse_area_[sheet], least_area_);
      mean_[sheet] *= inverse_area_[sheet];
    }
  });
}

void NearField::find_means_of_means(const FilmConnectivity& films, const FilmShape& shape) {
  smooth_.resize(films.corners.size());
  base::parallel_for_each(smooth_.size(), film_grain, [&](std::size_t t) {
    const auto& [a, b, c] = films.sheets[t];
    smooth_[t] = (mean_[a] + mean_[b] + mean_[c]) / 3;
  });
  second_mean_.assign(films.sheet_count(), Vec3::Zero());
  base::parallel_for_each(films.vertex_slots(), film_grain, [&](std::size_t v) {
    for (std::uint32_t corner : films.around(v)) {
      const std::uint32_t sheet = films.sheets[corner / 3][corner % 3];
      second_mean_[sheet] += inverse_area_[sheet] * shape.area[corner / 3] / 3 * smooth_[corner / 3];
    }
  });
}

double NearField::area_slope(const FilmConnectivity& films, std::size_t t) const {
  if (delta_ == 0) return 0;
  double slope = -more * smooth_[t].squaredNorm();
  for (std::size_t sheet : films.sheets[t])
    if (inverse_area_[sheet] * least_area_ < 1)
      slope += mean_[sheet].dot(2 * more * second_mean_[sheet] - (1 + more) * mean_[sheet]) / 3;
  return delta_ / 4 * slope;
}

}  // namespace foamsim
