#include "grains/texture/distribution.hpp"

#include "grains/texture/view.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <utility>

#include "core/mapped.hpp"
#include "statistics/tails.hpp"

namespace arenite::texture {
namespace {

double mean_of(const Items& items, const std::vector<double>& value) {
  double sum = 0;
  for (const std::size_t i : items) sum += value[i];
  return sum / static_cast<double>(items.size());
}

/// The values over their mean, of items in their order.
std::vector<double> rising(const Items& sorted, const std::vector<double>& value, double mean) {
  return mapped(sorted, [&](std::size_t i) { return value[i] / mean; });
}

/// Share of items beyond the mean, on the mean's side: for stresses under compression both are negative.
double share_beyond(const Items& items, const std::vector<double>& value, double mean) {
  return statistics::share_beyond(rising(items, value, mean), 1);
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
  for (std::size_t rank = n; rank >= 1;
       rank = std::min(rank - 1, static_cast<std::size_t>(static_cast<double>(rank) / 1.035))) {
    const double share = static_cast<double>(rank) / static_cast<double>(n);
    curve.x.push_back(sorted[n - rank]);
    curve.y.push_back(share);
    curve.error.push_back(std::sqrt(share * (1 - share) / static_cast<double>(n)));
  }
  return curve;
}

constexpr double equal_values = 1e-9;  // times the mean: values that differ by no more only differ by rounding

/// The numbers of a set in the order of `put_numbers`.
enum Number { mean_value, above_own, above_all, beta, beta_line, lead, alpha, k, relation, numbers_in_all };

/// Of items in the order of their values. The means are those of the blocks that are left, so that their scatter is in
/// the errors of all that is counted from them.
std::vector<double> numbers_of(const Items& sorted, const std::vector<double>& value, double mean_of_all,
                               double scale) {
  std::vector<double> n(numbers_in_all, unknown);
  if (sorted.empty()) return n;
  const double mean = mean_of(sorted, value);
  n[mean_value] = mean * scale;
  n[above_own] = share_beyond(sorted, value, mean);
  n[above_all] = share_beyond(sorted, value, mean_of_all);
  const auto x = rising(sorted, value, mean);
  if (!(x.front() <= x.back())) return n;  // the mean is nought, or of the other sign than that of all
  if (x.back() - x.front() < equal_values) {
    n[above_own] = 0;
    return n;
  }
  const statistics::TailFit tail = statistics::exponential_tail(x);
  const double b = tail.slope.value, a = statistics::weak_exponent(x);
  n[beta] = b;
  n[beta_line] = tail.line_slope.value;
  n[lead] = tail.likelihood_ratio.value / static_cast<double>(sorted.size());  // a sum has no jackknife, a mean has
  n[alpha] = a;
  n[k] = 1 / (1 / (1 - a) + 1 / b);
  n[relation] = b * b / ((1 - a) * (2 - a));
  return n;
}

void put_numbers(Numbers& to, const std::vector<Estimate>& n, const DistributionNames& names) {
  put(to, names.mean, n[mean_value], names.unit, names.mean_is);
  put(to, names.share, n[above_own], "", names.share_is);
  put(to, "fraction_above_mean_of_all", n[above_all], "", "Fraction of the set above the mean of all", Trait::detail);
}

void put_laws(Numbers& to, const std::vector<Estimate>& n, const statistics::TailFit& tail) {
  put(to, "beta", n[beta], "", "Decay of values above the mean, P ~ exp(-beta x), by maximum likelihood");
  put(to, "beta_error", n[beta].error, "", "Standard error of beta", Trait::detail);
  put(to, "beta_line", n[beta_line], "", "The same from a straight line through ln of the survival function",
      Trait::detail);
  put(to, "line_r2", tail.line_r2, "", "Coefficient of determination of that line", Trait::detail);
  put(to, "tail_count", tail.count, "", "Values above the mean", Trait::detail);
  put(to, "log_likelihood_ratio", n[lead], "", "ln L(exponential) - ln L(half-Gaussian)", Trait::detail);
  put(to, "p_value", statistics::chance_of_lead(n[lead]), "",
      "Probability that the exponential fits better by chance (Vuong's test, one-sided)", Trait::detail);
  put(to, "alpha", n[alpha], "",
      "Exponent of values from 0.01 to 1 times the mean, P ~ x^-alpha, by maximum likelihood");
  put(to, "k", n[k], "", "Height of the pdf at the mean, 1/k = 1/(1 - alpha) + 1/beta", Trait::detail);
  put(to, "beta2_over_product", n[relation], "", "beta^2/((1 - alpha)(2 - alpha)); 1 where T eq. 1.5 holds",
      Trait::detail);
}

}  // namespace

Numbers distribution(const Items& items, const Items& all, const std::vector<int>& block_of,
                     const std::vector<double>& value, double mean_of_all, const DistributionNames& names, double scale,
                     double level) {
  const double own_mean = mean_of(items, value), sign = own_mean < 0 ? -1 : 1,
               count = static_cast<double>(items.size()), of_all = mean_of_all / mean_of(all, value);
  Items by_value = all;
  std::ranges::stable_sort(by_value, [&](std::size_t i, std::size_t j) { return sign * value[i] < sign * value[j]; });
  std::vector<std::uint8_t> own(value.size(), 0);
  for (const std::size_t i : items) own[i] = 1;
  const auto is_own = [&](std::size_t i) { return own[i] != 0; };
  auto n = jackknife(by_value, block_of, [&](const Items& rest) {
    return numbers_of(kept(rest, is_own), value, of_all * mean_of(rest, value), scale);
  });
  n[lead] = {n[lead].value * count, n[lead].error * count};
  n[mean_value].error = std::hypot(n[mean_value].error, level * n[mean_value].value);
  Numbers j{{"count", described(items.size(), "", "Values of the set")}};
  put_numbers(j, n, names);
  std::vector<double> x;
  if (own_mean != 0) x = rising(kept(by_value, is_own), value, own_mean);
  if (!x.empty()) put(j, "maximum", x.back(), "", "Largest value over the mean");
  put_laws(j, n, statistics::exponential_tail(x));
  j["pdf"] = Numbers(density(x)).mark(Trait::curve);
  const Numbers cumulative = Numbers(survival_function(x)).mark(Trait::curve);
  for (double& v : x) v *= own_mean / mean_of_all;
  j["pdf_over_all"] = Numbers(density(x)).mark(Trait::curve);
  j["cumulative"] = cumulative;
  return j;
}

/// Of all contacts, the share that is strong and in the set.
template <int D> Estimate strong_share_of_all(const ViewIn<D>& view, const Items& set) {
  std::vector<std::uint8_t> own(view.pairs().size(), 0);
  for (const std::size_t c : set) own[c] = 1;
  const auto share = [&](const Items& contacts) {
    const double threshold = mean_push(view.pairs(), contacts);
    const auto counts = [&](std::size_t c) { return own[c] != 0 && view.pairs().fn[c] > threshold; };
    return std::vector{static_cast<double>(std::ranges::count_if(contacts, counts)) /
                       static_cast<double>(contacts.size())};
  };
  return jackknife(view.contacts, view.contact_block, share)[0];
}

/// Normal forces between grains, pushing and pulling ones apart (T Fig. 1.6, 1.9).
template <int D> void forces(const ViewIn<D>& view, TextureIn<D>& texture) {
  constexpr DistributionNames names{"mean_N", "N", "strong_share", "Mean normal force of the set",
                                    "Fraction of contacts above the set's own mean"};
  if (view.contacts.empty()) {
    texture.notes.push_back(
        "There is no contact in the window, so coordination is zero, and fabric and forces are left out.");
    return;
  }
  ByName<Items> sets{{"all", view.contacts}};
  for (auto& type : contacts_by_type(view)) sets.push_back(std::move(type));
  const std::vector<double>& push = view.pairs().fn;
  const std::vector<double> pull = mapped(push, std::negate<>());
  const Items all_pushing = kept(view.contacts, [&](std::size_t c) { return push[c] > 0; }),
              all_pulling = kept(view.contacts, [&](std::size_t c) { return pull[c] > 0; });
  const double mean_pull = all_pulling.empty() ? 0 : mean_of(all_pulling, pull);
  Numbers compressive = Numbers::tree(), tensile = Numbers::tree();
  for (const auto& [name, items] : sets) {
    if (const Items pushing = kept(items, [&](std::size_t c) { return push[c] > 0; }); !pushing.empty()) {
      Numbers& set = place_of(name, compressive, "by_type");
      set.update(distribution(pushing, all_pushing, view.contact_block, push, view.mean_force, names, 1, view.level()));
      if (name != "all")
        put(set, "strong_share_of_all", strong_share_of_all(view, items), "",
            "Fraction of all contacts that are of the set and above the mean of all", Trait::detail);
    }
    const Items pulling = kept(items, [&](std::size_t c) { return pull[c] > 0; });
    if (pulling.empty()) continue;
    place_of(name, tensile, "by_type")
        .update(distribution(pulling, all_pulling, view.contact_block, pull, mean_pull, names, 1, view.level()));
  }
  if (compressive.empty()) return;
  put(compressive, "tensile_share",
      mean(view.contacts, view.contact_block, [&](std::size_t c) { return pull[c] > 0 ? 1.0 : 0.0; }), "",
      "Fraction of tensile contacts");
  if (!tensile.empty()) {
    put(tensile, "mean_over_compressive_mean", view.mean_force > 0 ? mean_pull / view.mean_force : unknown, "",
        "Mean tensile over mean compressive force");
    compressive["tensile"] = tensile;
  }
  texture.numbers["force"] = compressive.mark(Trait::by_forces);
}
template void forces(const View&, Texture&);
template void forces(const SphereView&, TextureIn<3>&);

}  // namespace arenite::texture
