#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <vector>

#include "core/random.hpp"
#include "model/elasticity/disk_field.hpp"
#include "model/film.hpp"
#include "support/disturbed_film.hpp"
#include "support/laboratory_sample.hpp"
#include "thermal/radiometry/band.hpp"

namespace arenite::test {

/// How a film of a sample under a cyclic load is drawn, by another way than the program's virtual camera: every frame
/// of the cycle is the exact field of the disks at the share of the load, drawn on a fine grid where the grains are
/// then, blurred and summed into pixels.
struct LaboratoryFilm {
  double pixel = 1.2e-3;            ///< m
  int fine = 4;                     ///< points along a pixel
  double blur = 0.5;                ///< of the lens, pixels
  double halo = 0, halo_width = 4;  ///< share of the light that goes astray, and how far, pixels
  double noise = 0.020;             ///< K
  double temperature = 296, ambient = 291;
  std::array<double, 2> emissivity{0.95, 0.75};  ///< of the materials
  double emissivity_scatter = 0;                 ///< by grain, relative
  double background = 0.45, frame = 0.45;        ///< emissivities
  std::vector<double> bare = {};                 ///< shares of the list: grains as bright as what is behind them
  double travel = 1.0;                           ///< of the lower wall, pixels, upwards
  double wander = 0.1;                           ///< of every grain beside the affine motion, pixels
  double common = 0, columns = 0;                ///< 1/f noise of all pixels, and of those of a column, K
  double jump = 0, jump_pattern = 0;             ///< of the level at shares of the film, K, and of each pixel its own
  std::vector<double> jump_at{0.54};             ///< shares of the film's time
  double lost = 0;                               ///< share of the frames that are not in the film
  std::function<double(double)> drift = {};      ///< K, of the share of the film's time
  std::size_t cycles = 30;
  std::uint64_t seed = 1;
  static constexpr double rate = 148, frequency = 3, margin = 9;  ///< Hz, Hz, pixels round the container

  /// Column and row of the container's inner corner in the film.
  static double left() { return margin + 0.2; }
  static double top_row() { return margin - 0.3; }

  /// The grains at the smallest load, m.
  std::vector<Vec2> start(const Packing& p) const {
    RandomStream random(seed, Purpose::test, 71);
    std::vector<Vec2> low;
    for (const Vec2 x : p.grains.position) {
      const Vec2 stray{random.normal(), random.normal()};
      low.push_back(x - pixel * (Vec2{0, travel * (1 - x.y / p.domain.wall[top].position)} + wander * stray));
    }
    return low;
  }
};

/// A film in kelvin as of a black body, with the sample's upper left inner corner (at rest) at `left`, `top`.
class DrawnFilm {
 public:
  DrawnFilm(const Packing& sample, const LaboratoryFilm& how) : p_(sample), how_(how), low_(how.start(sample)) {
    const double px = how.pixel;
    film.about.width = static_cast<int>(p_.domain.wall[right].position / px + 2 * how.margin);
    film.about.height = static_cast<int>((p_.domain.wall[top].position) / px + 2 * how.margin + how.travel);
    left = how.left(), top_row = how.top_row();
    film.about.frame_rate = how.rate, film.about.floating = true, film.about.quantity = FilmQuantity::kelvin;
    film.about.frames =
        static_cast<std::int64_t>(std::lround(static_cast<double>(how.cycles) * how.rate / how.frequency));
    surfaces();
    disks();
    draw();
  }

  Film film;
  double left = 0,
         top_row = 0;  ///< column and row of the container's inner corner; centres of pixels count whole numbers

 private:
  struct Level {
    double at, slope;  ///< K, and per kelvin of warming
  };
  Level level(double emissivity) const {
    const radiometry::Band band;
    const radiometry::Surface s{emissivity, how_.ambient};
    const double t = radiometry::temperature_of_exitance(band, radiometry::seen_exitance(band, s, how_.temperature));
    return {t, emissivity * radiometry::photon_exitance_slope(band, how_.temperature) /
                   radiometry::photon_exitance_slope(band, t)};
  }

  void surfaces() {
    RandomStream random(how_.seed, Purpose::test, 72);
    for (const auto m : p_.grains.material)
      grain_.push_back(
          level(how_.emissivity[static_cast<std::size_t>(m)] * (1 + how_.emissivity_scatter * random.normal())));
    for (const double share : how_.bare)
      grain_.at(static_cast<std::size_t>(share * static_cast<double>(grain_.size()))) = level(how_.background);
  }

  void disks() {
    pulls_.resize(p_.grains.size());
    pressure_.assign(p_.grains.size(), 0);
    const auto add = [&](std::int32_t grain, Vec2 n, double fn, double ft) {
      const auto i = static_cast<std::size_t>(grain);
      const double r = p_.grains.radius[i];
      pulls_[i].push_back({r * n, fn * n + ft * perpendicular(n)});
      pressure_[i] += fn / (std::numbers::pi * p_.domain.thickness * r);
    };
    for (std::size_t c = 0; c < p_.contacts.size(); ++c) {
      add(p_.contacts.i[c], p_.contacts.normal[c], p_.contacts.fn[c], p_.contacts.ft[c]);
      if (!p_.contacts.is_wall(c)) add(p_.contacts.j[c], -p_.contacts.normal[c], p_.contacts.fn[c], p_.contacts.ft[c]);
    }
  }

  /// sigma_kk of the full load at x from the centre of grain i; a force is spread over a tenth of a pixel.
  double stress(std::size_t i, Vec2 x) const {
    const double spread = 0.1 * how_.pixel, soft = spread * spread;
    double sum = 0;
    for (const auto& [back, force] : pulls_[i]) {
      const Vec2 rho = x + back;
      sum += dot(force, rho) / (dot(rho, rho) + soft);
    }
    return pressure_[i] - 2 / (std::numbers::pi * p_.domain.thickness) * sum;
  }

  /// The picture at a share of the load, K above the sample's temperature.
  std::vector<double> picture(double share) const {
    const int f = how_.fine, w = film.about.width * f, h = film.about.height * f;
    const double cell = how_.pixel / f, x0 = -(left + 0.5) * how_.pixel + 0.5 * cell,
                 y0 = height() + (top_row + 0.5) * how_.pixel - 0.5 * cell;
    const double floor = lower_wall(share);
    const Level behind = level(how_.background), frame = level(how_.frame);
    std::vector<double> scene(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)), covered(scene.size(), 0.0),
        light(scene.size(), 0.0);
    for (int r = 0; r < h; ++r)
      for (int c = 0; c < w; ++c) {
        const double x = x0 + c * cell, y = y0 - r * cell;
        const bool inside = x > 0 && x < p_.domain.wall[right].position && y < height() && y > floor;
        scene[index(c, r, w)] = (inside ? behind : frame).at - how_.temperature;
      }
    for (std::size_t i = 0; i < p_.grains.size(); ++i) {
      const Vec2 at = low_[i] + share * (p_.grains.position[i] - low_[i]);
      const double radius = p_.grains.radius[i];
      const int c0 = static_cast<int>((at.x - radius - x0) / cell) - 1,
                c1 = static_cast<int>((at.x + radius - x0) / cell) + 2;
      const int r0 = static_cast<int>((y0 - at.y - radius) / cell) - 1,
                r1 = static_cast<int>((y0 - at.y + radius) / cell) + 2;
      const double factor = p_.materials[static_cast<std::size_t>(p_.grains.material[i])].thermoelastic_factor;
      for (int r = r0; r <= r1; ++r)
        for (int c = c0; c <= c1; ++c) {
          const Vec2 x = Vec2{x0 + c * cell, y0 - r * cell} - at;
          const double part =
              std::clamp(0.5 + (radius - norm(x)) / cell, 0.0, 1.0);  // a point at a rim shows both sides
          if (part <= 0) continue;
          const std::size_t k = index(c, r, w);
          covered[k] += part;
          light[k] += part * (grain_[i].at - how_.temperature - grain_[i].slope * factor * share * stress(i, x));
        }
    }
    for (std::size_t k = 0; k < scene.size(); ++k)
      if (covered[k] > 0) scene[k] = covered[k] >= 1 ? light[k] / covered[k] : light[k] + (1 - covered[k]) * scene[k];
    return astray(seen(scene, w, h));
  }

  std::vector<double> seen(const std::vector<double>& scene, int w, int h) const {
    const int f = how_.fine, reach = static_cast<int>(std::ceil(4 * how_.blur * f));
    std::vector<double> tap(static_cast<std::size_t>(2 * reach + f), 0.0);
    for (std::size_t k = 0; k < tap.size(); ++k)
      for (int q = 0; q < f; ++q) {
        const double u = (static_cast<double>(k) - reach - q) / f;
        tap[k] += std::exp(-0.5 * u * u / (how_.blur * how_.blur));
      }
    double all = 0;
    for (const double t : tap) all += t;
    for (double& t : tap) t /= all;
    const int across = film.about.width, down = film.about.height;
    std::vector<double> rows(static_cast<std::size_t>(across) * static_cast<std::size_t>(h)), out(film.about.pixels());
    for (int r = 0; r < h; ++r)
      for (int c = 0; c < across; ++c) {
        double sum = 0;
        for (int k = 0; k < static_cast<int>(tap.size()); ++k)
          sum += tap[static_cast<std::size_t>(k)] * scene[index(std::clamp(c * f - reach + k, 0, w - 1), r, w)];
        rows[index(c, r, across)] = sum;
      }
    for (int r = 0; r < down; ++r)
      for (int k = 0; k < static_cast<int>(tap.size()); ++k) {
        const int from = std::clamp(r * f - reach + k, 0, h - 1);
        for (int c = 0; c < across; ++c)
          out[index(c, r, across)] += tap[static_cast<std::size_t>(k)] * rows[index(c, from, across)];
      }
    return out;
  }

  /// A share of the light goes astray.
  std::vector<double> astray(const std::vector<double>& picture) const {
    if (how_.halo <= 0) return picture;
    const int w = film.about.width, h = film.about.height, reach = static_cast<int>(std::ceil(4 * how_.halo_width));
    std::vector<double> tap, rows(picture.size(), 0.0), wide(picture.size(), 0.0), out(picture.size());
    double all = 0;
    for (int k = -reach; k <= reach; ++k)
      tap.push_back(std::exp(-0.5 * k * k / (how_.halo_width * how_.halo_width))), all += tap.back();
    for (int r = 0; r < h; ++r)
      for (int c = 0; c < w; ++c)
        for (int k = -reach; k <= reach; ++k)
          rows[index(c, r, w)] +=
              tap[static_cast<std::size_t>(k + reach)] / all * picture[index(std::clamp(c + k, 0, w - 1), r, w)];
    for (int r = 0; r < h; ++r)
      for (int k = -reach; k <= reach; ++k)
        for (int c = 0; c < w; ++c)
          wide[index(c, r, w)] +=
              tap[static_cast<std::size_t>(k + reach)] / all * rows[index(c, std::clamp(r + k, 0, h - 1), w)];
    for (std::size_t k = 0; k < out.size(); ++k) out[k] = (1 - how_.halo) * picture[k] + how_.halo * wide[k];
    return out;
  }

  void draw() {
    std::map<long, std::vector<double>> drawn;  // by the share of the load
    RandomStream random(how_.seed, Purpose::test, 73);
    const auto frames = static_cast<std::size_t>(film.about.frames);
    const std::vector<std::size_t> lost = DisturbedFilm::some_of(frames, how_.lost, how_.seed);
    const Levels levels(how_, film.about.width, film.about.height, frames);
    film.value.reserve(film.about.pixels() * frames);
    film.about.frames = 0;
    for (std::size_t n = 0; n < frames; ++n) {
      if (std::ranges::binary_search(lost, n)) continue;
      ++film.about.frames;
      const double share =
          0.5 - 0.5 * std::cos(2 * std::numbers::pi * how_.frequency * static_cast<double>(n) / how_.rate);
      const long key = std::lround(1e9 * share);
      if (!drawn.contains(key)) drawn[key] = picture(share);
      for (std::size_t p = 0; p < drawn[key].size(); ++p)
        film.value.push_back(
            static_cast<float>(how_.temperature + drawn[key][p] + levels.at(n, p) + how_.noise * random.normal()));
    }
  }

  /// What camera and room add to the pixels' levels.
  class Levels {
   public:
    Levels(const LaboratoryFilm& how, int width, int height, std::size_t frames)
        : width_(static_cast<std::size_t>(width)),
          all_(frames) {
      RandomStream shared(how.seed, Purpose::test, 75), own(how.seed, Purpose::test, 76);
      const auto noise = [&](double size) {
        std::vector<double> of = flicker(frames, shared);
        for (double& v : of) v *= size;
        return of;
      };
      if (how.common > 0) all_ = noise(how.common);
      if (how.columns > 0)
        for (std::size_t c = 0; c < width_; ++c) column_.push_back(noise(how.columns));
      for (const double at : how.jump_at) {
        if (how.jump == 0 && how.jump_pattern == 0) continue;
        jump_.push_back({static_cast<std::size_t>(at * static_cast<double>(frames)), {}});
        for (std::size_t p = 0; p < width_ * static_cast<std::size_t>(height); ++p)
          jump_.back().second.push_back(how.jump + how.jump_pattern * own.normal());
      }
      for (std::size_t n = 0; how.drift && n < frames; ++n)
        all_[n] += how.drift(static_cast<double>(n) / static_cast<double>(frames));
    }
    double at(std::size_t frame, std::size_t pixel) const {
      double sum = all_[frame] + (column_.empty() ? 0 : column_[pixel % width_][frame]);
      for (const auto& [from, step] : jump_)
        if (frame >= from) sum += step[pixel];
      return sum;
    }

   private:
    std::size_t width_;
    std::vector<double> all_;
    std::vector<std::vector<double>> column_;
    std::vector<std::pair<std::size_t, std::vector<double>>> jump_;
  };

  double height() const { return p_.domain.wall[top].position; }
  double lower_wall(double share) const { return -(1 - share) * how_.travel * how_.pixel; }
  static std::size_t index(int c, int r, int w) {
    return static_cast<std::size_t>(r) * static_cast<std::size_t>(w) + static_cast<std::size_t>(c);
  }

  struct Pull {
    Vec2 back, force;
  };
  Packing p_;
  LaboratoryFilm how_;
  std::vector<Vec2> low_;
  std::vector<Level> grain_;
  std::vector<std::vector<Pull>> pulls_;
  std::vector<double> pressure_;
};

}  // namespace arenite::test
