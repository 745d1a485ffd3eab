#pragma once

namespace arenite::radiometry {

/// The wavelengths a camera sees, m: by default those of an InSb detector, 3.6 to 5.1 um.
struct Band {
  double low = 3.6e-6, high = 5.1e-6;
};

/// Photons that a black body sends out of its surface, N(T) in photons/s/m^2: Planck's law 2 pi c/lambda^4 /
/// (exp(C2/(lambda T)) - 1) with C2 = hc/k_B, integrated over the band. T in K, above 0.
double photon_exitance(const Band& band, double temperature);

/// dN/dT, photons/s/m^2/K.
double photon_exitance_slope(const Band& band, double temperature);

/// The exponent n of N ~ T^n near this temperature, n = T N'/N (T eq. 1.64).
inline double exitance_exponent(const Band& band, double temperature) {
  return temperature * photon_exitance_slope(band, temperature) / photon_exitance(band, temperature);
}

/// The temperature whose photon exitance this is, K: the inverse of photon_exitance. 0 for an exitance of 0 or less.
double temperature_of_exitance(const Band& band, double exitance);

/// Of grains whose material does not say theirs.
inline constexpr double usual_emissivity = 0.9;

/// A surface that is not black, and what it mirrors.
struct Surface {
  double emissivity = 1;  ///< above 0, at most 1
  double ambient = 296;   ///< temperature of the surroundings, K
};

/// What a camera sees of a surface: eps N(T) + (1 - eps) N(T_amb), photons/s/m^2.
inline double seen_exitance(const Band& band, const Surface& surface, double temperature) {
  return surface.emissivity * photon_exitance(band, temperature) +
         (1 - surface.emissivity) * photon_exitance(band, surface.ambient);
}

/// The temperature of a surface of which this is seen, K. 0 where the surroundings alone send as much.
inline double temperature_of_seen(const Band& band, const Surface& surface, double exitance) {
  const double mirrored = (1 - surface.emissivity) * photon_exitance(band, surface.ambient);
  return temperature_of_exitance(band, (exitance - mirrored) / surface.emissivity);
}

/// A temperature and a small change of it, K.
struct SmallChange {
  double temperature = 0, factor = 0;
};

/// What a surface was, and by how much it changed for every kelvin of change, if it was taken for another one
/// (`assumed`, of the same surroundings) and thought to be at `temperature`: both send the same photons. Not finite
/// where the surroundings alone send as much.
SmallChange taken_for_another(const Band& band, const Surface& assumed, const Surface& surface, double temperature);

}  // namespace arenite::radiometry
