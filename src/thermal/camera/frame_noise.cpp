#include "thermal/camera/frame_noise.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

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

}  // namespace

FrameNoise::FrameNoise(std::size_t pixels, double correlation) : count_(pixels + 1) {
  // What is older than this is less than 1e-4 of the noise, and every frame is the same sum whichever was read before it.
  double power = 0;
  for (double w = 1; w >= 1e-4; w *= correlation) {
    weight_.push_back(static_cast<float>(w));
    power += w * w;
  }
  for (float& w : weight_) w /= static_cast<float>(std::sqrt(power));
}

const std::vector<float>& FrameNoise::innovation(std::uint64_t seed, std::uint64_t frame) {
  const auto [at, is_new] = known_.try_emplace(frame);
  if (!is_new) return at->second;
  const auto& quantile = normal_quantiles();
  RandomStream random(seed, Purpose::camera_noise, frame);
  std::uint64_t bits = 0;
  at->second.resize(count_);
  for (std::size_t i = 0; i < count_; ++i) {
    bits = i % 4 == 0 ? random.bits() : bits >> 16;
    at->second[i] = quantile[bits & 0xffff];
  }
  return at->second;
}

const std::vector<float>& FrameNoise::of(std::uint64_t seed, std::uint64_t frame) {
  const std::uint64_t first = frame - (weight_.size() - 1);  // before the first frame of a film the numbers wrap
  std::erase_if(known_, [&](const auto& each) { return each.first - first >= weight_.size(); });
  if (weight_.size() == 1) return innovation(seed, frame);
  sum_.assign(count_, 0.0f);
  for (std::size_t k = 0; k < weight_.size(); ++k) {
    const std::vector<float>& e = innovation(seed, frame - k);
    for (std::size_t i = 0; i < count_; ++i) sum_[i] += weight_[k] * e[i];
  }
  return sum_;
}

}  // namespace arenite::camera
