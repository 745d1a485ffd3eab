#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <vector>

#include "core/random.hpp"
#include "model/film.hpp"

namespace arenite::test {

/// 1/f noise of standard deviation 1 over so many samples: white noise through the filter (1 - z^-1)^(-1/2) (Kasdin
/// 1995).
inline std::vector<double> flicker(std::size_t samples, RandomStream& random) {
  std::vector<double> tap(samples, 1), white(samples), noise(samples);
  for (std::size_t k = 1; k < samples; ++k)
    tap[k] = tap[k - 1] * (static_cast<double>(k) - 0.5) / static_cast<double>(k);
  for (double& w : white) w = random.normal();
  double mean = 0, square = 0;
  const double *const h = tap.data(), *const w = white.data();  // tests are compiled without optimisation
  for (std::size_t n = 0; n < samples; ++n) {
    for (std::size_t k = 0; k <= n; ++k) noise[n] += h[k] * w[n - k];
    mean += noise[n] / static_cast<double>(samples);
  }
  for (double& v : noise) v -= mean, square += v * v / static_cast<double>(samples);
  for (double& v : noise) v /= std::sqrt(square);
  return noise;
}

/// A film of a laboratory in kelvin: in the middle a sample of 12 squares whose pixels have amplitudes of 10 to 54 mK,
/// all in phase, and a little second harmonic; round it a holder that no load reaches. Each disturbance has a random
/// generator of its own.
struct DisturbedFilm {
  int width = 56, height = 44, border = 8;  ///< pixels
  std::size_t frames = 1480;                ///< that the camera took
  double rate = 148, frequency = 3.004, phase = 2.2, noise = 0.02, slope = 0.01;
  double common = 0, columns = 0;     ///< 1/f noise of all pixels, and of those of a column, K
  double jump = 0, jump_pattern = 0;  ///< K, and of each pixel its own
  std::size_t jump_frame = 800;
  std::vector<std::size_t> lost = {};                                ///< frames that are not in the film
  std::function<double(double)> drift = [](double) { return 0.0; };  ///< K, of the time
  std::function<double(double)> late = [](double) { return 0.0; };   ///< rad, by which the load's phase is late
  std::uint64_t seed = 1;

  bool sample(std::size_t p) const {
    const int x = static_cast<int>(p) % width, y = static_cast<int>(p) / width;
    return x >= border && y >= border && x < width - border && y < height - border;
  }
  double amplitude(std::size_t p) const {
    if (!sample(p)) return 0;
    const int x = static_cast<int>(p) % width, y = static_cast<int>(p) / width;
    return 0.010 + 0.004 * ((x / 10 + 3 * (y / 10)) % 12);
  }

  Film draw() const {
    RandomStream shared(seed, Purpose::test, 1), by_column(seed, Purpose::test, 2), own(seed, Purpose::test, 3),
        pattern(seed, Purpose::test, 4);
    const std::vector<double> all = common > 0 ? flicker(frames, shared) : std::vector<double>(frames);
    std::vector<std::vector<double>> column(static_cast<std::size_t>(width),
                                            std::vector<double>(columns > 0 ? 0 : frames));
    if (columns > 0)
      for (auto& each : column) each = flicker(frames, by_column);
    Film film;
    film.about.width = width, film.about.height = height;
    film.about.frame_rate = rate, film.about.floating = true;
    const std::size_t pixels = film.about.pixels();
    std::vector<double> step(pixels);
    for (double& s : step) s = jump + jump_pattern * pattern.normal();
    for (std::size_t n = 0; n < frames; ++n) {
      const double t = static_cast<double>(n) / rate, angle = 2 * std::numbers::pi * frequency * t - late(t);
      const double first = std::cos(angle - phase), second = std::cos(2 * angle - 1);
      const bool kept = std::find(lost.begin(), lost.end(), n) == lost.end();
      film.about.frames += kept;
      for (std::size_t p = 0; p < pixels; ++p) {
        const double a = amplitude(p), white = own.normal();
        if (!kept) continue;
        const double load = a * first + 0.02 * a * second;
        const double shift = common * all[n] + columns * column[p % static_cast<std::size_t>(width)][n] +
                             (n >= jump_frame ? step[p] : 0);
        film.value.push_back(static_cast<float>(296 + 0.1 * static_cast<double>(p % 7) + slope * t + drift(t) + load +
                                                shift + noise * white));
      }
    }
    return film;
  }

  /// Frames of a share, at random.
  static std::vector<std::size_t> some_of(std::size_t frames, double share, std::uint64_t seed) {
    RandomStream random(seed, Purpose::test, 5);
    std::vector<std::size_t> some;
    for (std::size_t n = 10; n + 10 < frames; ++n)
      if (random.uniform() < share) some.push_back(n);
    return some;
  }
};

}  // namespace arenite::test
