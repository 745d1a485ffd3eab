#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "model/film.hpp"

namespace arenite::thermography {

struct SegmentSums;

/// Frames that hold no picture, as programs fill in for those that a camera lost: more than a hundredth of the pixels
/// are no finite numbers there and are in other frames, or all levels are 0. None in a film that has no picture at all.
class BlankFrames {
 public:
  /// The next frame.
  void see(const float* frame, std::size_t pixels);
  void see(const std::uint16_t* frame, std::size_t pixels);
  /// Of all that were seen, counted from 0.
  std::vector<std::int64_t> all() const;

 private:
  std::vector<std::size_t> missing_;  ///< pixels, by frame
  std::size_t pixels_ = 0;
};

/// Those of a film, which is read once.
std::vector<std::int64_t> blank_frames(FilmSource& film);

/// What a frame without a picture does to the sums of a pass: they are no numbers, or all pixels that are watched are 0
/// in a frame.
bool may_lack_frames(const SegmentSums& sums);

/// "frame 40 holds no picture and was left out"; empty without frames.
std::string blank_frames_sentence(const std::vector<std::int64_t>& frames);

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
