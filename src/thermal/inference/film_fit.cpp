#include "thermal/inference/film_fit.hpp"

#include <cmath>
#include <limits>

#include "model/lockin_maps.hpp"

namespace arenite::inference {

FitMaps fit_maps(const FilmResult& film) {
  constexpr float none = std::numeric_limits<float>::quiet_NaN();
  const std::vector<float>&fitted = film.fit.picture, &in_phase = film.maps.in_phase;
  FitMaps maps;
  if (fitted.empty() || fitted.size() != in_phase.size()) return maps;
  const auto full = static_cast<float>(to_peak_to_peak(film.maps.convention));
  for (std::size_t k = 0; k < fitted.size(); ++k) {
    const bool known = std::isfinite(fitted[k]) && std::isfinite(in_phase[k]);
    maps.measured.push_back(known ? full * in_phase[k] : none);
    maps.fitted.push_back(known ? fitted[k] : none);
    maps.residual.push_back(maps.measured.back() - maps.fitted.back());
  }
  return maps;
}

double root_mean_square(const std::vector<float>& map) {
  double squares = 0;
  std::size_t count = 0;
  for (const float value : map)
    if (std::isfinite(value)) squares += static_cast<double>(value) * static_cast<double>(value), ++count;
  return count > 0 ? std::sqrt(squares / static_cast<double>(count)) : statistics::unknown;
}

}  // namespace arenite::inference
