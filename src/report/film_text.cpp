#include "report/film_text.hpp"

#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "core/median.hpp"
#include "io/film/film.hpp"
#include "statistics/numbers_text.hpp"
#include "thermal/thermography/frame_statistics.hpp"

namespace arenite::report {
namespace {

using statistics::described;

/// Of the values that are numbers.
float extreme(const std::vector<float>& values, float (*of)(float, float)) {
  return std::accumulate(values.begin(), values.end(), std::numeric_limits<float>::quiet_NaN(), of);
}

constexpr const char* quantities[] = {"digital_level", "kelvin", "unknown"};  // in the order of FilmQuantity

}  // namespace

Numbers film_summary(FilmSource& source, std::size_t most_frames) {
  const FilmInfo& film = source.info();
  const io::FrameIntervals times = io::frame_intervals(film);
  const thermography::FrameStatistics pixels = thermography::frame_statistics(source, most_frames);
  const thermography::Doubtful doubtful = thermography::doubtful(pixels, film.bits);
  const auto known = [](double value, const char* unit, const char* sentence) {
    return described(value > 0 ? Numbers(value) : Numbers(), unit, sentence);
  };
  const auto level = [](auto value) { return Numbers(static_cast<double>(value)); };
  Numbers j{
      {"format", film.format},
      {"width", described(film.width, "", "Pixels along x")},
      {"height", described(film.height, "", "Pixels along y")},
      {"frames", described(film.frames, "", "Frames of the film")},
      {"frame_rate_Hz", known(film.frame_rate, "Hz", "Frame rate")},
      {"integration_s", known(film.integration, "s", "Integration time of a frame")},
      {"camera", film.camera},
      {"lens", film.lens},
      {"filter", film.filter},
      {"bits", described(film.bits, "", "Bits of a pixel")},
      {"floating", described(film.floating, "", "Whether pixels are floating-point numbers")},
      {"quantity", described(quantities[static_cast<std::size_t>(film.quantity)], "", "Quantity of the pixel values")},
      {"emissivity", known(film.emissivity, "", "Emissivity set in the camera")},
      {"ambient_K", known(film.ambient, "K", "Temperature of the surroundings set in the camera")},
      {"band_low_m", known(film.band_low, "m", "Shortest wavelength of its band")},
      {"band_high_m", known(film.band_high, "m", "Longest wavelength of its band")},
      {"stamped", described(!film.time.empty(), "", "Whether frames have time stamps")},
      {"frame_interval_s", known(times.interval, "s", "Time between two frames")},
      {"duration_s", known(times.duration, "s", "Time from the first frame to the last")},
      {"dropped_frames", described(times.dropped, "", "Missing frames")}};
  j["gaps_before_frames"] = described(times.gap, "", "Frames preceded by missing ones");
  j["pixels"] = {
      {"frames_read", described(pixels.frames, "", "Number of first frames evaluated")},
      {"least", described(level(extreme(pixels.least, std::fmin)), "", "Smallest value")},
      {"most", described(level(extreme(pixels.most, std::fmax)), "", "Largest value")},
      {"median", described(median_of_finite(pixels.mean), "", "Median of the pixels' means")},
      {"median_noise", described(median_of_finite(pixels.noise), "", "Median noise of a pixel, from frame to frame")},
      {"blank_frames",
       described(pixels.blank, "",
                 "Frames beside these that hold no whole picture: no numbers, one, or those of the frame before")},
      {"constant", described(doubtful.constant, "", "Pixels constant in time (dead)")},
      {"saturated", described(doubtful.saturated, "", "Pixels that reach the top of the range")}};
  j["remarks"] = film.remarks;
  return j;
}

std::string film_text(const FilmResult& r) {
  return r.outcome + "\n" + to_text(r.numbers, {"texture stresses sectors"}) +
         rows_of(r.numbers, "stresses.*.mean_Pa stresses.*.P0 stresses.*.beta");
}

Numbers film_numbers(const FilmResult& r) {
  Numbers j = r.numbers;
  const Provenance& p = r.provenance;
  j["provenance"] = {{"version", p.version}, {"stage", p.stage}, {"input_hash", p.input_hash}, {"recipe", p.recipe}};
  j["outcome"] = r.outcome;
  return j;
}

}  // namespace arenite::report
