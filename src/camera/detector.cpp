#include "camera/detector.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/random.hpp"

namespace arenite::camera {
namespace {

/// Quantiles of the normal law at 65 536 even probabilities, so that 16 random bits are a normal number (cut at
/// 4.3 standard deviations, scaled to variance 1).
const std::vector<float>& normal_quantiles() {
  static const std::vector<float> table = [] {
    constexpr int n = 65536;
    std::vector<double> z(n);
    double x = -4.4, sum = 0;
    for (int k = 0; k < n / 2; ++k) {
      const double p = (k + 0.5) / n;
      for (int newton = 0; newton < 60; ++newton) {
        const double error = 0.5 * std::erfc(-x / std::sqrt(2.0)) - p;
        const double density = std::exp(-0.5 * x * x) / std::sqrt(2 * 3.14159265358979323846);
        const double step = std::clamp(error / density, -0.1, 0.1);
        x -= step;
        if (std::abs(step) < 1e-13) break;
      }
      z[static_cast<std::size_t>(k)] = x;
      z[static_cast<std::size_t>(n - 1 - k)] = -x;
      sum += 2 * x * x;
    }
    std::vector<float> scaled;
    for (const double v : z) scaled.push_back(static_cast<float>(v / std::sqrt(sum / n)));
    return scaled;
  }();
  return table;
}

enum class Defect { none, dead, hot, noisy };

Defect defect_of(RandomStream& random, double share) {
  if (random.uniform() >= share) return Defect::none;
  return std::array{Defect::dead, Defect::hot, Defect::noisy}[random.below(3)];
}

}  // namespace

Detection::Detection(const Parameters& p, std::uint64_t seed) {
  const auto& d = p.detector;
  highest_ = static_cast<float>((1 << d.bits) - 1);
  light_per_kelvin_ = radiometry::photon_exitance_slope(p.band, 296) / radiometry::photon_exitance(p.band, 296);
  const double total = d.netd * light_per_kelvin_;
  shot_ = d.netd > 0 ? std::min(1 / d.electrons, total * total) : 0;
  read_ = total * total - shot_;
  const double levels = highest_ * d.electrons / d.full_well;
  RandomStream random(seed, Purpose::detector);
  const auto pixels = static_cast<std::size_t>(p.optics.width * p.optics.height);
  for (std::size_t i = 0; i < pixels; ++i) {
    Pixel pixel{static_cast<float>(levels * (1 + d.gain_spread * random.normal())),
                static_cast<float>(highest_ * d.offset_spread * random.normal()), 1};
    switch (defect_of(random, d.bad_share)) {
      case Defect::none: break;
      case Defect::dead: pixel.gain *= 0.02f; break;
      case Defect::hot: pixel.offset += 1.5f * highest_; break;
      case Defect::noisy: pixel.noise = 12; break;
    }
    pixel_.push_back(pixel);
  }
}

void Detection::record(const std::vector<float>& light, double warmer, std::uint64_t seed, std::uint64_t frame, std::uint16_t* level) const {
  const auto& quantile = normal_quantiles();
  RandomStream random(seed, Purpose::camera_noise, frame);
  const float drift = static_cast<float>(1 + warmer * light_per_kelvin_);
  const auto shot = static_cast<float>(shot_), read = static_cast<float>(read_);
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < light.size(); ++i) {
    bits = i % 4 == 0 ? random.bits() : bits >> 16;
    const Pixel& pixel = pixel_[i];
    const float seen = light[i] * drift;
    const float noisy = seen + pixel.noise * std::sqrt(shot * seen + read) * quantile[bits & 0xffff];
    level[i] = static_cast<std::uint16_t>(std::lround(std::clamp(pixel.gain * noisy + pixel.offset, 0.0f, highest_)));
  }
}

std::vector<std::int64_t> frames_taken(const Timing& timing, std::uint64_t seed) {
  std::vector<std::int64_t> taken;
  RandomStream random(seed, Purpose::dropped_frames);
  for (std::int64_t k = 0; k < timing.frames; ++k) {
    const bool dropped = random.uniform() < timing.dropped;
    if (!dropped || k == 0 || k == timing.frames - 1) taken.push_back(k);
  }
  return taken;
}

}  // namespace arenite::camera
