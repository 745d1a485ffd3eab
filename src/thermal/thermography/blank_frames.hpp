#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/problems.hpp"
#include "core/threads.hpp"
#include "model/film.hpp"
#include "model/lockin_maps.hpp"

namespace arenite::thermography {

struct SegmentSums;

/// Frames that hold no whole picture, as programs fill in for those that a camera lost: more than a tenth of the pixels
/// are no finite numbers there and are in other frames (more than half, where more than a tenth of the frames are so,
/// which a film cannot do without); all levels are 0, or all pixels one number that no other frame reaches; or the
/// frame is the one before once more, bit for bit, while pixels change from frame to frame around it. None in a film
/// that has no picture at all. Single pixels that fail in a frame leave it what it is.
class BlankFrames {
 public:
  /// The next frame.
  void see(const float* frame, std::size_t pixels);
  void see(const std::uint16_t* frame, std::size_t pixels);
  /// Of all that were seen, counted from 0.
  std::vector<std::int64_t> all() const;

 private:
  struct Seen {
    std::size_t missing = 0;                    ///< pixels
    bool is_constant = false, is_last = false;  ///< last: the frame before once more
    float value = 0;                            ///< of one that is constant
    double changed = 1;                         ///< share of the pixels that are not as in the frame before
    double like_step_before = 0;                ///< correlation of this change with the last one before it
  };
  template <class Pixel> void look_at(const Pixel* frame, std::size_t pixels);
  template <class Pixel> void take_step(const Pixel* frame, std::size_t pixels, Seen& now);
  bool is_filled(std::size_t frame) const;
  bool repeats(std::size_t frame) const;

  std::vector<Seen> seen_;      ///< by frame
  std::vector<float> before_;   ///< the last frame
  std::vector<float> step_;     ///< the last change from one frame to the next
  float least_ = 0, most_ = 0;  ///< of all frames that are not constant
  bool has_pictures_ = false;
  std::size_t pixels_ = 0;
};

/// Those of a film, which is read once.
std::vector<std::int64_t> blank_frames(FilmSource& film);

/// Of so many pixels, those that are numbers in no segment of a pass and those that are none in some of its frames.
struct MissingPixels {
  std::size_t pixels = 0, empty = 0, failing = 0;
};

MissingPixels missing_pixels(const SegmentSums& sums, const ThreadPool& pool);

/// What a frame without a picture does to a pass: pixels are no numbers there, or all pixels that are watched are one
/// number in a frame, or those of the frame before.
bool may_lack_frames(const SegmentSums& sums, const MissingPixels& missing);

/// Adds a sentence to the disturbances where pixels are no numbers in some frames, and one where some are none in any.
void tell_failing_pixels(const MissingPixels& missing, LockinMaps& maps);

/// "frame 40 holds no whole picture and is left out"; empty without frames.
std::string blank_frames_sentence(const std::vector<std::int64_t>& frames);

/// What `work` makes of the other frames of a film. What it refuses, InputError, names those that are left out first.
template <class Work> auto of_other_frames(const std::vector<std::int64_t>& blank, Work&& work) {
  try {
    return work();
  } catch (const InputError& error) {
    throw refusal("{}; of the others: {}", blank_frames_sentence(blank), error.what());
  }
}

/// A film without some of its frames. The others keep the times that they have.
class FilmWithout : public FilmSource {
 public:
  /// `film` must outlive it; `time` is that of all its frames (frame_times), `lost` rises.
  FilmWithout(FilmSource& film, const std::vector<std::int64_t>& lost, const std::vector<double>& time);
  const FilmInfo& info() const override { return info_; }
  void read(std::int64_t first, std::size_t count, FrameBlock& block) override;

 private:
  FilmSource& film_;
  FilmInfo info_;
  std::vector<std::int64_t> kept_;  ///< numbers of its frames in the whole film
  FrameBlock part_;
};

}  // namespace arenite::thermography
