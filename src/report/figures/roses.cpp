#include "report/figures/roses.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "statistics/sectors.hpp"

namespace arenite::report::figures {

std::vector<std::string> anisotropy_in_words(const Numbers& set) {
  const auto a = estimate_at(set, "/a_c");
  if (!std::isfinite(a.value)) return {};
  const double noise = estimate_at(set, "/a_c_noise").value;
  std::vector<std::string> words{in_words(said("a_{c}", a))};
  if (a.value < noise) words.push_back("below its noise, " + rounded(noise, 2));
  return words;
}

Rose rose_of(std::string name, std::string colour, const Numbers& set, const Numbers* inner) {
  constexpr int angles_of_line = 60;
  Rose rose{.name = std::move(name), .colour = std::move(colour), .count = estimate_at(set, "/contacts").value};
  rose.sectors = statistics::over_isotropic(reals_at(set, "/sectors"), rose.count);
  if (inner) rose.inner = statistics::over_isotropic(reals_at(*inner, "/sectors"), rose.count);
  const auto a = estimate_at(set, "/a_c"), theta = estimate_at(set, "/theta_c_deg");
  rose.words = anisotropy_in_words(set);
  if (std::isfinite(a.value)) {
    if (rose.words.size() == 1 && std::isfinite(theta.value))
      rose.words.push_back(in_words(said("\u03b8_{c}", theta)) + "\u00b0");
    if (std::isfinite(theta.value))
      rose.line = statistics::second_order_distribution(a.value, theta.value, angles_of_line);
    rose.reach = std::max(rose.reach, 1 + a.value);
  }
  rose.reach = std::max(rose.reach, largest_of(rose.sectors, 0));
  return rose;
}

}  // namespace arenite::report::figures
