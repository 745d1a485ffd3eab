#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

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
  std::vector<float> weight_;       ///< of this frame's innovation and those before it
  std::map<std::uint64_t, std::vector<float>> known_;  ///< innovations of the last frames
  std::vector<float> sum_;
};

}  // namespace arenite::camera
