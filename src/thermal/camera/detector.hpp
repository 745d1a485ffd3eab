#pragma once
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <numbers>
#include <vector>

#include "core/mapped.hpp"
#include "core/random.hpp"
#include "statistics/measured.hpp"
#include "thermal/camera/camera.hpp"

namespace arenite::camera {

/// Normal numbers of variance 1, one a pixel of a frame and one more that the whole frame shares. In each place they
/// are correlated from frame to frame as first-order autoregressive noise is; frames may be asked for in any order.
class FrameNoise {
 public:
  FrameNoise(std::size_t pixels, double correlation) : count_(pixels + 1) {
    // What is older than this is less than 1e-4 of the noise, and every frame is the same sum whichever was read before
    // it.
    double power = 0;
    for (double w = 1; w >= 1e-4; w *= correlation) {
      weight_.push_back(static_cast<float>(w));
      power += w * w;
    }
    for (float& w : weight_) w /= static_cast<float>(std::sqrt(power));
  }

  /// Of the frame that (seed, frame) names; valid until the next call.
  const std::vector<float>& of(std::uint64_t seed, std::uint64_t frame) {
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

 private:
  const std::vector<float>& innovation(std::uint64_t seed, std::uint64_t frame) {
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

  /// Quantiles of the normal law at 65 536 even probabilities, so that 16 random bits are a normal number (cut at
  /// 4.3 standard deviations, scaled to variance 1).
  static const std::vector<float>& normal_quantiles() {
    static const std::vector<float> table = [] {
      constexpr std::size_t n = 65536;
      std::vector<double> z(n);
      double sum = 0;
      for (std::size_t k = 0; k < n / 2; ++k) {
        z[k] =
            statistics::student_quantile((static_cast<double>(k) + 0.5) / n, std::numeric_limits<double>::infinity());
        z[n - 1 - k] = -z[k];
        sum += 2 * z[k] * z[k];
      }
      return mapped<float>(z, [&](double v) { return static_cast<float>(v / std::sqrt(sum / n)); });
    }();
    return table;
  }

  std::size_t count_;
  std::vector<float> weight_;                          ///< of this frame's innovation and those before it
  std::map<std::uint64_t, std::vector<float>> known_;  ///< innovations of the last frames
  std::vector<float> sum_;
};

/// Normal numbers of mean square 1 in some places each, with about as much power in every octave from once in so many
/// frames up to the Nyquist frequency, as flicker noise (1/f) has: the sum of noises that change every frame, every
/// second, every fourth and so on, each going over from one number to the next. Frames may be asked for in any order.
class FlickerNoise {
 public:
  FlickerNoise(std::size_t places, std::int64_t frames)
      : places_(places),
        octaves_(static_cast<unsigned>(std::bit_width(static_cast<std::uint64_t>(frames)))) {}

  /// Of the frame that (seed, frame) names; valid until the next call.
  const std::vector<float>& of(std::uint64_t seed, std::uint64_t frame) {
    sum_.assign(places_, 0.0F);
    const double each = 1 / std::sqrt(static_cast<double>(octaves_) + 1);
    for (unsigned k = 0; k < octaves_; ++k) {
      // Turns of 137 degrees keep the octaves from changing all together.
      const std::uint64_t length = std::uint64_t{1} << k;
      const std::uint64_t at = frame + static_cast<std::uint64_t>(0.381966 * k * static_cast<double>(length)) % length;
      const double turn = 0.5 * std::numbers::pi * static_cast<double>(at % length) / static_cast<double>(length);
      // Half of the power of what changes every frame is below the highest octave.
      add((k == 0 ? std::numbers::sqrt2 : 1) * each * std::cos(turn), numbers(seed, k, at / length));
      if (turn > 0) add(each * std::sin(turn), numbers(seed, k, at / length + 1));
    }
    return sum_;
  }

 private:
  void add(double weight, const std::vector<float>& numbers) {
    for (std::size_t i = 0; i < places_; ++i) sum_[i] += static_cast<float>(weight) * numbers[i];
  }

  const std::vector<float>& numbers(std::uint64_t seed, unsigned octave, std::uint64_t number) {
    auto& known = known_[octave];
    std::erase_if(known, [&](const auto& each) { return each.first + 1 < number || each.first > number + 1; });
    const auto [at, is_new] = known.try_emplace(number);
    if (!is_new) return at->second;
    RandomStream random(seed, Purpose::flicker, (std::uint64_t{octave} << 56) ^ number);
    for (std::size_t i = 0; i < places_; ++i) at->second.push_back(static_cast<float>(random.normal()));
    return at->second;
  }

  std::size_t places_;
  unsigned octaves_;
  std::map<unsigned, std::map<std::uint64_t, std::vector<float>>> known_;  ///< of every octave, the last few
  std::vector<float> sum_;
};

/// One detector with its pattern of gains, offsets and bad pixels, which follow from the seed alone.
class Detection {
 public:
  Detection(const Parameters& p, std::uint64_t seed)
      : noise_(static_cast<std::size_t>(p.optics.width * p.optics.height), p.detector.noise_correlation),
        flicker_(static_cast<std::size_t>(p.optics.width) + 1, p.timing.frames),
        detector_(p.detector),
        interference_(p.interference),
        width_(static_cast<std::size_t>(p.optics.width)) {
    const auto& d = p.detector;
    highest_ = static_cast<float>((1 << d.bits) - 1);
    light_per_kelvin_ = radiometry::photon_exitance_slope(p.band, Detector::reference) /
                        radiometry::photon_exitance(p.band, Detector::reference);
    const double total = d.netd * light_per_kelvin_;
    shot_ = d.netd > 0 ? std::min(1 / d.electrons, total * total) : 0;
    read_ = total * total - shot_;
    const double levels = highest_ * d.electrons / d.full_well;
    RandomStream random(seed, Purpose::detector);
    const auto pixels = static_cast<std::size_t>(p.optics.width * p.optics.height);
    for (std::size_t i = 0; i < pixels; ++i) {
      Pixel pixel{static_cast<float>(levels * (1 + d.gain_spread * random.normal())),
                  static_cast<float>(highest_ * d.offset_spread * random.normal()), 1};
      if (random.uniform() < d.bad_share) switch (random.below(3)) {
          case 0: pixel.gain *= 0.02f; break;              // dead
          case 1: pixel.offset += 1.5f * highest_; break;  // hot
          case 2: pixel.noise = 12; break;
        }
      pixel_.push_back(pixel);
    }
    RandomStream jumps(seed, Purpose::level_jump);
    if (d.jump_pattern > 0)
      for (std::size_t i = 0; i < pixels; ++i)
        own_jump_.push_back(static_cast<float>(d.jump_pattern * light_per_kelvin_ * jumps.normal()));
  }

  /// Turns light (photons over those of a black body at the reference) into levels. `warmer` is the drift of the scene,
  /// K, at `time` (s); (seed, frame) name the draw of the noise.
  void record(const std::vector<float>& light, double warmer, double time, std::uint64_t seed, std::uint64_t frame,
              std::uint16_t* level) {
    const std::vector<float>& normal = noise_.of(seed, frame);
    const float drift = static_cast<float>(1 + warmer * light_per_kelvin_);
    const auto shot = static_cast<float>(shot_), read = static_cast<float>(read_);
    const bool jumped = time >= detector_.jump_time, own = jumped && !own_jump_.empty();
    const float common =
        in_light(detector_.common_noise) * normal[light.size()] + (jumped ? in_light(detector_.jump) : 0);
    share_by_columns(common, seed, frame);
    float line = 0;
    for (std::size_t i = 0; i < light.size(); ++i) {
      if (i % width_ == 0 && interference_.amplitude > 0) {
        const double cycles = interference_.frequency * time + interference_.advance * static_cast<double>(i / width_);
        line =
            static_cast<float>(interference_.amplitude * light_per_kelvin_ * std::cos(2 * std::numbers::pi * cycles));
      }
      const Pixel& pixel = pixel_[i];
      const float seen = light[i] * drift + (shared_[i % width_] + line) + (own ? own_jump_[i] : 0);
      const float noisy = seen + pixel.noise * std::sqrt(shot * std::max(seen, 0.0f) + read) * normal[i];
      level[i] = static_cast<std::uint16_t>(std::lround(std::clamp(pixel.gain * noisy + pixel.offset, 0.0f, highest_)));
    }
  }

 private:
  struct Pixel {
    float gain, offset, noise;
  };  ///< levels per unit of light, levels, times the others' noise

  float in_light(double kelvin) const { return static_cast<float>(kelvin * light_per_kelvin_); }

  /// What the pixels of every column share in a frame, beside what all of them do.
  void share_by_columns(float common, std::uint64_t seed, std::uint64_t frame) {
    shared_.assign(width_, common);
    if (detector_.common_flicker <= 0 && detector_.column_flicker <= 0) return;
    const std::vector<float>& flicker = flicker_.of(seed, frame);
    for (std::size_t c = 0; c < width_; ++c)
      shared_[c] +=
          in_light(detector_.common_flicker) * flicker[width_] + in_light(detector_.column_flicker) * flicker[c];
  }

  std::vector<Pixel> pixel_;
  std::vector<float> own_jump_;  ///< of every pixel, in light; empty: there is none
  FrameNoise noise_;
  FlickerNoise flicker_;
  Detector detector_;
  Interference interference_;
  std::size_t width_;
  std::vector<float> shared_;                          ///< by the pixels of a column in the frame at hand, in light
  double light_per_kelvin_ = 0, shot_ = 0, read_ = 0;  ///< of 1; variance per light; variance: in light
  float highest_ = 0;
};

}  // namespace arenite::camera
