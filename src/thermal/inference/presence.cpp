#include "thermal/inference/presence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>

#include "core/mapped.hpp"
#include "core/median.hpp"
#include "statistics/correlation.hpp"

namespace arenite::inference {
namespace {

constexpr double strong = 0.3;  // mean forces; from here on noise takes no contact for another
/// Borders of the steps of contacts that are there, in mean forces. The first ones are those of contacts that lost
/// their force and are gone, too.
constexpr std::array there{-1.5, -0.3, 0.0, 0.3, 0.6, 1.0, 1.5, 2.2, 3.0, 6.0};
constexpr std::size_t steps_gone = 2, steps_there = there.size() - 1, classes = 1 + steps_gone + steps_there;
/// Share of contacts that are there whose overlap follows no law: grains that are not round, centres that are wrong.
constexpr double lawless = 0.03;

double below(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }
double bell(double x, double deviation) {
  return std::exp(-0.5 * x * x / (deviation * deviation)) / (deviation * std::sqrt(2 * std::numbers::pi));
}
/// Overlap of contacts of one kind: at + slope force, +- spread, in widest gaps and mean forces.
struct OverlapLaw {
  double at = 0, slope = 0, spread = 0.25;
};

/// The evidence in mean forces and widest gaps.
ContactEvidence scaled(const ContactEvidence& e) {
  double sum = 0, count = 0;
  for (std::size_t c = 0; c < e.fn.size(); ++c)
    if (e.fn[c] > 3 * e.fn_error[c]) sum += e.fn[c], ++count;
  const double mean = count > 0 && sum > 0 ? sum / count : 1, gap = e.widest_gap > 0 ? e.widest_gap : 1;
  ContactEvidence s{{}, {}, {}, e.kind, 1};
  for (std::size_t c = 0; c < e.fn.size(); ++c) {
    s.fn.push_back(std::clamp(e.fn[c] / mean, there.front(), there.back()));
    s.fn_error.push_back(std::max(e.fn_error[c] / mean, 1e-6));
    s.overlap.push_back(e.overlap[c] / gap);
  }
  return s;
}

/// A straight line through the strong contacts of every kind that has a dozen; other kinds are at 0, spread as the
/// widest.
std::map<int, OverlapLaw> overlap_laws(const ContactEvidence& s) {
  std::map<int, std::vector<std::size_t>> of;
  for (std::size_t c = 0; c < s.fn.size(); ++c) {
    of[s.kind[c]];
    if (s.fn[c] > strong && s.fn[c] > 4 * s.fn_error[c]) of[s.kind[c]].push_back(c);
  }
  std::map<int, OverlapLaw> laws;
  double widest = 0;
  for (const auto& [kind, contacts] : of) {
    if (contacts.size() < 12) continue;
    const auto of_each = [&contacts = contacts](const std::vector<double>& values) {
      return mapped(contacts, [&](std::size_t c) { return values[c]; });
    };
    const auto m = statistics::second_moments(of_each(s.fn), of_each(s.overlap));
    OverlapLaw law;
    law.slope = m.xx > 0 ? m.xy / m.xx : 0;
    law.at = m.mean_y - law.slope * m.mean_x;
    auto rest = mapped(contacts, [&](std::size_t c) { return std::abs(s.overlap[c] - law.at - law.slope * s.fn[c]); });
    law.spread = std::max(0.02, median(std::move(rest)) / median_of_normal_size);
    widest = std::max(widest, law.spread);
    laws[kind] = law;
  }
  for (const auto& [kind, contacts] : of)
    if (!laws.contains(kind)) laws[kind] = {0, 0, widest > 0 ? widest : 0.25};
  return laws;
}

class Mixture {
 public:
  explicit Mixture(const ContactEvidence& e) : s_(scaled(e)) {
    const std::map<int, OverlapLaw> laws = overlap_laws(s_);
    for (std::size_t c = 0; c < s_.fn.size(); ++c) overlap_.push_back(likelihood_of_overlap(c, laws.at(s_.kind[c])));
    share_.fill(0.75 / static_cast<double>(steps_there));
    share_[0] = 0.15;
    std::fill_n(share_.begin() + 1, steps_gone, 0.1 / static_cast<double>(steps_gone));
    force_.resize(overlap_.size());
    weigh_forces();
  }

  Presence fitted() {
    constexpr int rounds = 200;
    Presence p;
    for (int round = 0; round < rounds; ++round) improve();
    for (std::size_t c = 0; c < s_.fn.size(); ++c) {
      const auto posterior = posteriors(c);
      p.probability.push_back(std::accumulate(posterior.begin() + 1 + steps_gone, posterior.end(), 0.0));
      p.idle.push_back(posterior[0]);
      p.expected += p.probability.back();
      p.error += p.probability.back() * (1 - p.probability.back());
    }
    p.error = std::sqrt(p.error);
    p.error_scale = scale_;
    return p;
  }

 private:
  using Classes = std::array<double, classes>;

  /// How likely the overlap of contact c is in every class.
  Classes likelihood_of_overlap(std::size_t c, const OverlapLaw& law) const {
    const double over = s_.overlap[c] - law.at;
    Classes p;
    std::fill_n(p.begin(), 1 + steps_gone, below(-over / law.spread));  // gaps from 0 to the widest are as likely
    for (std::size_t k = 0; k < steps_there; ++k) {
      const double force = std::max(0.0, std::clamp(s_.fn[c], there[k], there[k + 1]));
      p[1 + steps_gone + k] = (1 - lawless) * bell(over - law.slope * force, law.spread) + lawless;
    }
    return p;
  }

  /// How likely the force of contact c is in every class at the present scale of errors.
  Classes likelihood_of_force(std::size_t c) const {
    const double f = s_.fn[c], error = scale_ * s_.fn_error[c];
    std::array<double, there.size()> under;
    for (std::size_t k = 0; k < there.size(); ++k) under[k] = below((f - there[k]) / error);
    const auto step = [&](std::size_t k) {
      return (under[k] - under[k + 1]) / (there[k + 1] - there[k]);
    };  // density of even forces that noise blurs
    Classes p;
    p[0] = bell(f, error);
    for (std::size_t k = 0; k < steps_gone; ++k) p[1 + k] = step(k);
    for (std::size_t k = 0; k < steps_there; ++k) p[1 + steps_gone + k] = step(k);
    return p;
  }

  void weigh_forces() {
    for (std::size_t c = 0; c < force_.size(); ++c) force_[c] = likelihood_of_force(c);
  }

  /// Share of every class in contact c.
  Classes posteriors(std::size_t c) const {
    const double f = s_.fn[c];
    Classes p;
    for (std::size_t k = 0; k < classes; ++k) p[k] = share_[k] * force_[c][k] * overlap_[c][k];
    const double sum = std::accumulate(p.begin(), p.end(), 0.0);
    if (sum > 0) {
      for (double& v : p) v /= sum;
    } else {  // farther from every class than numbers reach
      p.fill(0);
      p[f > 0 ? classes - 1 : 0] = 1;
    }
    return p;
  }

  void improve() {
    Classes sums{};
    double squares = 0, none = 0;
    for (std::size_t c = 0; c < s_.fn.size(); ++c) {
      const Classes p = posteriors(c);
      for (std::size_t k = 0; k < classes; ++k) sums[k] += p[k];
      const double z = s_.fn[c] / s_.fn_error[c];
      squares += p[0] * std::min(z * z, 25.0), none += p[0];
    }
    for (std::size_t k = 0; k < classes; ++k) share_[k] = sums[k] / static_cast<double>(s_.fn.size());
    const double scale = none > 5 ? std::clamp(std::sqrt(squares / none), 0.3, 5.0) : scale_;
    if (std::exchange(scale_, scale) != scale) weigh_forces();
  }

  ContactEvidence s_;
  std::vector<Classes> overlap_, force_;  // how likely they are, of every contact
  Classes share_{};
  double scale_ = 1;
};

}  // namespace

Presence presence(const ContactEvidence& evidence) {
  if (evidence.fn.empty()) return {};
  return Mixture(evidence).fitted();
}

std::vector<std::uint8_t> taken_as_present(const Presence& presence) {
  const auto order = ordered_by(presence.probability.size(), [&](std::size_t c) { return -presence.probability[c]; });
  std::vector<std::uint8_t> out(order.size(), 0);
  const auto many = static_cast<std::size_t>(std::lround(presence.expected));
  for (std::size_t k = 0; k < std::min(many, order.size()); ++k) out[order[k]] = 1;
  return out;
}

}  // namespace arenite::inference
