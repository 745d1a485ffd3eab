#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "thermal/camera/camera.hpp"

namespace arenite::camera {

/// Normal numbers of variance 1, one a pixel of a frame and one more that the whole frame shares. In each place they are
/// correlated from frame to frame as first-order autoregressive noise is; frames may be asked for in any order.
class FrameNoise {
 public:
  FrameNoise(std::size_t pixels, double correlation);

  /// Of the frame that (seed, frame) names; valid until the next call.
  const std::vector<float>& of(std::uint64_t seed, std::uint64_t frame);

 private:
  const std::vector<float>& innovation(std::uint64_t seed, std::uint64_t frame);

  std::size_t count_;
  std::vector<float> weight_;                          ///< of this frame's innovation and those before it
  std::map<std::uint64_t, std::vector<float>> known_;  ///< innovations of the last frames
  std::vector<float> sum_;
};

/// One detector with its pattern of gains, offsets and bad pixels, which follow from the seed alone.
class Detection {
 public:
  Detection(const Parameters& parameters, std::uint64_t seed);

  /// Turns light (photons over those of a black body at 296 K) into levels. `warmer` is the drift of the scene, K, at
  /// `time` (s); (seed, frame) name the draw of the noise.
  void record(const std::vector<float>& light, double warmer, double time, std::uint64_t seed, std::uint64_t frame, std::uint16_t* level);

 private:
  struct Pixel {
    float gain, offset, noise;
  };  ///< levels per unit of light, levels, times the others' noise
  std::vector<Pixel> pixel_;
  FrameNoise noise_;
  Interference interference_;
  std::size_t width_;
  double common_ = 0;                                  ///< in light
  double light_per_kelvin_ = 0, shot_ = 0, read_ = 0;  ///< of 1; variance per light; variance: in light
  float highest_ = 0;
};

/// Numbers of the frames that were not dropped; the first and the last always are there.
std::vector<std::int64_t> frames_taken(const Timing& timing, std::uint64_t seed);

}  // namespace arenite::camera
