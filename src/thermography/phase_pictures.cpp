#include "thermography/phase_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/threads.hpp"
#include "thermography/frame_times.hpp"
#include "thermography/resample.hpp"

namespace arenite::thermography {

namespace {

struct Bins {
  std::vector<std::size_t> of_frame;
  std::vector<double> frames, late, cosine, sine, cosine2, sine2;  ///< late: mean time after the film's middle, s
};

Bins sort_frames(const std::vector<double>& time, double frequency, std::size_t parts) {
  Bins bins;
  std::vector<std::size_t> name(parts, parts);
  const double middle = (time.front() + time.back()) / 2;
  for (const double t : time) {
    const double cycles = frequency * t, angle = 2 * std::numbers::pi * cycles;
    const auto part = std::min(parts - 1, static_cast<std::size_t>((cycles - std::floor(cycles)) * static_cast<double>(parts)));
    if (name[part] == parts) {
      name[part] = bins.frames.size();
      for (auto* each : {&bins.frames, &bins.late, &bins.cosine, &bins.sine, &bins.cosine2, &bins.sine2}) each->push_back(0);
    }
    const std::size_t b = name[part];
    bins.of_frame.push_back(b);
    bins.frames[b] += 1;
    bins.late[b] += t - middle;
    bins.cosine[b] += std::cos(angle);
    bins.sine[b] += std::sin(angle);
    bins.cosine2[b] += std::cos(2 * angle);
    bins.sine2[b] += std::sin(2 * angle);
  }
  for (auto* each : {&bins.late, &bins.cosine, &bins.sine, &bins.cosine2, &bins.sine2})
    for (std::size_t b = 0; b < each->size(); ++b) (*each)[b] /= bins.frames[b];
  return bins;
}

template <class T>
void add(const T* frame, const std::vector<float>& mean, float* sum, std::size_t begin, std::size_t end) {
  for (std::size_t p = begin; p < end; ++p) sum[p] += static_cast<float>(frame[p]) - mean[p];
}

/// Pixels without a value would spoil their lines in the spline.
void finish(const LockinMaps& maps, const Bins& bins, std::size_t b, float* picture) {
  for (std::size_t p = 0; p < maps.size(); ++p) {
    picture[p] = maps.mean[p] + picture[p] / static_cast<float>(bins.frames[b]) - maps.drift[p] * static_cast<float>(bins.late[b]);
    if (!std::isfinite(picture[p])) picture[p] = p > 0 ? picture[p - 1] : 0;
  }
  spline_coefficients(picture, maps.width, maps.height);
}

}  // namespace

PhasePictures phase_pictures(FilmSource& film, const LockinMaps& maps, const LockinOptions& options, std::size_t parts) {
  const std::vector<double> time = frame_times(film.info(), options.frame_rate);
  Bins bins = sort_frames(time, maps.frequency, parts);
  PhasePictures result{maps.width, maps.height, bins.frames, bins.cosine, bins.sine, bins.cosine2, bins.sine2, {}};
  const std::size_t pixels = result.pixels();
  result.spline.resize(result.size() * pixels);
  const Team team(options.threads);
  const std::size_t at_once = std::max<std::size_t>(1, (std::size_t{8} << 20) / (pixels * (film.info().floating ? 4 : 2)));
  FrameBlock block;
  for (std::size_t n = 0; n < time.size(); n += at_once) {
    const std::size_t count = std::min(at_once, time.size() - n);
    film.read(static_cast<std::int64_t>(n), count, block);
    team.for_ranges(pixels, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = 0; k < count; ++k) {
        float* sum = result.spline.data() + bins.of_frame[n + k] * pixels;
        if (film.info().floating) add(block.value.data() + k * pixels, maps.mean, sum, begin, end);
        else add(block.level.data() + k * pixels, maps.mean, sum, begin, end);
      }
    });
    if (options.progress && !options.progress(static_cast<double>(n + count) / static_cast<double>(time.size()))) return {};
  }
  team.for_each(result.size(), [&](std::size_t b) { finish(maps, bins, b, result.spline.data() + b * pixels); });
  return result;
}

std::vector<float> picture_of(const PhasePictures& pictures, std::size_t k) {
  std::vector<float> values;
  values.reserve(pictures.pixels());
  for (int row = 0; row < pictures.height; ++row)
    for (int column = 0; column < pictures.width; ++column)
      values.push_back(static_cast<float>(Resampled(pictures.width, pictures.height, column, row).of(pictures.picture(k))));
  return values;
}

}  // namespace arenite::thermography
