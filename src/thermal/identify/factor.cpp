#include "thermal/identify/factor.hpp"

#include <cmath>

namespace arenite::identify {

using statistics::Measured;
using statistics::product;

Factor factor_from_stress(const std::vector<double>& stress, const std::vector<double>& temperature, bool through_origin) {
  const Regression line = regress(stress, temperature, through_origin);
  return {{std::abs(line.slope.value), line.slope.error, line.slope.freedom}, line};
}

Measured stress_over_strain(const Elastic& e) {
  const Measured lateral{1 - e.poisson.value, e.poisson.error, e.poisson.freedom};
  return product({{e.young, 1}, {lateral, -1}});
}

Factor factor_from_strain(const std::vector<double>& strain, const std::vector<double>& temperature, const Elastic& elastic, bool through_origin) {
  Factor f = factor_from_stress(strain, temperature, through_origin);
  f.factor = product({{f.factor, 1}, {stress_over_strain(elastic), -1}});
  return f;
}

Measured factor_from_properties(const Properties& p) { return product({{p.expansion, 1}, {p.temperature, 1}, {p.density, -1}, {p.heat_capacity, -1}}); }

Factor signal_constant(const std::vector<double>& stress, const std::vector<double>& signal, bool through_origin) {
  Factor f = factor_from_stress(stress, signal, through_origin);
  f.factor = product({{f.factor, -1}});
  return f;
}

double printed_correction(const Detector& d) {
  const double ratio = d.reference / d.surface;
  return ratio * ratio;
}

double band_correction(const Detector& d) {
  return radiometry::photon_exitance_slope(d.band, d.reference) / radiometry::photon_exitance_slope(d.band, d.surface);
}

Measured direct_constant(const Detector& d, double correction, const Measured& factor) {
  return product({{d.responsivity, 1}, {{correction}, 1}, {d.amplification, 1}, {d.emissivity, -1}, {factor, -1}});
}

}  // namespace arenite::identify
