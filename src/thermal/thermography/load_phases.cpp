#include "thermal/thermography/load_phases.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <utility>

#include "statistics/correlation.hpp"
#include "thermal/thermography/harmonic_fit.hpp"
#include "thermal/thermography/lockin.hpp"
#include "thermal/thermography/segment_phasors.hpp"

namespace arenite::thermography {
namespace {

using Complex = std::complex<double>;
using statistics::Matrix;

/// SegmentPhasors of some thousand pixels in all segments, each over its pixel's spread.
struct SegmentPhasors {
  std::vector<std::size_t> pixel;
  std::vector<std::vector<Complex>> value;  ///< by pixel and segment
};

SegmentPhasors phasors_in_segments(const SegmentSums& s) {
  std::vector<Matrix> fits;
  for (std::size_t k = 0; k < s.segments(); ++k) fits.push_back(segment_fit(s, k));
  SegmentPhasors all;
  Matrix one(2 * s.segments(), 2);
  for_some_chunks(s, 64, [&](std::size_t begin, std::size_t count) {
    for (std::size_t p = begin; p < begin + count; ++p) {
      if (!phasors_of(s, fits, p, one, 0)) continue;
      all.pixel.push_back(p);
      auto& value = all.value.emplace_back();
      for (std::size_t k = 0; k < s.segments(); ++k) value.emplace_back(one(k, 0), one(k, 1));
    }
  });
  return all;
}

/// What the pixels of every segment have in common beside a pattern that is the same in all: the first principal
/// component.
std::vector<Complex> common_phasors(const SegmentPhasors& all, std::size_t segments) {
  std::vector<Complex> common(segments, 1), next(segments);
  for (int turn = 0; turn < 50; ++turn) {
    std::fill(next.begin(), next.end(), 0);
    for (const auto& z : all.value) {
      Complex along = 0;
      for (std::size_t k = 0; k < segments; ++k) along += z[k] * std::conj(common[k]);
      for (std::size_t k = 0; k < segments; ++k) next[k] += std::conj(along) * z[k];
    }
    double length = 0;
    for (const Complex& each : next) length += std::norm(each);
    if (!(length > 0)) return {};
    double change = 0;
    for (std::size_t k = 0; k < segments; ++k) {
      next[k] /= std::sqrt(length);
      change += std::norm(next[k] - common[k]);
    }
    std::swap(common, next);
    if (change < 1e-26) break;  // rounding
  }
  return common;
}

/// One over the root of the squares of a pixel's values about their means in the segments.
double sharpness(const SegmentSums& s, std::size_t p) {
  const SegmentView view = s.view();
  double spread = 0;
  for (std::size_t k = 0; k < s.segments(); ++k) {
    const auto sum = static_cast<double>(view.sums[view.at(p, k, 0)]);
    spread += static_cast<double>(view.sums[view.at(p, k, s.functions + 1)]) - sum * sum / s.frames_of(k);
  }
  return 1 / std::sqrt(spread);
}

/// The pattern of the load in pixels over their spreads, one over which is `sharp`. Where pixels differ enough it is
/// made free of what all of them share, which has the pattern of `sharp`.
std::vector<double> contrast(std::vector<double> pattern, const std::vector<double>& sharp) {
  double mixed = 0, sum = 0, all = 0, own = 0;
  for (std::size_t i = 0; i < sharp.size(); ++i)
    mixed += pattern[i] * sharp[i], sum += sharp[i] * sharp[i], all += pattern[i] * pattern[i];
  const std::vector<double> whole = pattern;
  for (std::size_t i = 0; i < sharp.size(); ++i) {
    pattern[i] -= mixed / sum * sharp[i];
    own += pattern[i] * pattern[i];
  }
  return own > 0.02 * all ? pattern : whole;
}

}  // namespace

LoadPhases load_phases(const SegmentSums& s) {
  LoadPhases phases;
  if (!segments_show_load(s) || s.segments() < 8) return phases;
  const SegmentPhasors all = phasors_in_segments(s);
  const std::vector<Complex> common = common_phasors(all, s.segments());
  if (common.empty()) return phases;
  std::vector<double> cosine, sine, pattern, sharp;
  for (std::size_t i = 0; i < all.pixel.size(); ++i) {
    Complex along = 0;
    for (std::size_t k = 0; k < s.segments(); ++k) along += all.value[i][k] * std::conj(common[k]);
    cosine.push_back(along.real()), sine.push_back(along.imag());
    sharp.push_back(sharpness(s, all.pixel[i]));
  }
  const double phase = reference_phase(cosine, sine);
  for (std::size_t i = 0; i < sharp.size(); ++i)
    pattern.push_back(std::cos(phase) * cosine[i] + std::sin(phase) * sine[i]);
  pattern = contrast(std::move(pattern), sharp);
  double length = 0, power = 0, signal = 0, last = 0;
  for (const double a : pattern) length += a * a;
  for (std::size_t k = 0; k < s.segments(); ++k) {
    Complex load = 0;
    for (std::size_t i = 0; i < pattern.size(); ++i)
      load += pattern[i] * all.value[i][k], power += std::norm(all.value[i][k]);
    signal += std::norm(load) / length;
    const double steady = 2 * std::numbers::pi * s.frequency * s.centre[k], ahead = -std::arg(load) - steady,
                 turns = std::round((last - ahead) / (2 * std::numbers::pi));  // of e^(-i w t)
    last = ahead + 2 * std::numbers::pi * turns;
    phases.segment.push_back(steady + last);
  }
  const auto m = statistics::second_moments(s.centre, phases.segment);
  phases.wander = std::sqrt(std::max(0.0, m.yy - m.xy * m.xy / m.xx) / static_cast<double>(s.segments()));
  phases.noise = std::sqrt(std::max(0.0, power - signal) / (2 * static_cast<double>(pattern.size()) * signal));
  phases.pixel = all.pixel;
  for (std::size_t i = 0; i < pattern.size(); ++i) phases.weight.push_back(pattern[i] * sharp[i]);
  return phases;
}

}  // namespace arenite::thermography
