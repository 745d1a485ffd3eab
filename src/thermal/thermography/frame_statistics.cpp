#include "thermal/thermography/frame_statistics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "core/mapped.hpp"
#include "core/median.hpp"
#include "model/image.hpp"
#include "thermal/thermography/blank_frames.hpp"

namespace arenite::thermography {
namespace {

constexpr double to_deviation = 1.4826;  // of a normal law, per median of absolute deviations
constexpr double limit = 8;              // in these deviations: how far a good pixel may stand out

struct Robust {
  double middle = 0, deviation = 0;
};

Robust robust(std::vector<double> x) {
  if (x.empty()) return {};
  const double middle = median_in_place(x.begin(), x.end());
  for (double& v : x) v = std::abs(v - middle);
  return {middle, to_deviation * median_in_place(x.begin(), x.end())};
}

/// How far a pixel lies beyond all but two of its neighbours (one in a corner of the picture), and how these scatter.
struct Standing {
  double beyond = 0, scatter = 0, from_middle = 0;
};

Standing standing(const FrameStatistics& film, int column, int row) {
  std::array<double, 9> value{};  // of the pixel, then of its neighbours
  auto end = value.begin() + 1;
  each_pixel_near({1.0 * column, 1.0 * row}, 1, film.width, film.height, [&](int c, int r, std::size_t at) {
    const auto mean = static_cast<double>(film.mean[at]);
    if (r == row && c == column) value[0] = mean;
    else if (std::isfinite(mean)) *end++ = mean;
  });
  const double x = value[0];
  const auto begin = value.begin() + 1;
  if (end - begin < 3) return {};
  std::sort(begin, end);
  const std::ptrdiff_t alike = end - begin < 5 ? 1 : 2;
  const double beyond = std::max({0.0, x - *(end - 1 - alike), *(begin + alike) - x}),
               middle = *(begin + (end - begin) / 2);
  for (auto v = begin; v != end; ++v) *v = std::abs(*v - middle);
  return {beyond, to_deviation * median_in_place(begin, end), x - middle};
}

/// Whether a pixel is no number in some of the frames.
bool fails(const FrameStatistics& film, std::size_t pixel) { return !film.without.empty() && film.without[pixel] > 0; }

void mark_levels(const FrameStatistics& film, std::vector<std::uint8_t>& bad) {
  std::vector<Standing> all;
  std::vector<double> deviations;
  for (int r = 0; r < film.height; ++r)
    for (int c = 0; c < film.width; ++c) {
      all.push_back(standing(film, c, r));
      if (std::isfinite(all.back().from_middle)) deviations.push_back(all.back().from_middle);
    }
  const double usual = robust(std::move(deviations)).deviation;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!std::isfinite(film.mean[i]) || fails(film, i) || all[i].beyond > limit * std::max(usual, all[i].scatter))
      bad[i] |= bad_level;
}

/// Marks what lies further than the limit from the middle of all, or is no number.
void mark_outliers(const std::vector<double>& x, BadPixel why, std::vector<std::uint8_t>& bad) {
  std::vector<double> finite = x;
  std::erase_if(finite, [](double v) { return !std::isfinite(v); });
  const Robust r = robust(std::move(finite));
  for (std::size_t i = 0; i < x.size(); ++i)
    if (!std::isfinite(x[i]) || (r.deviation > 0 && std::abs(x[i] - r.middle) > limit * r.deviation)) bad[i] |= why;
}

void mark_noise(const FrameStatistics& film, std::vector<std::uint8_t>& bad) {
  constexpr std::size_t least_frames = 8;
  if (film.frames < least_frames || std::all_of(film.noise.begin(), film.noise.end(), [](float n) { return n == 0; }))
    return;
  mark_outliers(mapped(film.noise, [](double noise) { return std::log(noise); }), bad_noise,
                bad);  // of a frozen pixel: minus infinity
}

}  // namespace

FrameStatistics frame_statistics(FilmSource& film, std::size_t most_frames) {
  const FilmInfo& info = film.info();
  const std::size_t n = info.pixels(), all = static_cast<std::size_t>(info.frames);
  FrameStatistics s{info.width, info.height, most_frames == 0 ? all : std::min(all, most_frames), {}, {}, {}, {}};
  for (auto* array : {&s.mean, &s.noise, &s.least, &s.most}) array->assign(n, std::numeric_limits<float>::quiet_NaN());
  s.without.resize(n);
  std::vector<double> sum(n), differences(n);
  std::vector<float> before(n, std::numeric_limits<float>::quiet_NaN()), earlier = before;
  std::vector<std::uint32_t> count(n), steps(n);
  BlankFrames lost;
  read_frames(film, 0, s.frames, [&](const auto* pixel, std::size_t, std::size_t some) {
    for (std::size_t k = 0; k < some; ++k, pixel += n) {
      lost.see(pixel, n);
      for (std::size_t i = 0; i < n; ++i) {
        const auto x = static_cast<float>(pixel[i]);
        const double step = static_cast<double>(x) - static_cast<double>(before[i]);
        const double bend = step - (static_cast<double>(before[i]) - static_cast<double>(earlier[i]));
        const double square = s.frames > 2 ? bend * bend / 3 : step * step;
        earlier[i] = before[i], before[i] = x;
        if (!std::isfinite(x)) {
          ++s.without[i];
          continue;
        }
        sum[i] += static_cast<double>(x);
        ++count[i];
        if (std::isfinite(square)) differences[i] += square, ++steps[i];
        s.least[i] = std::fmin(s.least[i], x);
        s.most[i] = std::fmax(s.most[i], x);
      }
    }
    return true;
  });
  s.blank = lost.all();
  if (!s.blank.empty()) {
    std::vector<double> any_time(all);
    std::iota(any_time.begin(), any_time.end(), 0.0);
    FilmWithout kept(film, s.blank, any_time);
    FrameStatistics of_pictures = frame_statistics(kept, s.frames - s.blank.size());
    of_pictures.blank = std::move(s.blank);
    return of_pictures;
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (count[i] == 0) continue;
    s.mean[i] = static_cast<float>(sum[i] / count[i]);
    s.noise[i] = steps[i] > 0 ? static_cast<float>(std::sqrt(differences[i] / (2.0 * steps[i]))) : 0;
  }
  return s;
}

Doubtful doubtful(const FrameStatistics& s, int bits) {
  constexpr std::size_t least_frames = 8;  // fewer agree by chance
  Doubtful found;
  const float top = bits > 0 && bits <= 16 ? static_cast<float>((1 << bits) - 1) : INFINITY;
  for (std::size_t i = 0; i < s.mean.size(); ++i) {
    if (s.frames >= least_frames && s.least[i] == s.most[i]) ++found.constant;
    if (s.most[i] >= top) ++found.saturated;
  }
  return found;
}

std::vector<std::uint8_t> find_bad_pixels(const FrameStatistics& film) {
  std::vector<std::uint8_t> bad(film.mean.size(), 0);
  mark_levels(film, bad);
  mark_noise(film, bad);
  return bad;
}

std::vector<std::uint8_t> find_bad_pixels(const FrameStatistics& cold, const FrameStatistics& warm) {
  std::vector<std::uint8_t> bad = find_bad_pixels(cold);
  const std::vector<std::uint8_t> others = find_bad_pixels(warm);
  std::vector<double> answer;
  for (std::size_t i = 0; i < bad.size(); ++i) {
    bad[i] |= others[i];
    answer.push_back(static_cast<double>(warm.mean[i]) - static_cast<double>(cold.mean[i]));
  }
  mark_outliers(answer, bad_gain, bad);
  return bad;
}

}  // namespace arenite::thermography
