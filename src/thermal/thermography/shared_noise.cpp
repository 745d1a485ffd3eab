#include "thermal/thermography/shared_noise.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>

#include "core/median.hpp"
#include "model/lockin_maps.hpp"

namespace arenite::thermography {
namespace {

using Complex = std::complex<double>;

/// LoadPhasors of some pixels at the frequencies beside, pixel after pixel, without those that are far noisier than
/// most.
struct Beside {
  std::vector<std::size_t> pixel;
  std::vector<Complex> value;
  std::size_t frequencies = 0;
};

Beside phasors_beside(const SegmentSums& s, const HarmonicFit& wide, const ThreadPool& pool) {
  constexpr std::size_t most = 512;
  constexpr double wild = 10;  // times the median power
  const std::size_t sides = wide.beside.size(), chunks = (s.pixels + chunk - 1) / chunk,
                    every = std::max<std::size_t>(1, chunks / most), used = (chunks + every - 1) / every;
  Beside all{std::vector<std::size_t>(used * chunk), std::vector<Complex>(used * chunk * sides), sides};
  std::vector<double> power(used * chunk, 0.0);
  pool.for_each(used, [&](std::size_t c) {
    const std::size_t begin = c * every * chunk, count = std::min(chunk, s.pixels - begin);
    PixelFit phasors;
    fit_pixels(s, wide, wide.side(0), 2 * sides, begin, count, phasors);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t at = c * chunk + i;
      all.pixel[at] = begin + i;
      for (std::size_t k = 0; k < sides; ++k) {
        const Complex z(phasors.value[2 * k * PixelFit::run + i], phasors.value[(2 * k + 1) * PixelFit::run + i]);
        all.value[at * sides + k] = z;
        power[at] += std::norm(z);
      }
    }
  });
  const std::size_t last = std::min(chunk, s.pixels - (used - 1) * every * chunk);
  power.resize((used - 1) * chunk + last);
  const double bound = wild * median_of_finite(power);
  std::size_t calm = 0;
  for (std::size_t i = 0; i < power.size(); ++i) {
    if (!(power[i] > 0 && power[i] < bound)) continue;
    all.pixel[calm] = all.pixel[i];
    std::copy_n(all.value.data() + i * sides, sides, all.value.data() + calm++ * sides);
  }
  all.pixel.resize(calm), all.value.resize(calm * sides);
  return all;
}

/// Variances of cosine or sine: of the whole picture's shift, of a column's beside, and of a pixel's.
struct Variances {
  double common = 0, column = 0, pixel = 0;
};

Variances variances(const Beside& b, std::size_t width) {
  const auto n = static_cast<double>(b.pixel.size()), numbers = 2 * static_cast<double>(b.frequencies);
  std::vector<double> count(width);
  for (const std::size_t p : b.pixel) ++count[p % width];
  double columns = 0, square = 0;
  for (const double c : count) columns += c > 0, square += c * c;
  if (n < 4 * columns || columns < 4) return {};
  std::vector<std::size_t> column;
  for (const std::size_t p : b.pixel) column.push_back(p % width);
  double within = 0, between = 0, whole = 0;
  for (std::size_t k = 0; k < b.frequencies; ++k) {
    std::vector<Complex> mean(width);
    Complex all = 0;
    for (std::size_t i = 0; i < column.size(); ++i) mean[column[i]] += b.value[i * b.frequencies + k];
    for (std::size_t c = 0; c < width; ++c) all += mean[c] / n;
    for (std::size_t c = 0; c < width; ++c) {
      mean[c] /= std::max(count[c], 1.0);
      between += count[c] * std::norm(mean[c] - all) / numbers / (columns - 1);
    }
    double rest = 0;
    for (std::size_t i = 0; i < column.size(); ++i) rest += std::norm(b.value[i * b.frequencies + k] - mean[column[i]]);
    within += rest / numbers / (n - columns);
    whole += std::norm(all) / numbers;
  }
  Variances v{0, 0, within};
  const double chance = 5 * std::sqrt(2 / (numbers * (columns - 1))), size = (n - square / n) / (columns - 1);
  if (between > (1 + chance) * within) v.column = (between - within) / size;
  const double by_parts = v.column * square / (n * n) + within / n;
  constexpr double clear = 3;  // of two dozen numbers, once in a hundred thousand films
  if (whole > clear * by_parts) v.common = whole - by_parts;
  return v;
}

struct LoadPhasors {
  std::vector<Complex> value;
  std::vector<double> error;  ///< of cosine or sine, by the pixel's own noise and its column's
};

/// The place in the plane, not far from 0, round which pixels lie most densely.
Complex densest(const LoadPhasors& all, double reach) {
  const auto density = [&](Complex at, Complex* mean) {
    double sum = 0;
    Complex moment = 0;
    for (std::size_t p = 0; p < all.value.size(); ++p) {
      const double away = std::norm(all.value[p] - at) / (all.error[p] * all.error[p]);
      if (!(away < 16)) continue;
      const double weight = std::exp(-away / 2) / (all.error[p] * all.error[p]);
      sum += weight, moment += weight * all.value[p];
    }
    if (mean && sum > 0) *mean = moment / sum;
    return sum;
  };
  constexpr int steps = 4;
  Complex best = 0;
  double most = -1;
  for (int i = -steps; i <= steps; ++i)
    for (int j = -steps; j <= steps; ++j) {
      const Complex at(reach * i / steps, reach * j / steps);
      if (std::abs(at) > reach) continue;
      if (const double d = density(at, nullptr); d > most) most = d, best = at;
    }
  for (int turn = 0; turn < 20; ++turn) density(Complex(best), &best);
  return best;
}

/// Pixels within their noise of a value, like most of their neighbours.
std::vector<std::uint8_t> alike(const LoadPhasors& all, Complex value, std::size_t width) {
  constexpr double within = 2.5;
  constexpr int least_neighbours = 6;
  const std::size_t height = all.value.size() / width;
  std::vector<std::uint8_t> near(all.value.size()), inside(near.size());
  for (std::size_t p = 0; p < near.size(); ++p) near[p] = std::abs(all.value[p] - value) < within * all.error[p];
  for (std::size_t y = 1; y + 1 < height; ++y)
    for (std::size_t x = 1; x + 1 < width; ++x) {
      int count = 0;
      for (const std::size_t row : {y - 1, y, y + 1})
        count += near[row * width + x - 1] + near[row * width + x] + near[row * width + x + 1];
      inside[y * width + x] = near[y * width + x] && count > least_neighbours;
    }
  return inside;
}

/// What pixels off the sample show, by columns.
struct OffSample {
  Complex value;
  double pixels = 0;
  std::vector<Complex> column;
  std::vector<double> count;  ///< of pixels in the columns
};

OffSample off_sample(const LoadPhasors& all, const LockinMaps& maps) {
  const auto width = static_cast<std::size_t>(maps.width);
  const double reach = 3 * std::hypot(maps.common_error, maps.column_error);
  const Complex value = densest(all, reach);
  const std::vector<std::uint8_t> inside = alike(all, value, width);
  OffSample off{0, 0, std::vector<Complex>(width), std::vector<double>(width)};
  for (std::size_t p = 0; p < inside.size(); ++p)
    if (inside[p])
      off.value += all.value[p], ++off.pixels, off.column[p % width] += all.value[p], ++off.count[p % width];
  // Pixels of a sample lie along the load's phase; where there are as many a little further on, these are no others.
  const Complex along = std::polar(4 * median(all.error), maps.reference_phase);
  double beyond = 0;
  for (const Complex at : {value + along, value - along})
    for (const std::uint8_t each : alike(all, at, width)) beyond = beyond + each;
  const double least = std::max(100.0, 0.02 * static_cast<double>(inside.size()));
  if (off.pixels < least || off.pixels < 2 * beyond || std::abs(value) > reach) return {};
  off.value /= off.pixels;
  for (std::size_t c = 0; c < width; ++c) off.column[c] = off.count[c] > 0 ? off.column[c] / off.count[c] : off.value;
  return off;
}

}  // namespace

void measure_shared_noise(const SegmentSums& s, const HarmonicFit& wide, const ThreadPool& pool, LockinMaps& maps) {
  if (wide.beside.empty() || maps.width < 4) return;
  const Variances v = variances(phasors_beside(s, wide, pool), static_cast<std::size_t>(maps.width));
  const double factor = 2 / to_peak_to_peak(maps.convention);
  maps.common_error = factor * std::sqrt(v.common);
  maps.column_error = factor * std::sqrt(v.column);
  maps.own_share = v.pixel > 0 ? v.pixel / (v.pixel + v.column + v.common) : 1;
}

bool take_off_shared_noise(LockinMaps& maps, std::vector<double>& cosine, std::vector<double>& sine) {
  const double common = maps.common_error, columns = maps.column_error, shared = std::hypot(common, columns);
  if (!(shared > 0)) return false;
  LoadPhasors all;
  std::vector<double> own(maps.size());  // errors without what is shared
  for (std::size_t p = 0; p < maps.size(); ++p) {
    own[p] = std::sqrt(maps.own_share) * static_cast<double>(maps.standard_error[p]);
    all.value.emplace_back(cosine[p], sine[p]);
    all.error.push_back(std::hypot(own[p], columns));
  }
  const OffSample off = off_sample(all, maps);
  if (!(off.pixels > 0)) {
    maps.disturbances.push_back(
        fmt::format("pixels share noise, which shifts all of them by {:.2g} and those of a column by {:.2g} at the "
                    "load's frequency (standard deviations, in the unit of the film); there are no pixels off the "
                    "sample that show it, so that it stays, and is in the errors",
                    common, columns));
    return false;
  }
  const double noise = median(own), width = static_cast<double>(maps.width);
  double left = 0;
  maps.shared_cosine.clear(), maps.shared_sine.clear();
  for (std::size_t c = 0; c < off.column.size(); ++c) {
    const double by_noise = off.count[c] > 0 ? noise * noise / off.count[c] : 1e9 * noise * noise;
    const double trust = columns > 0 ? columns * columns / (columns * columns + by_noise) : 0;
    const Complex shift = off.value + trust * (off.column[c] - off.value);
    maps.shared_cosine.push_back(shift.real()), maps.shared_sine.push_back(shift.imag());
    left += columns * columns * (1 - trust) / width;
  }
  maps.common_error = std::hypot(noise, columns > 0 ? std::sqrt(left) : 0) / std::sqrt(off.pixels);
  maps.column_error = std::sqrt(left);
  for (std::size_t p = 0; p < maps.size(); ++p) {
    const std::size_t c = p % off.column.size();
    cosine[p] -= maps.shared_cosine[c], sine[p] -= maps.shared_sine[c];
    maps.amplitude[p] = static_cast<float>(std::hypot(cosine[p], sine[p]));
    maps.phase[p] = static_cast<float>(std::atan2(sine[p], cosine[p]));
    const float before = maps.standard_error[p];
    maps.standard_error[p] = static_cast<float>(std::hypot(own[p], maps.common_error, maps.column_error));
    if (before > 0) maps.noise_floor[p] *= maps.standard_error[p] / before;
  }
  maps.disturbances.push_back(fmt::format(
      "pixels share noise, which shifts all of them by {:.2g} and those of a column by {:.2g} at the load's frequency "
      "(standard deviations, in the unit of the film); it is taken off as {:.0f} pixels off the sample show it",
      common, columns, off.pixels));
  return true;
}

}  // namespace arenite::thermography
