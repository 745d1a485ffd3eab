#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/random.hpp"
#include "model/film.hpp"
#include "model/image.hpp"

namespace arenite::test {

/// Disks of two emissivities before a background, at rest in one half of their cycle and away in the other: disk i
/// moves by (1 - cos)/2 of a travel that grows down the picture and differs from disk to disk. They warm by thermal (1
/// + tilt x/R), K, with the load. Rims are blurred as by a lens.
struct MovingDisks {
  int width = 90, height = 70;
  std::size_t frames = 400;
  double rate = 148, frequency = 3;
  double noise = 0.020;
  double travel = 3;   ///< pixels, peak to peak, of the lowest disk
  double apart = 0.3;  ///< pixels, by which disks differ
  double thermal = 0.05, tilt = 0.5;
  double contrast = 1.5;  ///< K
  double radius = 4.6;
  double gap = 0.1;               ///< pixels between neighbours
  double edge = 0;                ///< K by which what is behind them is warmer than what is outside of their container
  double curve = 0, warm_up = 0;  ///< K by which the scene warms, as the square of the time, and exponentially within a
                                  ///< fifth of the film
  std::uint64_t seed = 7;

  double drift(double share) const { return curve * share * share - warm_up * std::expm1(-5 * share); }

  PictureGrains grains() const {
    PictureGrains g;
    RandomStream random(seed, Purpose::test, 1);
    const double step = 2 * radius + gap;
    for (int row = 0; row < static_cast<int>((height - 12) / (step * 0.87)); ++row)
      for (int k = 0; k < static_cast<int>((width - 12 - step / 2) / step); ++k) {
        g.centre.push_back({8 + radius + step * (k + 0.5 * (row % 2)) + 0.05 * random.normal(),
                            6 + radius + step * 0.87 * row + 0.05 * random.normal()});
        g.radius.push_back(radius);
        g.material.push_back(static_cast<std::int32_t>(random.below(2)));
        g.position_error.push_back(0.02);
      }
    return g;
  }

  Vec2 amplitude(const PictureGrains& g, std::size_t i) const {
    const auto number = static_cast<double>(i);
    return {-0.5 * apart * std::sin(2.0 * number),
            0.5 * (travel * g.centre[i].y / height + apart * std::sin(1.3 * number))};
  }
  double warming(const PictureGrains& g, std::size_t i, double x) const {
    return thermal * (1 + 0.5 * std::sin(static_cast<double>(i))) * (1 + tilt * (x - g.centre[i].x) / radius);
  }

  /// Share of a pixel in a container that touches the outermost disks; its lower wall moves as disks there would on
  /// average.
  double in_container(const PictureGrains& g, double x, double y, double s) const {
    double left = width, right = 0, top = height, bottom = 0;
    for (const Vec2 c : g.centre) {
      left = std::min(left, c.x - radius), right = std::max(right, c.x + radius);
      top = std::min(top, c.y - radius), bottom = std::max(bottom, c.y + radius);
    }
    bottom += s * 0.5 * travel * bottom / height;
    const auto beyond = [](double distance) { return 0.5 * std::erfc(distance / 0.8); };
    return beyond(left - x) * beyond(x - right) * beyond(top - y) * beyond(y - bottom);
  }

  /// u(t) = amplitude s, warming s/2 with s = -cos(2 pi f t): the load is largest when cos is -1.
  Film draw() const {
    const PictureGrains g = grains();
    Film film;
    film.about.width = width;
    film.about.height = height;
    film.about.frames = static_cast<std::int64_t>(frames);
    film.about.frame_rate = rate;
    film.about.floating = true;
    film.about.quantity = FilmQuantity::kelvin;
    film.value.reserve(film.about.pixels() * frames);
    for (std::size_t n = 0; n < frames; ++n) {
      const double s = -std::cos(2 * std::numbers::pi * frequency * static_cast<double>(n) / rate);
      std::vector<double> frame(film.about.pixels(), 294);
      for (std::size_t p = 0; edge != 0 && p < frame.size(); ++p)
        frame[p] += edge * in_container(g, static_cast<double>(p % static_cast<std::size_t>(width)),
                                        static_cast<double>(p / static_cast<std::size_t>(width)), s);
      for (std::size_t i = 0; i < g.size(); ++i) {
        const Vec2 moved = s * amplitude(g, i), centre = g.centre[i] + moved;
        const double reach = radius + 3;
        for (int row = std::max(0, static_cast<int>(centre.y - reach));
             row < std::min<double>(height, centre.y + reach); ++row)
          for (int column = std::max(0, static_cast<int>(centre.x - reach));
               column < std::min<double>(width, centre.x + reach); ++column) {
            const double x = column - moved.x, y = row - moved.y,
                         out = std::hypot(x - g.centre[i].x, y - g.centre[i].y) - radius;
            const double inside = 0.5 * std::erfc(out / 0.8);
            frame[static_cast<std::size_t>(row * width + column)] +=
                inside * (contrast * (g.material[i] ? 1 : 0.6) + 0.5 * s * warming(g, i, x));
          }
      }
      RandomStream random(seed, Purpose::test, 100 + n);
      const double warmer = drift(static_cast<double>(n) / static_cast<double>(frames));
      for (const double v : frame) film.value.push_back(static_cast<float>(v + warmer + noise * random.normal()));
    }
    return film;
  }
};

}  // namespace arenite::test
