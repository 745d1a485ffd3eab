#include "report/figures/roses.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace arenite::report::figures {

namespace {

/// The contact distribution of second order over the isotropic one, T eq. 1.8.
std::vector<double> line_of(double anisotropy, double direction_deg) {
  constexpr int steps = 60;
  std::vector<double> radius;
  for (int k = 0; k < steps; ++k)
    radius.push_back(1 + anisotropy * std::cos(2 * (180.0 * k / steps - direction_deg) * std::numbers::pi / 180));
  return radius;
}

/// Of `whole` contacts without a preferred direction each sector would have as many.
std::vector<double> over_isotropic(std::vector<double> sectors, double whole) {
  for (double& contacts : sectors) contacts *= static_cast<double>(sectors.size()) / whole;
  return sectors;
}

}  // namespace

std::vector<std::string> anisotropy_in_words(const Numbers& set) {
  const auto a = estimate_at(set, "/a_c");
  if (!std::isfinite(a.value)) return {};
  const double noise = estimate_at(set, "/a_c_noise").value;
  std::vector<std::string> words{in_words(said("a_{c}", a))};
  if (a.value < noise) words.push_back("below its noise, " + rounded(noise, 2));
  return words;
}

Rose rose_of(std::string name, std::string colour, const Numbers& set, const Numbers* inner) {
  Rose rose{.name = std::move(name), .colour = std::move(colour), .count = estimate_at(set, "/contacts").value};
  rose.sectors = over_isotropic(reals_at(set, "/sectors"), rose.count);
  if (inner) rose.inner = over_isotropic(reals_at(*inner, "/sectors"), rose.count);
  const auto a = estimate_at(set, "/a_c"), theta = estimate_at(set, "/theta_c_deg");
  rose.words = anisotropy_in_words(set);
  if (std::isfinite(a.value)) {
    if (rose.words.size() == 1 && std::isfinite(theta.value))
      rose.words.push_back(in_words(said("\u03b8_{c}", theta)) + "\u00b0");
    if (std::isfinite(theta.value)) rose.line = line_of(a.value, theta.value);
    rose.reach = std::max(rose.reach, 1 + a.value);
  }
  rose.reach = std::max(rose.reach, largest_of(rose.sectors, 0));
  return rose;
}

}  // namespace arenite::report::figures
