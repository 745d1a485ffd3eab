#pragma once
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "model/elasticity/disk_field.hpp"
#include "statistics/measured.hpp"
#include "thermal/radiometry/band.hpp"

namespace arenite::identify {

/// A record of a test as it was measured: y against x, both SI, with the line of the file that each point stands in.
struct Curve {
  std::string file;  ///< for messages
  std::string name;  ///< of the test ("specimen 2"); empty where a file holds one
  std::vector<double> x, y;
  std::vector<int> line;  ///< as long as x and y
};

enum class Branch { loading, unloading };

struct StiffnessOptions {
  double preload =
      1000;  ///< N; only what lies beyond it counts, so that the cylinder does not settle any more (T 2.2.2)
  Branch branch = Branch::loading;
};

/// One loading (or unloading) of a curve: points first to last, both included.
struct Cycle {
  std::size_t first = 0, last = 0;
  double peak = 0;                 ///< greatest force, N, positive
  statistics::Measured stiffness;  ///< N/m
  double r2 = statistics::unknown;
};

/// Contact stiffness k = F/delta (T eq. 2.1) of every cycle of a force-displacement record, x the displacement (m), y
/// the force (N); which sign compression has is found out. k is one over the slope of the displacement against the
/// force, over the points whose force exceeds the preload: the test controls the force, the noise is in the
/// displacement, and points chosen by what the line is drawn against leave its slope unbiased. Cycles are cut at the
/// turning points of the force, changes below 5 % of its range being noise. Throws InputError with file and line if the
/// preload is not reached, a cycle has fewer than five points beyond it, the force falls back in a loading without
/// coming below half of its peak, or the displacement runs back.
std::vector<Cycle> cycles_of(const Curve& curve, const StiffnessOptions& options = {});

using elasticity::effective_radius;
using elasticity::EffectiveRadius;

/// Separation force of a pull-off record, N: the peak of the force y (tension positive) over displacement or time x (T
/// Fig. 2.12). Its error is the scatter of up to ten points before the peak about their straight line, unknown where
/// there are fewer than five. Throws InputError with file and line if the record holds no tension or fewer than three
/// points.
struct PullOff {
  statistics::Measured force;
  bool separated = true;  ///< false where the record ends before the force has fallen to half of its peak
};
PullOff pull_off(const Curve& curve);

/// Surface energy gamma = sqrt(4 k F_c/r_eff), N/m, from the separation force (T eq. 1.25), k of the pair in N/m.
inline statistics::Measured surface_energy(const statistics::Measured& separation_force,
                                           const statistics::Measured& stiffness, double effective_radius) {
  return statistics::product({{{4 / effective_radius}, 0.5}, {stiffness, 0.5}, {separation_force, 0.5}});
}

/// What geometrical adhesion then does at rest.
struct Threshold {
  double force = 0;         ///< F_c = r_eff gamma^2/(4 k): the greatest tension, N
  double overlap = 0;       ///< h_c = r_eff gamma^2/(4 k^2): where it acts, m
  double free_overlap = 0;  ///< h_eq = r_eff gamma^2/k^2: where no force acts, m
};
inline Threshold threshold(double gamma, double k, double radius) {
  const double h = radius * gamma * gamma / (k * k);
  return {0.25 * k * h, 0.25 * h, h};
}

/// A straight line through measured points.
struct Regression {
  statistics::Measured slope,
      intercept;                    ///< the intercept is 0 and without error where the line was held to the origin
  double r2 = statistics::unknown;  ///< share of the variance of y that the line takes (about 0 if held to the origin)
  double correlation = 0;           ///< of neighbouring residuals, 0 where it is not taken into account
};

/// y = intercept + slope x by least squares, y alone in error. Records are often sampled more densely than their noise
/// changes: from 10 points on, a positive correlation r of neighbouring residuals widens the errors by sqrt((1 + r)/(1
/// - r)) and takes degrees of freedom by the same share, as for a first-order autoregressive noise. Needs three points
/// (two through the origin) and an x that varies; otherwise all is unknown.
Regression regress(const std::vector<double>& x, const std::vector<double>& y, bool through_origin = false);

/// The thermoelastic factor A of dT = -A d(sigma_kk) (T eq. 1.55), K/Pa, as the slope of temperature against stress
/// (calculated stress, T 2.3). Both must be of one convention, peak to peak or amplitudes. Records of the signed
/// course, where compression warms, give the same A: the slope's sign is dropped.
struct Factor {
  statistics::Measured factor;
  Regression line;  ///< what the factor is the slope of
};
inline Factor factor_from_stress(const std::vector<double>& stress, const std::vector<double>& temperature,
                                 bool through_origin = false) {
  const Regression line = regress(stress, temperature, through_origin);
  return {{std::abs(line.slope.value), line.slope.error, line.slope.freedom}, line};
}

/// Modulus and Poisson's ratio of a specimen in plane stress.
struct Elastic {
  statistics::Measured young, poisson;
};

/// E/(1 - nu), Pa: sigma_kk over eps_kk in plane stress (T eq. 1.70).
inline statistics::Measured stress_over_strain(const Elastic& e) {
  return statistics::product({{e.young, 1}, {{1 - e.poisson.value, e.poisson.error, e.poisson.freedom}, -1}});
}

/// A from measured strains eps_kk (the sum of both in-plane strains): slope over E/(1 - nu) (T eq. 1.70).
inline Factor factor_from_strain(const std::vector<double>& strain, const std::vector<double>& temperature,
                                 const Elastic& elastic, bool through_origin = false) {
  const Factor f = factor_from_stress(strain, temperature, through_origin);
  return {statistics::product({{f.factor, 1}, {stress_over_strain(elastic), -1}}), f.line};
}

/// What a factor follows from without a test.
struct Properties {
  statistics::Measured expansion;      ///< alpha, 1/K
  statistics::Measured temperature;    ///< T_0, K
  statistics::Measured density;        ///< kg/m^3
  statistics::Measured heat_capacity;  ///< c_p, J/kg/K
};

/// A = alpha T_0/(rho c_p), K/Pa (T eq. 1.55).
inline statistics::Measured factor_from_properties(const Properties& p) {
  return statistics::product({{p.expansion, 1}, {p.temperature, 1}, {p.density, -1}, {p.heat_capacity, -1}});
}

/// The constant A' of sigma_kk = A' S for a raw signal S (T eq. 1.69), Pa a level, from stress and signal. The
/// stress is calculated from the load or from a strain; the signal carries the noise, so A' is one over its slope.
inline Factor signal_constant(const std::vector<double>& stress, const std::vector<double>& signal,
                              bool through_origin = false) {
  const Factor f = factor_from_stress(stress, signal, through_origin);
  return {statistics::product({{f.factor, -1}}), f.line};
}

/// What a detector needs for a constant without a test.
struct Detector {
  statistics::Measured responsivity;         ///< D = 1/(n B' Z T^(n-1)) at its own temperature, K a level (T eq. 1.67)
  statistics::Measured amplification{1, 0};  ///< F
  statistics::Measured emissivity{1, 0};
  double reference = 296;  ///< T_D: the temperature D holds at, K
  double surface = 296;    ///< T_E: the specimen's, K
  radiometry::Band band;
};

/// R of T eq. 1.68, D at the surface's temperature over D at its own: (T_D/T_E)^2, which is right for a photon detector
/// that sees all wavelengths, where N ~ T^3.
inline double printed_correction(const Detector& d) { return d.reference / d.surface * (d.reference / d.surface); }

/// The same for the band that the detector sees: N'(T_D)/N'(T_E), for InSb near room temperature a power of about 8.7,
/// not 2.
inline double band_correction(const Detector& d) {
  return radiometry::photon_exitance_slope(d.band, d.reference) / radiometry::photon_exitance_slope(d.band, d.surface);
}

/// A' = D R F/(T eps A), Pa a level (T eq. 1.68). T's A there lacks T_0, so that T A is the factor of T eq. 1.55 at the
/// surface's temperature: `factor`, K/Pa.
inline statistics::Measured direct_constant(const Detector& d, double correction, const statistics::Measured& factor) {
  return statistics::product(
      {{d.responsivity, 1}, {{correction}, 1}, {d.amplification, 1}, {d.emissivity, -1}, {factor, -1}});
}

}  // namespace arenite::identify
