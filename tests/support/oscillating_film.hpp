#pragma once
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "core/random.hpp"
#include "model/film.hpp"

namespace arenite::test {

/// A film of `of.frames` (or at `of.time`, s) whose pixel p has the level of.at(p, t) and normal noise.
template <class Pixels> Film draw_film(const Pixels& of) {
  Film film;
  film.about.width = of.width;
  film.about.height = of.height;
  film.about.frames = static_cast<std::int64_t>(of.time.empty() ? of.frames : of.time.size());
  film.about.frame_rate = of.rate;
  film.about.floating = true;
  film.about.time = of.time;
  const std::size_t pixels = film.about.pixels();
  for (std::size_t n = 0; n < static_cast<std::size_t>(film.about.frames); ++n) {
    RandomStream random(of.seed, Purpose::test, n);
    const double t = of.time.empty() ? static_cast<double>(n) / of.rate : of.time[n];
    for (std::size_t p = 0; p < pixels; ++p)
      film.value.push_back(static_cast<float>(of.at(p, t) + (of.noise > 0 ? of.noise * random.normal() : 0)));
  }
  return film;
}

/// A film whose pixels oscillate in a known way: pixel p has the mean 20 + p, the slope `drift`, a curve, and the
/// amplitudes and phases below.
struct OscillatingFilm {
  int width = 9, height = 5;
  std::size_t frames = 800;
  double rate = 148, frequency = 3;
  double drift = 0, curve = 0;  ///< unit/s, unit/s^2
  double amplitude = 1;         ///< times 1 + p/100
  double second = 0;            ///< of that
  double noise = 0;
  double phase = 0.4;  ///< rad, times 1 - 2 (p odd)
  double mean = 20;
  std::uint64_t seed = 1;
  std::vector<double> time;  ///< s; even if empty

  double amplitude_of(std::size_t p) const { return amplitude * (1 + static_cast<double>(p % 100) / 100); }
  double phase_of(std::size_t p) const { return p % 2 ? -phase : phase; }
  double at(std::size_t p, double t) const {
    const double a = amplitude_of(p), angle = 2 * std::numbers::pi * frequency * t;
    return mean + static_cast<double>(p % 100) + drift * t + curve * t * t + a * std::cos(angle - phase_of(p)) +
           second * a * std::cos(2 * angle + 1);
  }
  double when(std::size_t n) const { return time.empty() ? static_cast<double>(n) / rate : time[n]; }

  Film draw() const { return draw_film(*this); }

  /// In whole levels, `scale` a unit.
  Film levels(double scale) const {
    Film film = draw();
    film.about.floating = false;
    for (const float v : film.value)
      film.level.push_back(static_cast<std::uint16_t>(std::lround(static_cast<double>(v) * scale)));
    film.value.clear();
    return film;
  }
};

/// The same film, but its frames must be read: they are not shown in memory.
struct ReadFilm : FilmSource {
  explicit ReadFilm(Film& film) : film_(film) {}
  const FilmInfo& info() const override { return film_.info(); }
  void read(std::int64_t first, std::size_t count, FrameBlock& block) override {
    frames_read += count;
    film_.read(first, count, block);
  }
  std::size_t frames_read = 0;

 private:
  Film& film_;
};

}  // namespace arenite::test
