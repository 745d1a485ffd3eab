#include "workflow/film/film_numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "grains/texture/texture.hpp"
#include "model/elasticity/disk_stress.hpp"
#include "support/film_page_sample.hpp"

namespace arenite::workflow {
namespace {

TEST(FilmNumbers, TellWhatTheResultHolds) {
  const test::FilmPageSample sample(60, 4e-3);
  const FilmResult& film = sample.film;
  const auto j = nlohmann::json::parse(to_json(film_numbers(film, texture_of(film))));
  EXPECT_EQ(j["film"]["bad_pixels"], 2);
  EXPECT_EQ(j["lockin"]["convention"], "amplitude");
  EXPECT_EQ(j["grains"]["all"], 60);
  EXPECT_NEAR(j["grains"]["position_error_pixels"].get<double>(), 0.06, 1e-12);
  double largest = 0;
  for (std::size_t i = 0; i < film.motion.size(); ++i) largest = std::max(largest, 2 * norm(film.motion.cosine[i]));
  EXPECT_NEAR(j["motion"]["largest_travel_pixels"].get<double>(), largest, 1e-9);
  EXPECT_EQ(j["forces"]["proposed"], film.fit.proposed);
  EXPECT_EQ(j["forces"]["present"], film.packing.contacts.size());
  const Contacts& contacts = film.packing.contacts;
  double sum = 0, between = 0;
  for (std::size_t c = 0; c < contacts.size(); ++c)
    if (!contacts.is_wall(c)) sum += contacts.fn[c], ++between;
  EXPECT_NEAR(j["forces"]["mean_N"]["value"].get<double>(), sum / between, 1e-9 * sum);
  EXPECT_EQ(j["texture"]["contacts"].get<std::size_t>() + j["texture"]["wall_contacts"].get<std::size_t>(),
            contacts.size());
  FilmResult maps = film;
  maps.peak_to_peak = {};
  EXPECT_FALSE(nlohmann::json::parse(to_json(film_numbers(maps, texture_of(maps)))).contains("texture"));
}

/// Contacts along x between grains of a row, and one along y.
FilmResult row_of_grains() {
  FilmResult film;
  film.packing.materials = {{"POM", 1400, 27e6, 0}};
  film.packing.domain.thickness = 0.06;
  film.packing.grains.resize(5);
  for (std::size_t g = 0; g < 5; ++g)
    film.packing.grains.position[g].x = 0.0095 * static_cast<double>(g), film.packing.grains.radius[g] = 0.005;
  film.packing.grains.position[4].x = 0, film.packing.grains.position[4].y = 0.0105;
  for (std::int32_t g = 0; g < 3; ++g) film.packing.contacts.add(g, g + 1, {-1, 0}, 100, 0, 0.00475, 0.00475);
  film.packing.contacts.add(0, 4, {0, -1}, 1, 0, 0.00525, 0.00525);
  return film;
}

TEST(FilmOrientations, AreOfTheFilmsContactsAndTheSimulations) {
  FilmResult film = row_of_grains();
  const Packing simulation = film.packing;
  film.packing.contacts = {};
  for (std::size_t c = 0; c < 3; ++c)
    film.packing.contacts.add(simulation.contacts.i[c], simulation.contacts.j[c], simulation.contacts.normal[c], 100, 0,
                              0.00475, 0.00475);
  const texture::Texture own = texture_of(film), simulated = texture::measure(simulation);
  const Numbers orientations = film_numbers(film, own, &simulated)["contact_orientations"];
  EXPECT_EQ(orientations["film"]["contacts"].get<int>(), 3);
  EXPECT_NEAR(orientations["film"]["a_c"]["value"].get<double>(), 2, 1e-12);
  EXPECT_NEAR(std::fmod(orientations["film"]["theta_c_deg"]["value"].get<double>(), 180), 0, 1e-9);
  EXPECT_EQ(orientations["film"]["sectors"].size(), 18u);
  EXPECT_EQ(orientations["simulation"]["contacts"].get<int>(), 4);
  EXPECT_NEAR(orientations["simulation"]["a_c"]["value"].get<double>(), 1, 1e-12);
  EXPECT_FALSE(film_numbers(film, own)["contact_orientations"].contains("simulation"));
  film.packing.contacts = {};
  EXPECT_FALSE(film_numbers(film, texture_of(film)).contains("contact_orientations"));
}

TEST(FilmSimulation, StressOfDisksCountsFullRadii) {
  const FilmResult film = row_of_grains();
  const auto stress = elasticity::stress_of_disks(film.packing);
  const double once = -100 / (2 * std::numbers::pi * 0.005 * 0.06);
  EXPECT_NEAR(stress[3], once, 1e-9);
  EXPECT_NEAR(stress[1], 2 * once, 1e-9);
  // By branch vectors the arms are shorter by half the overlap: 5 %.
  texture::Options options;
  options.rev.sizes = 0;
  EXPECT_NEAR(texture::measure(film.packing, options).per_grain.sigma_hyd[1], 0.95 * 2 * once, 1e-9);
}

}  // namespace
}  // namespace arenite::workflow
