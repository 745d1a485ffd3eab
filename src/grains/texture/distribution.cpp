#include "grains/texture/view.hpp"

#include <algorithm>
#include <cmath>

#include "core/mapped.hpp"

namespace arenite::texture {
namespace {

double mean_of(const Items& items, const std::vector<double>& value) {
  double sum = 0;
  for (const std::size_t i : items) sum += value[i];
  return sum / static_cast<double>(items.size());
}

/// Share of items beyond the mean, on the mean's side: for stresses under compression both are negative.
double share_beyond(const Items& items, const std::vector<double>& value, double mean) {
  double above = 0;
  for (const std::size_t i : items) above += value[i] / mean > 1;
  return above / static_cast<double>(items.size());
}

Curve density(const std::vector<double>& sorted) {
  Curve curve;
  const double top = sorted.back(), n = static_cast<double>(sorted.size());
  if (!(top > 0)) return curve;
  const double width = std::max(0.1, top / 100);
  std::vector<double> count(static_cast<std::size_t>(top / width) + 1, 0.0);
  for (const double x : sorted)
    if (x >= 0) count[static_cast<std::size_t>(x / width)] += 1;
  for (std::size_t k = 0; k < count.size(); ++k) {
    curve.x.push_back((static_cast<double>(k) + 0.5) * width);
    curve.y.push_back(count[k] / (n * width));
    curve.error.push_back(std::sqrt(count[k]) / (n * width));
  }
  return curve;
}

/// Share at or above x, at up to about 200 of the values themselves: all ranks of the far tail, then ever fewer.
Curve survival_function(const std::vector<double>& sorted) {
  Curve curve;
  const std::size_t n = sorted.size();
  for (std::size_t rank = n; rank >= 1; rank = std::min(rank - 1, static_cast<std::size_t>(static_cast<double>(rank) / 1.035))) {
    const double share = static_cast<double>(rank) / static_cast<double>(n);
    curve.x.push_back(sorted[n - rank]);
    curve.y.push_back(share);
    curve.error.push_back(std::sqrt(share * (1 - share) / static_cast<double>(n)));
  }
  return curve;
}

/// k and beta^2/((1 - alpha)(2 - alpha)), with errors carried over from beta and alpha as independent.
void relate(Distribution& d) {
  const double beta = d.tail.beta.value, a = d.weak.alpha.value, sb = d.tail.beta.error, sa = d.weak.alpha.error;
  const double k = 1 / (1 / (1 - a) + 1 / beta);
  d.k = {k, k * k * std::hypot(sa / ((1 - a) * (1 - a)), sb / (beta * beta))};
  const double product = (1 - a) * (2 - a), ratio = beta * beta / product;
  d.relation = {ratio, ratio * std::hypot(2 * sb / beta, (3 - 2 * a) * sa / product)};
}

/// The contacts of a set that push (sign = 1) or pull (sign = -1).
Items of_sign(const View& view, const Items& items, double sign) {
  Items kept;
  for (const std::size_t c : items)
    if (sign * view.pairs().fn[c] > 0) kept.push_back(c);
  return kept;
}

}  // namespace

PowerLaw weak_power_law(const std::vector<double>& sorted) {
  PowerLaw law;
  double sum = 0;
  for (const double x : sorted) {
    if (x <= 0) continue;
    if (x >= 1) break;
    sum -= std::log(x);
    ++law.count;
  }
  if (law.count < 2) return law;
  const double n = static_cast<double>(law.count);
  law.alpha = {1 - n / sum, n / sum / std::sqrt(n)};
  return law;
}

namespace {

constexpr Declared<Distribution> distribution_numbers[] = {
    {"fraction_above_mean_of_all", "", "Share of the set above the mean of all", &Distribution::fraction_above_mean_of_all},
    {"maximum", "", "Largest value over the mean", &Distribution::maximum}};

constexpr Declared<ExponentialTail> tail_numbers[] = {
    {"beta_line", "", "The same by a straight line through ln of the survival function", &ExponentialTail::line_beta},
    {"line_r2", "", "Share of that logarithm's variance that the line explains", &ExponentialTail::line_r2},
    {"tail_count", "", "Values above the mean", &ExponentialTail::count},
    {"log_likelihood_ratio", "", "ln L(exponential) - ln L(half-Gaussian)", &ExponentialTail::likelihood_ratio},
    {"p_value", "", "That the exponential's lead is chance (Vuong's test, one-sided)", &ExponentialTail::p_value}};

constexpr Declared<Distribution> relation_numbers[] = {
    {"k", "", "Height of the pdf at the mean, 1/k = 1/(1 - alpha) + 1/beta", &Distribution::k},
    {"beta2_over_product", "", "beta^2/((1 - alpha)(2 - alpha)); 1 where T eq. 1.5 holds", &Distribution::relation}};

Numbers numbers_of(const Distribution& d, const DistributionNames& names, bool curves) {
  Numbers j{{"count", described(d.count, "", "Values of the set")}};
  put(j, names.mean, d.mean, names.unit, names.mean_is);
  put(j, names.share, d.fraction_above_mean, "", names.share_is);
  put(j, d, distribution_numbers);
  put(j, "beta", d.tail.beta, "", "Decay of values above the mean, P ~ exp(-beta x), by maximum likelihood");
  put(j, "beta_error", d.tail.beta.error, "", "Standard error of beta");
  put(j, d.tail, tail_numbers);
  put(j, "alpha", d.weak.alpha, "", "Exponent of values below the mean, P ~ x^-alpha, by maximum likelihood");
  put(j, d, relation_numbers);
  if (curves) j.update({{"pdf", d.pdf}, {"pdf_over_all", d.pdf_over_all}, {"cumulative", d.cumulative}});
  return j;
}

}  // namespace

Numbers numbers(const ByName<Distribution>& sets, const DistributionNames& names, bool curves) {
  return by_set(sets, names.group, [&](const Distribution& d) { return numbers_of(d, names, curves); });
}

Distribution distribution(const Items& items, const std::vector<int>& block_of, const std::vector<double>& value, double mean_of_all, double scale) {
  Distribution d;
  d.count = items.size();
  if (items.empty()) return d;
  const auto statistics = [&](const Items& set) {
    if (set.empty()) return std::vector<double>(3, unknown);
    const double mean = mean_of(set, value);
    return std::vector<double>{mean * scale, share_beyond(set, value, mean), share_beyond(set, value, mean_of_all)};
  };
  const auto estimates = jackknife(items, block_of, statistics);
  d.mean = estimates[0];
  d.fraction_above_mean = estimates[1];
  d.fraction_above_mean_of_all = estimates[2];
  const double own_mean = mean_of(items, value);
  if (own_mean == 0) return d;
  auto sorted = mapped(items, [&](std::size_t i) { return value[i] / own_mean; });
  std::sort(sorted.begin(), sorted.end());
  d.maximum = sorted.back();
  d.tail = exponential_tail(sorted);
  d.weak = weak_power_law(sorted);
  relate(d);
  d.pdf = density(sorted);
  d.cumulative = survival_function(sorted);
  for (double& x : sorted) x *= own_mean / mean_of_all;
  d.pdf_over_all = density(sorted);
  return d;
}

namespace {

/// Normal forces between grains, pushing and pulling ones apart (T Fig. 1.6, 1.9).
void measure_forces(const View& view, Texture& texture) {
  if (view.contacts.empty()) {
    texture.notes.push_back("No contact lies in the window, so coordination is zero and fabric and forces are left out.");
    return;
  }
  ByName<Items> sets{{"all", view.contacts}};
  for (auto& type : contacts_by_type(view)) sets.push_back(std::move(type));
  std::vector<double> pull = view.pairs().fn;
  for (double& f : pull) f = -f;
  double mean_pull = 0;
  for (const auto& [name, items] : sets) {
    if (const Items pushing = of_sign(view, items, 1); !pushing.empty())
      texture.force.compressive.emplace_back(name, distribution(pushing, view.contact_block, view.pairs().fn, view.mean_force));
    const Items pulling = of_sign(view, items, -1);
    if (pulling.empty()) continue;
    if (name == "all")
      for (const std::size_t c : pulling) mean_pull += pull[c] / static_cast<double>(pulling.size());
    texture.force.tensile.emplace_back(name, distribution(pulling, view.contact_block, pull, mean_pull));
  }
  texture.force.tensile_share = mean(view.contacts, view.contact_block, [&](std::size_t c) { return pull[c] > 0 ? 1.0 : 0.0; });
  texture.force.tensile_mean_ratio = view.mean_force > 0 ? mean_pull / view.mean_force : unknown;
}

void put_forces(const Texture& t, Numbers& to, bool curves) {
  constexpr DistributionNames names{"mean_N", "N", "strong_share", "by_type", "Mean normal force of the set", "Share of contacts above the set's own mean"};
  if (t.force.compressive.empty()) return;
  Numbers& j = to["force"] = numbers(t.force.compressive, names, curves);
  put(j, "tensile_share", t.force.tensile_share, "", "Share of contacts that pull");
  if (t.force.tensile.empty()) return;
  j["tensile"] = numbers(t.force.tensile, names, curves);
  put(j["tensile"], "mean_over_compressive_mean", t.force.tensile_mean_ratio, "", "Mean pull over mean push");
}

}  // namespace

extern const Statistic forces{measure_forces, put_forces};

}  // namespace arenite::texture
