#include <fmt/format.h>

#include <cmath>

#include "statistics/text.hpp"
#include "solid/stress/stress.hpp"

namespace arenite::stress {
namespace {

using statistics::Lines;
using statistics::with_error;

void put_set(Lines& lines, const std::string& what, const Distribution& d) {
  if (d.relative_mean.error > 1e-12) lines.put("mean, " + what, d.relative_mean, "of the sample's");
  lines.put("variance, " + what, d.variance);
  lines.put("share above the mean, " + what, d.share_above);
  if (const Estimate* q = statistics::find(d.quantiles, "99.9 %")) lines.put("99.9 % quantile, " + what, *q);
  lines.put("excess kurtosis, " + what, d.excess_kurtosis);
  if (std::isfinite(d.tail.slope.value))
    lines.put("slope of the tail, " + what, fmt::format("{} between {:.3g} and {:.3g} own means", with_error(d.tail.slope), d.tail.low, d.tail.high));
  if (std::isfinite(d.q_gaussian.q.value))
    lines.put("q of the q-Gaussian, " + what, fmt::format("{}, R^2 {:.3f}", with_error(d.q_gaussian.q), d.q_gaussian.r2));
}

}  // namespace

std::string to_text(const Statistics& s) {
  Lines lines;
  lines.put("nodes of particles and matrix", fmt::format("{}", s.nodes));
  for (const auto& c : s.components) {
    const std::string stress = name_of(c.component);
    const auto [unit, scale] = statistics::stress_unit(std::abs(c.sample_mean.value));
    lines.put("mean " + stress, c.sample_mean, unit, scale);
    for (const auto& [name, set] : c.sets) put_set(lines, name == "all" ? stress : stress + " in " + name, set);
  }
  for (const auto& note : s.notes) lines.note(note);
  return lines.text();
}

}  // namespace arenite::stress
