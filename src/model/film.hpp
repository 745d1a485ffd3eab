#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace arenite {

/// What the pixels of a film are.
enum class FilmQuantity : std::uint8_t { digital_level, kelvin, unknown };

/// What a film says about itself; a text is empty and a number 0 where it does not say.
struct FilmInfo {
  int width = 0, height = 0;  ///< pixels
  std::int64_t frames = 0;
  double frame_rate = 0;   ///< Hz, that the camera was set to; where frames are stamped, `time` counts
  double integration = 0;  ///< s
  int bits = 0;            ///< significant bits of a digital level
  bool floating = false;   ///< pixels are stored as float, not as 16-bit whole numbers
  FilmQuantity quantity = FilmQuantity::unknown;
  std::string format, camera, lens, filter;
  double emissivity = 0, ambient = 0;  ///< -, K
  double band_low = 0, band_high = 0;  ///< m
  std::vector<double> time;            ///< s after the first frame, one a frame, where frames are stamped; else empty
  /// Stamp of the first frame, s from any moment that files of one recording share; NaN without stamps.
  double start = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::int64_t>
      number;  ///< of every frame, from 0, where frames are counted and some are missing; else empty
  std::vector<std::string> remarks;  ///< what a user should know about this film, each a sentence

  std::size_t pixels() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
};

/// Frames of a film in memory, one after the other, each row by row from the top left. One of the two arrays is filled:
/// `level` where pixels are 16-bit whole numbers, `value` where they are floating.
struct FrameBlock {
  std::int64_t first = 0;  ///< number of the first frame, from 0
  std::size_t frames = 0;
  std::vector<std::uint16_t> level;
  std::vector<float> value;

  /// Names the frames, and gives the array that holds such a film's pixels their size.
  void prepare(const FilmInfo& film, std::int64_t from, std::size_t count) {
    first = from;
    frames = count;
    level.resize(film.floating ? 0 : count * film.pixels());
    value.resize(film.floating ? count * film.pixels() : 0);
  }
};

/// A film that is read part by part: its frames need never be in memory together.
class FilmSource {
 public:
  virtual ~FilmSource() = default;
  virtual const FilmInfo& info() const = 0;
  /// Frames first .. first + count - 1 into `block`, whose memory is used again. Throws InputError for a damaged file.
  virtual void read(std::int64_t first, std::size_t count, FrameBlock& block) = 0;
  /// All frames, one after the other, where they are in memory already: they are looked at there and not copied. Null
  /// for films that are read, and for pixels of the other kind.
  virtual const std::uint16_t* levels_in_memory() const { return nullptr; }
  virtual const float* values_in_memory() const { return nullptr; }
};

/// Calls visit(pixels, n, some) for `count` frames from `first` on, some at a time, of which the first is number n of
/// the `count`: where they are in memory, or read into a few megabytes, which the caches hold until they are looked at.
/// Ends with false where that is false.
template <class Visit> bool read_frames(FilmSource& film, std::size_t first, std::size_t count, Visit&& visit) {
  const std::uint16_t* levels = film.levels_in_memory();
  const float* values = film.values_in_memory();
  const bool in_memory = levels || values;
  const std::size_t pixels = film.info().pixels(),
                    bytes = std::max<std::size_t>(1, pixels * (film.info().floating ? 4 : 2));
  const std::size_t at_once = std::max<std::size_t>(16, (std::size_t{in_memory ? 256U : 8U} << 20) / bytes / 16 * 16);
  FrameBlock block;
  for (std::size_t n = 0; n < count; n += at_once) {
    const std::size_t some = std::min(at_once, count - n);
    if (!in_memory) film.read(static_cast<std::int64_t>(first + n), some, block);
    const bool goes_on = levels                ? visit(levels + (first + n) * pixels, n, some)
                         : values              ? visit(values + (first + n) * pixels, n, some)
                         : block.level.empty() ? visit(block.value.data(), n, some)
                                               : visit(block.level.data(), n, some);
    if (!goes_on) return false;
  }
  return true;
}

/// A film in memory: what a virtual camera draws, and what tests look at.
struct Film : FilmSource {
  FilmInfo about;
  std::vector<std::uint16_t> level;  ///< frames x height x width, or
  std::vector<float> value;          ///< the same in floating numbers
  const FilmInfo& info() const override { return about; }
  void read(std::int64_t first, std::size_t count, FrameBlock& block) override {
    const auto begin = first * static_cast<std::ptrdiff_t>(about.pixels());
    block.prepare(about, first, count);
    std::copy_n(value.begin() + (about.floating ? begin : 0), block.value.size(), block.value.begin());
    std::copy_n(level.begin() + (about.floating ? 0 : begin), block.level.size(), block.level.begin());
  }
  const std::uint16_t* levels_in_memory() const override { return level.empty() ? nullptr : level.data(); }
  const float* values_in_memory() const override { return value.empty() ? nullptr : value.data(); }
};

}  // namespace arenite
