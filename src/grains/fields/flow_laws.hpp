#pragma once
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "statistics/fit_law.hpp"

namespace arenite::fields {

constexpr std::size_t least_points_of_law = 3;  ///< that figures draw, with two constants to be found
constexpr double runout_bend = 2.5;  ///< aspect ratio at which collapses change from one power law to the other

/// W = factor (D - lost_width)^exponent. In two dimensions the exponent is 3/2 (Beverloo, Leniger and van de Velde,
/// Chem. Eng. Sci. 15, 260, 1961), factor C rho_b sqrt(g) times the out-of-plane length, lost_width k d.
struct BeverlooLaw {
  statistics::Estimate factor, lost_width, exponent;
  /// Rate, kg/s, through an opening, m.
  double at(double opening) const {
    return factor.value * std::pow(std::max(opening - lost_width.value, 0.0), exponent.value);
  }
  /// The line that the rate's root is.
  double root_at(double opening) const { return std::pow(at(opening), 1 / exponent.value); }
};
/// Exponent of the law in so many dimensions.
constexpr double beverloo_exponent(int dimension) { return dimension == 3 ? 2.5 : 1.5; }
/// Rates to the power 1/exponent, which the law makes a line of, with their errors.
std::vector<statistics::Estimate> roots_of_rates(const std::vector<double>& rate, const std::vector<double>& error,
                                                 double exponent);
/// Of rates of discharge, kg/s, through openings, m. An exponent that is given has no error.
BeverlooLaw fit_beverloo(const std::vector<double>& opening, const std::vector<double>& rate,
                         const std::vector<double>& error, std::optional<double> exponent = {});

/// Power laws of run-outs below and above aspect ratios, each of three points at two places at least. Grains on a plane
/// spread by about a below 2 to 3 and by a^(2/3) to a^0.7 above (Lube et al., Phys. Rev. E 72, 041301, 2005;
/// Lajeunesse, Monnier and Homsy, Phys. Fluids 17, 103302, 2005; Staron and Hinch, J. Fluid Mech. 545, 1, 2005). Points
/// have equal weights: the front scatters, not the measurement of its position.
struct RunoutLaws {
  std::optional<statistics::PowerLaw> low, high;
};
RunoutLaws fit_runout(const std::vector<double>& aspect_ratio, const std::vector<double>& runout,
                      double low = runout_bend, double high = runout_bend);

/// p = saturation (1 - exp(-H/length)) (H. A. Janssen, Z. VDI 39, 1045, 1895), Pa and m.
struct JanssenLaw {
  statistics::Estimate saturation, length;
  /// Pressure, Pa, under a filling of that height, m.
  double at(double height) const { return -saturation.value * std::expm1(-height / length.value); }
};
/// Of pressures, Pa, under fillings of such heights, m, beside those of a liquid.
JanssenLaw fit_janssen(const std::vector<double>& height, const std::vector<double>& pressure,
                       const std::vector<double>& error, const std::vector<double>& hydrostatic);
/// The length as stresses have it, W/(2 mu_w K) with the wall friction and the ratio of stresses measured in the taller
/// half of the fillings, which represent the saturated part.
statistics::Estimate length_by_stresses(const std::vector<double>& width, const std::vector<double>& wall_friction,
                                        const std::vector<double>& ratio);

}  // namespace arenite::fields
