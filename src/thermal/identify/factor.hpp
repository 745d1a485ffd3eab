#pragma once
#include <vector>

#include "thermal/identify/curve.hpp"
#include "thermal/radiometry/band.hpp"

namespace arenite::identify {

/// The thermoelastic factor A of dT = -A d(sigma_kk) (T eq. 1.55), K/Pa, as the slope of temperature against stress
/// (calculated stress, T 2.3). Both must be of one convention, peak to peak or amplitudes. Records
/// of the signed course, where compression warms, give the same A: the slope's sign is dropped.
struct Factor {
  statistics::Measured factor;
  Regression line;  ///< what the factor is the slope of
};
Factor factor_from_stress(const std::vector<double>& stress, const std::vector<double>& temperature, bool through_origin = false);

/// Modulus and Poisson's ratio of a specimen in plane stress.
struct Elastic {
  statistics::Measured young, poisson;
};

/// E/(1 - nu), Pa: sigma_kk over eps_kk in plane stress (T eq. 1.70).
statistics::Measured stress_over_strain(const Elastic& e);

/// A from measured strains eps_kk (the sum of both in-plane strains): slope over E/(1 - nu) (T eq. 1.70).
Factor factor_from_strain(const std::vector<double>& strain, const std::vector<double>& temperature, const Elastic& elastic, bool through_origin = false);

/// What a factor follows from without a test.
struct Properties {
  statistics::Measured expansion;      ///< alpha, 1/K
  statistics::Measured temperature;    ///< T_0, K
  statistics::Measured density;        ///< kg/m^3
  statistics::Measured heat_capacity;  ///< c_p, J/kg/K
};

/// A = alpha T_0/(rho c_p), K/Pa (T eq. 1.55).
statistics::Measured factor_from_properties(const Properties& p);

/// The constant A' of sigma_kk = A' S for a raw signal S (T eq. 1.69), Pa a level, from stress and signal. The
/// stress is calculated from the load or from a strain; the signal carries the noise, so A' is one over its slope.
Factor signal_constant(const std::vector<double>& stress, const std::vector<double>& signal, bool through_origin = false);

/// What a detector needs for a constant without a test.
struct Detector {
  statistics::Measured responsivity;         ///< D = 1/(n B' Z T^(n-1)) at its own temperature, K a level (T eq. 1.67)
  statistics::Measured amplification{1, 0};  ///< F
  statistics::Measured emissivity{1, 0};
  double reference = 296;  ///< T_D: the temperature D holds at, K
  double surface = 296;    ///< T_E: the specimen's, K
  radiometry::Band band;
};

/// R of T eq. 1.68, D at the surface's temperature over D at its own: (T_D/T_E)^2, which is right for a photon detector that sees
/// all wavelengths, where N ~ T^3.
double printed_correction(const Detector& d);

/// The same for the band that the detector sees: N'(T_D)/N'(T_E), for InSb near room temperature a power of about 8.7, not 2.
double band_correction(const Detector& d);

/// A' = D R F/(T eps A), Pa a level (T eq. 1.68). T's A there lacks T_0, so that T A is the factor of T eq. 1.55 at the
/// surface's temperature: `factor`, K/Pa.
statistics::Measured direct_constant(const Detector& d, double correction, const statistics::Measured& factor);

}  // namespace arenite::identify
