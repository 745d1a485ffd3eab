#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "core/vec.hpp"

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

/// How the size of an oscillation is given: the amplitude of its cosine, or twice that, from its smallest to its
/// largest value.
enum class AmplitudeConvention { amplitude, peak_to_peak };

/// "amplitude" or "peak_to_peak", as in files and JSON.
inline const char* name_of(AmplitudeConvention convention) {
  return convention == AmplitudeConvention::peak_to_peak ? "peak_to_peak" : "amplitude";
}
/// What makes a value of this convention peak to peak.
inline double to_peak_to_peak(AmplitudeConvention convention) {
  return convention == AmplitudeConvention::peak_to_peak ? 1 : 2;
}

/// A frame from which on pixels have another level, in the film's unit: by so much in all of them, and by so much
/// (standard deviation) from one to another.
struct LevelJump {
  std::size_t frame = 0;
  double common = 0, own = 0;
};

/// Changes of the level beside a film's load and the polynomial by which its pixels drift.
struct LevelChanges {
  std::vector<LevelJump> jumps;
  std::vector<double> course;  ///< that all pixels share, one value a frame; empty: none
  bool empty() const { return jumps.empty() && course.empty(); }
};

/// What a lock-in finds in every pixel of a film, in the film's unit (digital level or K), rows from the top. The
/// oscillation at the load frequency f is a_1 cos(2 pi f t - phase); `in_phase` is a_1 cos(phase - reference): signed,
/// positive where the pixel warms when the load rises.
struct LockinMaps {
  int width = 0, height = 0;
  double frequency = 0;             ///< refined, Hz
  double frequency_error = 0;       ///< standard error, Hz
  double reference_phase = 0;       ///< rad
  std::size_t frames = 0;           ///< used
  std::vector<std::int64_t> blank;  ///< frames of the film that hold no picture and were left out
  double noise_ratio =
      1;  ///< variance of the noise at the load's frequency over what the residual would be there if it were white
  /// How often noise alone has as much amplitude in one phase as the pixels have at this frequency; NaN: unknown.
  double chance = std::numeric_limits<double>::quiet_NaN();
  /// Share of the amplitude above the noise that has one phase, or its opposite, in all pixels; NaN: unknown.
  double one_phase = std::numeric_limits<double>::quiet_NaN();
  double other_frequency = 0;  ///< Hz, at which the film oscillates where the load's frequency shows nothing; 0: none
  int drift_order = 0, harmonics = 1;  ///< that were fitted
  double own_share = 1;  ///< of the variance of a pixel's noise at the load's frequency, that no other pixel shares
  double common_error = 0,
         column_error = 0;  ///< standard errors of in_phase that all pixels share, and those of a column
  std::vector<double> shared_cosine,
      shared_sine;              ///< of what was taken off every pixel of a column; empty: nothing was
  std::size_t lost_frames = 0;  ///< that no time stamp shows, but the phase of the load does
  std::vector<double> time;     ///< of all frames where some were lost so, s after the first; else as the film says
  LevelChanges levels;          ///< that were fitted to every pixel beside its drift; of the frames used
  std::vector<std::string> disturbances;  ///< what the film shows beside the load and its drift, each a sentence
  AmplitudeConvention convention = AmplitudeConvention::amplitude;  ///< of every amplitude below
  std::vector<float> mean;                                          ///< at the middle of the film
  std::vector<float> drift;                                         ///< slope of the mean, unit/s
  std::vector<float> amplitude, phase;                              ///< -, rad
  std::vector<float> in_phase, quadrature;
  std::vector<float> standard_error;   ///< of in_phase, from the residual, the noise's ratio and the normal matrix
  std::vector<float> noise_floor;      ///< amplitude that noise alone shows on the mean, sqrt(pi/2) standard errors
  std::vector<float> second_harmonic;  ///< amplitude at 2 f; empty where it was not fitted
  std::vector<float> residual;         ///< root mean square of what the fit leaves (noise, slip, plasticity)

  std::size_t size() const { return mean.size(); }
};

/// A map by its name in files and Python, with its unit for a film in kelvin.
struct LockinMap {
  const char *name, *unit;
  std::vector<float> LockinMaps::*values;
};
inline constexpr std::array lockin_maps{LockinMap{"mean", "K", &LockinMaps::mean},
                                        LockinMap{"drift", "K/s", &LockinMaps::drift},
                                        LockinMap{"amplitude", "K", &LockinMaps::amplitude},
                                        LockinMap{"phase", "rad", &LockinMaps::phase},
                                        LockinMap{"in_phase", "K", &LockinMaps::in_phase},
                                        LockinMap{"quadrature", "K", &LockinMaps::quadrature},
                                        LockinMap{"standard_error", "K", &LockinMaps::standard_error},
                                        LockinMap{"noise_floor", "K", &LockinMaps::noise_floor},
                                        LockinMap{"second_harmonic", "K", &LockinMaps::second_harmonic},
                                        LockinMap{"residual", "K", &LockinMaps::residual}};

/// Motion of every grain about its mean place at the load frequency, in pixels (y down): cosine cos(2 pi f t) + sine
/// sin(2 pi f t), t in s after the first frame.
struct GrainMotion {
  std::vector<Vec2> cosine, sine;
  std::vector<double> error;  ///< standard error of each of the four coordinates
  std::size_t size() const { return cosine.size(); }
  /// From its mean place, where the phase 2 pi f t has this cosine and sine.
  Vec2 at(std::size_t grain, double c, double s) const { return c * cosine[grain] + s * sine[grain]; }
  /// From the smallest to the largest load, which goes as cos(2 pi f t - phase).
  Vec2 way(std::size_t grain, double phase) const { return 2 * at(grain, std::cos(phase), std::sin(phase)); }
  /// Length of the way in whatever phase it is, peak to peak.
  double travel(std::size_t grain) const { return 2 * std::hypot(norm(cosine[grain]), norm(sine[grain])); }
};

/// Peak-to-peak change of temperature and stress of every grain between the smallest and the largest load, as a film
/// shows it.
struct PeakToPeak {
  std::vector<double> temperature;  ///< of the mean over the grain's centre, K
  std::vector<double> sigma_hyd;    ///< of (sigma_1 + sigma_2)/2, Pa; tension positive
  std::vector<double> error;        ///< standard error of sigma_hyd from pixel noise and position error, Pa
  std::vector<double> pixels;       ///< area that was averaged, pixels
  std::size_t size() const { return temperature.size(); }
};

}  // namespace arenite
