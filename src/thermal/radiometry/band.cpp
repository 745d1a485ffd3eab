#include "thermal/radiometry/band.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "core/root.hpp"

namespace arenite::radiometry {
namespace {

constexpr double light = 299792458.0;       // m/s
constexpr double planck = 6.62607015e-34;   // J s
constexpr double boltzmann = 1.380649e-23;  // J/K
constexpr double c2 = planck * light / boltzmann;

/// Between x = a and b of x^2/(e^x - 1), a below b: with e^-x (1 + e^-x + ..) for 1/(e^x - 1), each term is known. The
/// terms are taken as differences, so that a narrow band keeps its digits.
double integral(double a, double b) {
  const double width = b - a;
  double sum = 0;
  for (int k = 1; k <= 100000; ++k) {
    const double n = k;
    // F(x) = (x^2/n + 2x/n^2 + 2/n^3) e^-nx; F(a) - F(b) = e^-na (P(a) (1 - e^-nw) - (P(b) - P(a)) e^-nw)
    const double at_a = (a * a + 2 * a / n + 2 / (n * n)) / n;
    const double more = width * (a + b + 2 / n) / n;
    const double term = std::exp(-n * a) * (-at_a * std::expm1(-n * width) - more * std::exp(-n * width));
    sum += term;
    if (term <= 1e-17 * sum) break;
  }
  return sum;
}

double integrand(double x) { return x * x / std::expm1(x); }

/// 2 pi c/lambda^4 d lambda = -2 pi c (T/C2)^3 x^2 dx with x = C2/(lambda T).
double scale(double temperature) {
  const double u = temperature / c2;
  return 2 * std::numbers::pi * light * u * u * u;
}

}  // namespace

double photon_exitance(const Band& band, double temperature) {
  if (!(temperature > 0)) return 0;
  return scale(temperature) * integral(c2 / (band.high * temperature), c2 / (band.low * temperature));
}

double photon_exitance_slope(const Band& band, double temperature) {
  if (!(temperature > 0)) return 0;
  const double a = c2 / (band.high * temperature), b = c2 / (band.low * temperature);
  return scale(temperature) / temperature * (3 * integral(a, b) + a * integrand(a) - b * integrand(b));
}

double temperature_of_exitance(const Band& band, double exitance) {
  if (!(exitance > 0)) return 0;
  // ln N falls almost linearly with u = 1/T.
  const auto excess = [&](double u) { return std::log(photon_exitance(band, 1 / u) / exitance); };
  double low = 1.0 / 300, high = low;
  while (excess(low) < 0) low /= 4;
  while (excess(high) > 0) high *= 4;
  return 1 / bracketed_root<double>(excess, low, excess(low), high, excess(high));
}

SmallChange taken_for_another(const Band& band, const Surface& assumed, const Surface& surface, double temperature) {
  if (assumed.emissivity == surface.emissivity) return {temperature, 1};
  const double t = temperature_of_seen(band, surface, seen_exitance(band, assumed, temperature));
  if (!(t > 0)) return {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  return {t, assumed.emissivity * photon_exitance_slope(band, temperature) /
                 (surface.emissivity * photon_exitance_slope(band, t))};
}

}  // namespace arenite::radiometry
