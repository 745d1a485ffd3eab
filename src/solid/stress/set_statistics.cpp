#include "solid/stress/set_statistics.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/mapped.hpp"
#include "solid/stress/stress.hpp"
#include "statistics/jackknife.hpp"
#include "statistics/q_gaussian.hpp"
#include "statistics/tails.hpp"

namespace arenite::stress {
namespace {

using statistics::BlockCounts;
using statistics::BlockedSample;
using statistics::Counts;
using statistics::put;

constexpr std::pair<const char*, double> quantile_shares[] = {
    {"0.01 %", 1e-4}, {"0.1 %", 1e-3}, {"1 %", 0.01},  {"5 %", 0.05},     {"25 %", 0.25},     {"50 %", 0.5},
    {"75 %", 0.75},   {"95 %", 0.95},  {"99 %", 0.99}, {"99.9 %", 0.999}, {"99.99 %", 0.9999}};

struct Moments {
  double mean = 0, variance = 0, skewness = unknown, excess_kurtosis = unknown;
};

Moments moments_of(const Powers& p, double shift) {
  const double a = p.d1 / p.n, m2 = p.d2 / p.n - a * a;
  Moments m{shift + a, std::max(0.0, m2), unknown, unknown};
  if (m2 <= 1e-20 * m.mean * m.mean) return {shift + a, 0, unknown, unknown};
  const double m3 = p.d3 / p.n - 3 * a * p.d2 / p.n + 2 * a * a * a;
  const double m4 = p.d4 / p.n - 4 * a * p.d3 / p.n + 6 * a * a * p.d2 / p.n - 3 * a * a * a * a;
  m.skewness = m3 / (m2 * std::sqrt(m2));
  m.excess_kurtosis = m4 / (m2 * m2) - 3;
  return m;
}

double mean_of(const BlockedSample& sample) {
  double sum = 0;
  for (const double x : sample.x) sum += x;
  return sum / static_cast<double>(sample.x.size());
}

/// Everything below is in units of `unit`: the set's own mean, or what stands in for it.
struct Scaled {
  BlockedSample& x;
  double unit = 1, centre = 1;  ///< Pa; mean of x
  std::vector<Powers> powers;   ///< of x - centre, by block
  Powers all;
  std::vector<double> unit_without;  ///< the unit without each block over the unit
};

Scaled scale(BlockedSample& sigma, const Normaliser& normaliser) {
  const double mean = mean_of(sigma), unit = normaliser.over_mean ? mean : normaliser.value;
  for (double& x : sigma.x) x /= unit;
  Scaled s{sigma, unit, mean_of(sigma), {}, {}, {}};
  s.powers = powers_by_block(sigma, s.centre);
  for (const Powers& p : s.powers) s.all += p;
  for (std::size_t b = 0; b < s.powers.size(); ++b) {
    const Powers rest = s.all - s.powers[b];
    s.unit_without.push_back(normaliser.over_mean ? (rest.n > 0 ? s.centre + rest.d1 / rest.n : unknown)
                                                  : normaliser.without[b] / unit);
  }
  return s;
}

/// The statistics in the order of `put_moments`; `unit` in units of Scaled::unit, `sample` in Pa.
std::vector<double> values_of(const Scaled& s, const Powers& powers, double unit, double sample) {
  const Moments m = moments_of(powers, s.centre);
  const double mean = m.mean * s.unit, variance = m.variance * s.unit * s.unit;
  return {mean, mean / sample, variance / (sample * sample), m.variance / (unit * unit), m.skewness, m.excess_kurtosis};
}

void put_moments(Numbers& to, const Scaled& s, const Normaliser& normaliser, bool over_own_mean) {
  const std::vector<double> values = values_of(s, s.all, 1, normaliser.value);
  std::vector<std::vector<double>> replicates;
  for (std::size_t b = 0; b < s.powers.size(); ++b)
    if (const Powers rest = s.all - s.powers[b]; rest.n > 0)
      replicates.push_back(values_of(s, rest, s.unit_without[b], normaliser.without[b]));
  const auto e = statistics::with_errors(values, replicates);
  std::vector<std::vector<double>> means;
  for (const Powers& column : by_column(s.powers, normaliser.columns))
    if (const Powers rest = s.all - column; rest.n > 0) means.push_back({moments_of(rest, s.centre).mean * s.unit});
  put(to, "mean_Pa", statistics::with_errors({values[0]}, means)[0], "Pa", "Mean stress of the set, tension positive");
  put(to, "mean_over_sample_mean", e[1], "", "Mean stress of the set over that of the sample");
  put(to, "variance", e[2], "", "Variance of the stress over the sample's mean");
  if (over_own_mean) put(to, "own_variance", e[3], "", "Variance of the stress over the set's own mean", Trait::detail);
  put(to, "skewness", e[4], "", "Skewness of the stress");
  put(to, "excess_kurtosis", e[5], "", "Excess kurtosis of the stress; 0 for a Gaussian");
}

/// In how many blocks alike the values beyond x would lie to be as unevenly shared out as they are: (sum m)^2/sum m^2
/// of the m of them in each block.
double blocks_beyond(const BlockCounts& counts, double x, bool above) {
  double sum = 0, squares = 0;
  for (const Counts& block : counts.block) {
    const double all = statistics::total(block);
    if (!(all > 0)) continue;
    const double share = statistics::survival(counts.bins, block, x), m = all * (above ? share : 1 - share);
    sum += m;
    squares += m * m;
  }
  return squares > 0 ? sum * sum / squares : 0;
}

/// Whether one sample tells the error of the quantile x of this share: what lies beyond an outer one is a few spots of
/// high stress, and leaving one out does not tell what another sample would have there.
bool has_known_error(const BlockCounts& counts, double x, double share) {
  return std::min(share, 1 - share) > 0.02 || blocks_beyond(counts, x, share > 0.5) >= 10;
}

/// Shares and quantiles by rank; their errors from the counts, straight within a bin.
void put_ranks(Numbers& to, const Scaled& s, const BlockCounts& counts, const std::vector<double>& quantiles,
               const Normaliser& normaliser) {
  const double r = s.unit / normaliser.value;  // from units of the set to those of the sample
  std::vector<double> values{statistics::share_beyond(s.x.x, s.centre), statistics::share_beyond(s.x.x, 1 / r)};
  for (const double q : quantiles) values.push_back(q * r);
  std::vector<std::vector<double>> replicates;
  for (std::size_t b = 0; b < s.powers.size() && counts.bins.count > 0; ++b) {
    const Counts rest = counts.without(b);
    const Powers powers = s.all - s.powers[b];
    if (!(powers.n > 0)) continue;
    const double sample = normaliser.without[b] / s.unit;
    std::vector<double> row{statistics::survival(counts.bins, rest, s.centre + powers.d1 / powers.n),
                            statistics::survival(counts.bins, rest, sample)};
    for (const auto& [name, p] : quantile_shares) row.push_back(statistics::quantile(counts.bins, rest, p) / sample);
    replicates.push_back(std::move(row));
  }
  auto e = statistics::with_errors(values, replicates);
  for (std::size_t k = 0; k < quantiles.size() && counts.bins.count > 0; ++k)
    if (!has_known_error(counts, quantiles[k], quantile_shares[k].second)) e[k + 2].error = unknown;
  put(to, "fraction_above_own_mean", e[0], "", "Fraction of nodes above the set's own mean");
  put(to, "fraction_above_sample_mean", e[1], "", "Fraction of nodes above the sample's mean");
  statistics::ByName<statistics::Estimate> named;
  for (std::size_t k = 0; k < std::size(quantile_shares); ++k) named.emplace_back(quantile_shares[k].first, e[k + 2]);
  put(to, "quantiles", named, "",
      "Stress over the sample's mean below which this fraction of nodes lies; the error of an outer one is unknown "
      "where such stress is in a few places of the sample",
      Trait::detail);
}

/// Six digits are more than counting gives.
Numbers rounded(const statistics::Histogram& pdf) {
  Numbers density = Numbers::list();
  for (const double y : pdf.density) density.push_back(std::round(y * 1e6) * 1e-6);
  return {{"low", statistics::described(pdf.bins.low, "", "Lower edge of the first bin")},
          {"width", statistics::described(pdf.bins.width, "", "Width of a bin")},
          {"density", density}};
}

statistics::Curve rescaled(statistics::Curve curve, double r) {
  for (double& x : curve.x) x *= r;
  for (double& y : curve.y) y /= r;
  for (double& e : curve.error) e /= r;
  return curve;
}

/// Tail and fit of the stress over the set's own mean, and where its pdf is highest.
void put_shape(Numbers& to, const Scaled& s, const BlockCounts& counts) {
  if (const auto tail = statistics::fit_tail(s.x, counts, s.unit_without); tail.count > 0) to["tail"] = numbers(tail);
  if (Numbers fit = numbers(statistics::fit_q_gaussian(counts, s.unit_without)); !fit.empty())
    to["q_gaussian"] = std::move(fit);
  if (const auto peak = statistics::peak_of(counts.bins, counts.all); std::isfinite(peak.at))
    to["peak"] = {{"at", statistics::described(peak.at, "", "Stress over the set's own mean where its pdf is highest")},
                  {"height", statistics::described(peak.height, "", "The pdf there")}};
  if (to.contains("peak")) to["peak"].mark(Trait::detail);
}

}  // namespace

std::vector<Powers> powers_by_block(const BlockedSample& sample, double shift) {
  std::vector<Powers> powers(static_cast<std::size_t>(sample.blocks));
  for (std::size_t i = 0; i < sample.x.size(); ++i) {
    const double d = sample.x[i] - shift, d2 = d * d;
    powers[sample.block[i]] += {1, d, d2, d2 * d, d2 * d2};
  }
  return powers;
}

Numbers describe(const std::string& name, BlockedSample& sigma, const Normaliser& normaliser,
                 std::vector<std::string>& notes) {
  const std::size_t nodes = sigma.x.size();
  double square = 0;
  const double mean = mean_of(sigma);
  for (const double v : sigma.x) square += v * v / static_cast<double>(nodes);
  const bool opposite = mean * normaliser.value < 0,
             own = normaliser.over_mean && !opposite && !near_zero(mean, square);
  if (normaliser.over_mean && !own)
    notes.push_back(fmt::format(
        "the mean of {} is {}: values over it are omitted", name,
        opposite ? "of opposite sign to the sample's" : "near zero, below a tenth of its root mean square"));
  Normaliser by = normaliser;
  const Scaled s = scale(sigma, own ? normaliser : (by.over_mean = false, by));
  const auto quantiles =
      statistics::exact_quantiles(sigma.x, mapped(quantile_shares, [](const auto& share) { return share.second; }));
  const auto [low, high] = std::minmax_element(sigma.x.begin(), sigma.x.end());
  const statistics::Spread spread{*low, quantiles.front(), quantiles[4], quantiles[6], quantiles.back(), *high};
  const BlockCounts counts = statistics::count(sigma, statistics::pdf_bins(nodes, spread));
  const bool uniform = counts.bins.count == 0;
  const double r = s.unit / normaliser.value;
  Numbers j{{"count", statistics::described(nodes, "", "Nodes of the set")}};
  put_moments(j, s, normaliser, own || uniform);
  put_ranks(j, s, counts, quantiles, normaliser);
  put(j, "minimum", std::min(*low * r, *high * r), "", "Smallest stress over the sample's mean");
  put(j, "maximum", std::max(*low * r, *high * r), "", "Largest stress over the sample's mean");
  if (uniform) {
    notes.push_back(fmt::format("{} is equal in all nodes: it has no distribution", name));
    return j;
  }
  if (own) put_shape(j, s, counts);
  j["histogram"] = rounded(statistics::histogram(sigma.x, r));
  if (own) j["own_histogram"] = rounded(statistics::histogram(sigma.x, 1));
  const statistics::Curve pdf = statistics::pdf(counts);
  j["pdf"] = Numbers(rescaled(pdf, std::abs(r))).mark(Trait::curve);
  if (own) j["own_pdf"] = Numbers(pdf).mark(Trait::curve);
  return j;
}

}  // namespace arenite::stress
