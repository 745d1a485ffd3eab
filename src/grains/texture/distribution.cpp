#include "grains/texture/view.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/mapped.hpp"
#include "statistics/tails.hpp"

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

statistics::Curve density(const std::vector<double>& sorted) {
  statistics::Curve curve;
  if (sorted.empty() || !(sorted.back() > 0)) return curve;
  const double top = sorted.back(), n = static_cast<double>(sorted.size());
  const double width = std::max(0.1, top / 100);
  std::vector<double> count(static_cast<std::size_t>(top / width) + 1, 0.0);
  for (const double x : sorted)
    if (x >= 0) count[x / width] += 1;
  for (std::size_t k = 0; k < count.size(); ++k) {
    curve.x.push_back((static_cast<double>(k) + 0.5) * width);
    curve.y.push_back(count[k] / (n * width));
    curve.error.push_back(std::sqrt(count[k]) / (n * width));
  }
  return curve;
}

/// Share at or above x, at up to about 200 of the values themselves: all ranks of the far tail, then ever fewer.
statistics::Curve survival_function(const std::vector<double>& sorted) {
  statistics::Curve curve;
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
void put_relation(Numbers& to, const Estimate& beta, const Estimate& alpha) {
  const double b = beta.value, a = alpha.value, sb = beta.error, sa = alpha.error;
  const double k = 1 / (1 / (1 - a) + 1 / b);
  put(to, "k", Estimate{k, k * k * std::hypot(sa / ((1 - a) * (1 - a)), sb / (b * b))}, "", "Height of the pdf at the mean, 1/k = 1/(1 - alpha) + 1/beta");
  const double product = (1 - a) * (2 - a), ratio = b * b / product;
  put(to, "beta2_over_product", Estimate{ratio, ratio * std::hypot(2 * sb / b, (3 - 2 * a) * sa / product)}, "",
      "beta^2/((1 - alpha)(2 - alpha)); 1 where T eq. 1.5 holds");
}

void put_tail(Numbers& to, const statistics::TailFit& tail) {
  put(to, "beta", tail.slope, "", "Decay of values above the mean, P ~ exp(-beta x), by maximum likelihood");
  put(to, "beta_error", tail.slope.error, "", "Standard error of beta");
  put(to, "beta_line", tail.line_slope, "", "The same from a straight line through ln of the survival function");
  put(to, "line_r2", tail.line_r2, "", "Coefficient of determination of that line");
  put(to, "tail_count", tail.count, "", "Values above the mean");
  put(to, "log_likelihood_ratio", tail.likelihood_ratio, "", "ln L(exponential) - ln L(half-Gaussian)");
  put(to, "p_value", tail.p_value, "", "Probability that the exponential fits better by chance (Vuong's test, one-sided)");
}

}  // namespace

Estimate weak_exponent(const std::vector<double>& sorted) {
  std::size_t count = 0;
  double sum = 0;
  for (const double x : sorted) {
    if (x <= 0) continue;
    if (x >= 1) break;
    sum -= std::log(x);
    ++count;
  }
  if (count < 2) return {};
  const double n = static_cast<double>(count);
  return {1 - n / sum, n / sum / std::sqrt(n)};
}

Numbers distribution(const Items& items, const std::vector<int>& block_of, const std::vector<double>& value, double mean_of_all, const DistributionNames& names,
                     double scale) {
  const auto values_of = [&](const Items& set) {
    if (set.empty()) return std::vector<double>(3, unknown);
    const double mean = mean_of(set, value);
    return std::vector<double>{mean * scale, share_beyond(set, value, mean), share_beyond(set, value, mean_of_all)};
  };
  const auto estimates = jackknife(items, block_of, values_of);
  Numbers j{{"count", described(items.size(), "", "Values of the set")}};
  put(j, names.mean, estimates[0], names.unit, names.mean_is);
  put(j, names.share, estimates[1], "", names.share_is);
  put(j, "fraction_above_mean_of_all", estimates[2], "", "Fraction of the set above the mean of all");

  const double own_mean = mean_of(items, value);
  std::vector<double> sorted;
  if (own_mean != 0) sorted = mapped(items, [&](std::size_t i) { return value[i] / own_mean; });
  std::sort(sorted.begin(), sorted.end());
  if (!sorted.empty()) put(j, "maximum", sorted.back(), "", "Largest value over the mean");
  const statistics::TailFit tail = statistics::exponential_tail(sorted);
  const Estimate alpha = weak_exponent(sorted);
  put_tail(j, tail);
  put(j, "alpha", alpha, "", "Exponent of values below the mean, P ~ x^-alpha, by maximum likelihood");
  put_relation(j, tail.slope, alpha);
  j["pdf"] = density(sorted);
  const Numbers cumulative = survival_function(sorted);
  for (double& x : sorted) x *= own_mean / mean_of_all;
  j["pdf_over_all"] = density(sorted);
  j["cumulative"] = cumulative;
  return j;
}

/// Normal forces between grains, pushing and pulling ones apart (T Fig. 1.6, 1.9).
void forces(const View& view, Texture& texture) {
  constexpr DistributionNames names{"mean_N", "N", "strong_share", "Mean normal force of the set", "Fraction of contacts above the set's own mean"};
  if (view.contacts.empty()) {
    texture.notes.push_back("There is no contact in the window, so coordination is zero, and fabric and forces are left out.");
    return;
  }
  ByName<Items> sets{{"all", view.contacts}};
  for (auto& type : contacts_by_type(view)) sets.push_back(std::move(type));
  const std::vector<double>& push = view.pairs().fn;
  const std::vector<double> pull = mapped(push, std::negate<>());
  double mean_pull = 0;
  Numbers compressive = Numbers::tree(), tensile = Numbers::tree();
  for (const auto& [name, items] : sets) {
    if (const Items pushing = kept(items, [&](std::size_t c) { return push[c] > 0; }); !pushing.empty())
      place_of(name, compressive, "by_type").update(distribution(pushing, view.contact_block, push, view.mean_force, names));
    const Items pulling = kept(items, [&](std::size_t c) { return pull[c] > 0; });
    if (pulling.empty()) continue;
    if (name == "all")
      for (const std::size_t c : pulling) mean_pull += pull[c] / static_cast<double>(pulling.size());
    place_of(name, tensile, "by_type").update(distribution(pulling, view.contact_block, pull, mean_pull, names));
  }
  if (compressive.empty()) return;
  put(compressive, "tensile_share", mean(view.contacts, view.contact_block, [&](std::size_t c) { return pull[c] > 0 ? 1.0 : 0.0; }), "",
      "Fraction of tensile contacts");
  if (!tensile.empty()) {
    put(tensile, "mean_over_compressive_mean", view.mean_force > 0 ? mean_pull / view.mean_force : unknown, "", "Mean tensile over mean compressive force");
    compressive["tensile"] = tensile;
  }
  texture.numbers["force"] = compressive;
}

}  // namespace arenite::texture
