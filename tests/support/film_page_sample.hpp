#pragma once
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "model/elasticity/disk_field.hpp"
#include "report/page.hpp"
#include "support/page_sample.hpp"
#include "workflow/film/film_numbers.hpp"

namespace arenite::test {

/// What a film of a container with disks of two materials might have given: warming as the closed form has it, with
/// noise; forces and grain stresses are the true ones with errors as large as they say. Some contacts are not there;
/// two pixels are bad. Beside it the maps alone, as of a film without grains, and the grains' stresses alone.
struct FilmPageSample {
  std::array<FilmResult, 3> results;
  FilmResult &maps_only = results[0], &stresses_only = results[1], &film = results[2];
  report::PageData data;

  explicit FilmPageSample(std::size_t grains = 260, double pixel = 1.6e-3) {
    const PageSample run(grains);
    truth_ = run.stage.snapshots[3].packing;
    film.name = "film";
    film.outcome = "Every grain of the container was found.";
    film.provenance = {"0.1.0",    "film", "89ab0123456789ab", "title = \"<film> of a frame\"\n", 5,
                       "portable", {},     "<film> of a frame"};
    film.pixel = pixel;
    place_camera();
    draw_maps();
    find_grains();
    infer_forces();
    const texture::Texture truth = texture::measure(truth_);
    film.numbers = workflow::film_numbers(film, workflow::texture_of(film), &truth);
    data.title = "A film of <two> materials in a frame";
    maps_only.name = "maps";
    maps_only.outcome = "Locked in at the load frequency.";
    maps_only.film = film.film;
    maps_only.maps = film.maps;
    maps_only.maps.second_harmonic.clear();
    stresses_only.name = "stresses";
    stresses_only.outcome = "Stresses of grains alone.";
    stresses_only.film = film.film;
    stresses_only.pixel = pixel;
    stresses_only.origin = film.origin;
    stresses_only.packing = film.packing;
    stresses_only.packing.contacts = {};
    stresses_only.peak_to_peak = film.peak_to_peak;
    for (FilmResult* part : {&maps_only, &stresses_only})
      part->numbers = workflow::film_numbers(*part, workflow::texture_of(*part));
    data.films = results;
  }

  FilmPageSample(const FilmPageSample&) = delete;
  FilmPageSample& operator=(const FilmPageSample&) = delete;

 private:
  static constexpr double noise_ = 1.2e-3;                     // K, of an amplitude
  static constexpr double factor_[2] = {0.015e-6, 0.0258e-6};  // K/Pa
  Packing truth_;
  RandomStream random_{11, Purpose::test, 77};

  void place_camera() {
    const Domain& box = truth_.domain;
    constexpr int border = 6;  // pixels around the container
    film.film.width = static_cast<int>(std::ceil(box.width() / film.pixel)) + 2 * border;
    film.film.height = static_cast<int>(std::ceil(box.height() / film.pixel)) + 2 * border;
    film.film.frames = 1480;
    film.film.frame_rate = 148;
    film.film.integration = 1.5e-3;
    film.film.format = "ptw";
    film.film.camera = "JADE III";
    film.film.quantity = FilmQuantity::kelvin;
    film.origin = {box.wall[left].position - (border - 0.5) * film.pixel,
                   box.wall[top].position + (border - 0.5) * film.pixel};
  }

  std::vector<elasticity::Disk> disks() const {
    std::vector<elasticity::Disk> all;
    for (const double r : truth_.grains.radius)
      all.push_back({r, truth_.domain.thickness, {}, elasticity::Traction::point});
    const Contacts& c = truth_.contacts;
    for (std::size_t k = 0; k < c.size(); ++k) {
      all[static_cast<std::size_t>(c.i[k])].forces.push_back({c.normal[k], c.fn[k], c.ft[k], 0});
      if (!c.is_wall(k))
        all[static_cast<std::size_t>(c.j[k])].forces.push_back({-1 * c.normal[k], c.fn[k], c.ft[k], 0});
    }
    return all;
  }

  /// Mean over four points of a pixel: {picture, amplitude}, K.
  std::pair<double, double> seen(const std::vector<elasticity::Disk>& all, Vec2 pixel) const {
    double warmth = 0, amplitude = 0;
    for (const Vec2 part : {Vec2{-0.25, -0.25}, Vec2{0.25, -0.25}, Vec2{-0.25, 0.25}, Vec2{0.25, 0.25}}) {
      const Vec2 at = pixel + film.pixel * part;
      warmth += 294.2 / 4;
      for (std::size_t g = 0; g < all.size(); ++g) {
        const Vec2 x = at - truth_.grains.position[g];
        if (norm(x) >= all[g].radius) continue;
        const int m = truth_.grains.material[g];
        warmth += (m == 0 ? 0.9 : 2.1) / 4;
        amplitude -= factor_[m] * elasticity::sigma_kk(all[g], x) / 8;
      }
    }
    return {warmth, amplitude};
  }

  void draw_maps() {
    const auto all = disks();
    LockinMaps& maps = film.maps;
    maps.width = film.film.width;
    maps.height = film.film.height;
    maps.frequency = 3.0002;
    maps.frequency_error = 1e-4;
    maps.reference_phase = 0.7;
    maps.frames = 1480;
    const auto real = [](double v) { return static_cast<float>(v); };
    for (int row = 0; row < maps.height; ++row)
      for (int column = 0; column < maps.width; ++column) {
        const auto [warmth, amplitude] = seen(all, film.origin + Vec2{column * film.pixel, -row * film.pixel});
        const double cosine = amplitude + noise_ * random_.normal(), sine = noise_ * random_.normal();
        film.picture.push_back(real(warmth + 0.02 * random_.normal()));
        maps.mean.push_back(film.picture.back());
        maps.in_phase.push_back(real(cosine));
        maps.quadrature.push_back(real(sine));
        maps.amplitude.push_back(real(std::hypot(cosine, sine)));
        maps.phase.push_back(
            real(std::remainder(maps.reference_phase + std::atan2(sine, cosine), 2 * std::numbers::pi)));
        maps.residual.push_back(real(0.022 * (1 + 0.03 * random_.normal()) + 0.02 * std::abs(amplitude)));
        maps.standard_error.push_back(real(maps.residual.back() / 18 * (1 + 0.05 * random_.normal())));
        maps.second_harmonic.push_back(real(std::hypot(noise_ * random_.normal(), noise_ * random_.normal())));
      }
    film.bad.assign(film.picture.size(), 0);
    film.bad[pixel_at(20, 9)] = film.bad[pixel_at(21, 9)] = 1;
  }

  std::size_t pixel_at(int column, int row) const { return static_cast<std::size_t>(column + film.film.width * row); }

  void find_grains() {
    const Grains& grains = truth_.grains;
    const auto all = disks();
    for (std::size_t g = 0; g < grains.size(); ++g) {
      film.grains.centre.push_back(
          {(grains.position[g].x - film.origin.x) / film.pixel, (film.origin.y - grains.position[g].y) / film.pixel});
      film.grains.radius.push_back(grains.radius[g] / film.pixel);
      film.grains.position_error.push_back(0.06);
      film.grains.radius_error.push_back(0.05);
      const double low = grains.position[g].y / truth_.domain.wall[top].position - 1;
      film.motion.cosine.push_back({0.02 * random_.normal(), 0.8 * low});
      film.motion.sine.push_back({});
      film.motion.error.push_back(0.02);
      const double sigma = elasticity::sigma_kk(all[g], {}) / 2, error = 0.02e6 + 0.03 * std::abs(sigma);
      film.peak_to_peak.sigma_hyd.push_back(sigma + error * random_.normal());
      film.peak_to_peak.temperature.push_back(-2 * factor_[grains.material[g]] * film.peak_to_peak.sigma_hyd.back());
      film.peak_to_peak.error.push_back(error);
      film.peak_to_peak.pixels.push_back(40);
      film.simulation.peak_to_peak.push_back(sigma * (1 + 0.18 * random_.normal()) -
                                             0.05e6 * std::abs(random_.normal()));
      film.simulation.state.push_back(1.15 * film.simulation.peak_to_peak.back() * (1 + 0.1 * random_.normal()) -
                                      0.04e6);
    }
  }

  /// The true forces with their errors, and one contact in twenty that is not there.
  void infer_forces() {
    film.packing = truth_;
    double mean = 0;
    for (const double fn : truth_.contacts.fn) mean += fn / static_cast<double>(truth_.contacts.size());
    Contacts& c = film.packing.contacts;
    const Grains& grains = film.packing.grains;
    const std::size_t there = c.size();
    for (std::size_t k = 0; k < there / 20; ++k) {
      const auto g = static_cast<std::int32_t>(k), other = nearest(grains, k);
      const Vec2 d = grains.position[k] - grains.position[static_cast<std::size_t>(other)];
      c.add(g, other, (1 / norm(d)) * d, 0, 0, grains.radius[k], grains.radius[static_cast<std::size_t>(other)]);
    }
    for (std::size_t k = 0; k < c.size(); ++k) {
      film.fn_error.push_back(0.05 * mean + 0.02 * c.fn[k]);
      film.ft_error.push_back(0.06 * mean);
      c.fn[k] += film.fn_error[k] * random_.normal();
      c.ft[k] += film.ft_error[k] * random_.normal();
      film.presence.push_back(std::abs(c.fn[k]) < 3 * film.fn_error[k] ? 0.6 : 1.0);
    }
    film.fit.proposed = c.size() + 5, film.fit.present = static_cast<double>(c.size()), film.fit.present_error = 2;
    film.fit.picture = film.maps.in_phase;
    film.fit.over_noise = 1.4, film.fit.over_signal = 0.05, film.fit.model_error = 0.02, film.fit.load = 54e3;
    film.fit.factor_scale.assign(film.packing.materials.size(), 1.01),
        film.fit.factor_scale_error.assign(film.packing.materials.size(), 0.01);
  }

  /// The nearest grain beyond those that touch.
  static std::int32_t nearest(const Grains& grains, std::size_t g) {
    std::size_t best = g;
    double least = INFINITY;
    for (std::size_t other = 0; other < grains.size(); ++other) {
      const double gap = norm(grains.position[g] - grains.position[other]) - grains.radius[g] - grains.radius[other];
      if (other != g && gap > 0 && gap < least) best = other, least = gap;
    }
    return static_cast<std::int32_t>(best);
  }
};

}  // namespace arenite::test
