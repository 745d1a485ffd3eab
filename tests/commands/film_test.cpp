#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "io/film/film.hpp"
#include "support/films.hpp"
#include "support/virtual_film.hpp"
#include "thermal/inference/film_stresses.hpp"
#include "thermal/radiometry/band.hpp"
#include "thermal/thermography/correction.hpp"
#include "thermal/thermography/frame_statistics.hpp"

namespace {

using namespace arenite;
using test::VirtualFilm;
using Json = nlohmann::json;

TEST(FilmCommand, GivesBackTheStressesOfTheSimulationThatWasFilmed) {
  const VirtualFilm virtual_film;
  ASSERT_EQ(virtual_film.filmed.status, 0) << virtual_film.simulated.err << virtual_film.filmed.err;
  for (const char* name : {"film.ptw", "cold.ptw", "warm.ptw", "optical.tif", "film.toml"})
    EXPECT_TRUE(std::filesystem::exists(virtual_film.at("film") / name)) << name;
  const auto done = virtual_film.film("--json");
  ASSERT_EQ(done.status, 0) << done.err;
  EXPECT_TRUE(std::filesystem::file_size(virtual_film.at("result/report.html")) > 100'000);
  const Json j = Json::parse(done.out);
  EXPECT_EQ(j["grains"]["POM"], 20);
  EXPECT_EQ(j["grains"]["HDPE"], 22);
  EXPECT_EQ(j["lockin"]["convention"], "peak_to_peak");
  EXPECT_NEAR(j["lockin"]["frequency_Hz"]["value"].get<double>(), 3.003,
              3 * j["lockin"]["frequency_Hz"]["error"].get<double>());
  EXPECT_GT(j["motion"]["largest_travel_pixels"].get<double>(), 1.5);

  const Packing low = virtual_film.state("low"), high = virtual_film.state("high");
  const FilmResult film = virtual_film.result();
  const Vec2 corner = low.domain.corner();
  const auto match = test::nearest_of(film.packing.grains, high.grains, corner);
  EXPECT_EQ(std::set<std::size_t>(match.begin(), match.end()).size(), 42u);
  const auto released = test::stress_by_forces(low), loaded = test::stress_by_forces(high);
  std::vector<double> change;
  double off_at_low = 0, off_at_high = 0;
  int away = 0;
  for (std::size_t i = 0; i < match.size(); ++i) {
    change.push_back(loaded[match[i]] - released[match[i]]);
    EXPECT_EQ(film.packing.materials[static_cast<std::size_t>(film.packing.grains.material[i])].name,
              high.materials[static_cast<std::size_t>(high.grains.material[match[i]])].name);
    const Vec2 found = film.origin + Vec2{film.grains.centre[i].x * film.pixel, -film.grains.centre[i].y * film.pixel},
               moved = film.packing.grains.position[i];
    off_at_low += std::pow(norm(low.grains.position[match[i]] - corner - found) / film.pixel, 2) / 42;
    const double border = 0.010;
    if (moved.x < border || moved.x > 0.095 - border ||
        moved.y < high.domain.wall[bottom].position - corner.y + border || moved.y > low.domain.height() - border)
      continue;
    off_at_high += std::pow(norm(high.grains.position[match[i]] - corner - moved) / film.pixel, 2);
    ++away;
  }
  EXPECT_LT(std::sqrt(off_at_low), 0.1);
  EXPECT_GT(away, 20);
  EXPECT_LT(std::sqrt(off_at_high / away), 0.1);
  const auto agreement = inference::agreement(film.peak_to_peak.sigma_hyd, change, std::vector<std::uint8_t>(42, 1));
  EXPECT_EQ(agreement.relation.count, 42u);
  EXPECT_GT(agreement.relation.pearson.value, 0.98);
  EXPECT_LT(agreement.rms_sigma_norm, 0.05);
  EXPECT_NEAR(agreement.relation.line.slope, 1, 0.03);
}

/// Stress of the grains of one material from the film over that of the simulation, and how far off each is in its
/// errors.
struct OfMaterial {
  double slope = 0, off_in_errors = 0;
};

OfMaterial of_material(const VirtualFilm& of, std::int32_t material) {
  const Packing low = of.state("low"), high = of.state("high");
  const FilmResult film = of.result();
  const auto match = test::nearest_of(film.packing.grains, high.grains, low.domain.corner());
  const auto released = test::stress_by_forces(low), loaded = test::stress_by_forces(high);
  double both = 0, square = 0, off = 0, n = 0;
  for (std::size_t i = 0; i < match.size(); ++i) {
    if (film.packing.grains.material[i] != material) continue;
    const double truth = loaded[match[i]] - released[match[i]], found = film.peak_to_peak.sigma_hyd[i];
    both += found * truth;
    square += truth * truth;
    off += std::pow((found - truth) / film.peak_to_peak.error[i], 2);
    ++n;
  }
  return {both / square, std::sqrt(off / n)};
}

TEST(FilmCommand, UnequalEmissivitiesComeBackWithinTheErrors) {
  const std::string quiet = "--set camera.motion=false ";
  const VirtualFilm alike(quiet),
      unlike(quiet + "--set materials.HDPE.emissivity=0.8 --set materials.POM.emissivity=0.95");
  ASSERT_EQ(alike.film().status, 0);
  ASSERT_EQ(unlike.film().status, 0);
  for (const std::int32_t material : {0, 1}) {
    const OfMaterial same = of_material(alike, material), other = of_material(unlike, material);
    EXPECT_NEAR(other.slope, same.slope, 0.006) << material;
    EXPECT_NEAR(other.slope, 1, 0.02) << material;
    EXPECT_LT(other.off_in_errors, 1.3 * same.off_in_errors + 0.5) << material;
  }
  // The same with a curve of black bodies a kelvin apart instead of Planck's law between two.
  const auto level_of = [&](const char* name) {
    return thermography::reference_level(
        thermography::frame_statistics(*io::open_film(unlike.at(std::string("film/") + name))));
  };
  const double cold = level_of("cold.ptw"), warm = level_of("warm.ptw");
  const auto photons = [](double t) { return radiometry::photon_exitance({}, t); };
  std::ofstream curve(unlike.at("film/curve.csv"));
  curve.precision(12);
  curve << "level,temperature\n";
  for (double t = 285; t <= 305; ++t)
    curve << cold + (photons(t) - photons(291)) * (warm - cold) / (photons(301) - photons(291)) << "," << t << "\n";
  curve.close();
  unlike.edit("curve.toml", "from = \"references\"", "from = \"curve\"\ncurve = \"curve.csv\"");
  const auto by_curve = unlike.film("", "film", "curve.toml");
  ASSERT_EQ(by_curve.status, 0) << by_curve.err;
  EXPECT_TRUE(std::filesystem::exists(unlike.at("result/earlier"))) << "of two films one folder shows the newer";
  for (const std::int32_t material : {0, 1}) EXPECT_NEAR(of_material(unlike, material).slope, 1, 0.025) << material;
}

TEST(FilmCommand, TakesABareArrayThatIsToldWhatItIs) {
  const VirtualFilm of("--set camera.motion=false --format npy");
  ASSERT_EQ(of.filmed.status, 0) << of.filmed.err;
  const std::string film = "film " + of.at("film/film.npy").string() + " --recipe " + of.at("film/film.toml").string() +
                           " --quiet --out " + of.at("result").string();
  const auto bare = arenite::test::arenite(film);
  EXPECT_EQ(bare.status, 2);
  EXPECT_NE(bare.err.find("give it (--frame-rate, frame_rate in [film] of a recipe"), std::string::npos) << bare.err;
  const auto given = arenite::test::arenite(film + " --frame-rate 148Hz");
  EXPECT_EQ(given.status, 0) << given.err;
  const auto slip = arenite::test::arenite(film + " --frame-rate 148");
  EXPECT_EQ(slip.status, 2);
  EXPECT_NE(slip.err.find("--frame-rate"), std::string::npos) << slip.err;
  const auto kelvin = arenite::test::arenite(
      film + " --frame-rate 148Hz --set temperature.from=film --set temperature.assumed_emissivity=1");
  EXPECT_EQ(kelvin.status, 2);
  EXPECT_NE(kelvin.err.find("of unknown quantity"), std::string::npos) << kelvin.err;
}

TEST(FilmCommand, SameSeedSameBytes) {
  const VirtualFilm virtual_film;
  ASSERT_EQ(virtual_film.camera("again").status, 0);
  ASSERT_EQ(virtual_film.camera("other", "--set seed=9").status, 0);
  for (const char* name : {"film.ptw", "cold.ptw", "warm.ptw", "optical.tif", "film.toml"})
    EXPECT_TRUE(test::slurp(virtual_film.at("film") / name) == test::slurp(virtual_film.at("again") / name)) << name;
  EXPECT_FALSE(test::slurp(virtual_film.at("film/film.ptw")) == test::slurp(virtual_film.at("other/film.ptw")));
}

TEST(FilmCommand, PutsASimulationOfTheSameGrainsBesideTheFilm) {
  const VirtualFilm of;
  ASSERT_EQ(of.filmed.status, 0) << of.filmed.err;
  of.edit("companion.toml", "[picture]",
          "[simulation]\nrecipe = \"" + (of.at("states") / "recipe.toml").string() +
              "\"\nlow = \"low\"\nhigh = \"high\"\n\n[picture]");
  const auto done = of.film("--json", "film", "companion.toml");
  ASSERT_EQ(done.status, 0) << done.err;
  const Json j = Json::parse(done.out);
  const FilmResult film = of.result();
  for (const auto& file : io::stage_files(of.at("result/simulation")))
    if (file.filename().string().find("-high-") != std::string::npos) {
      const auto loaded = test::stress_by_forces(io::read_stage(file).snapshots.back().packing);
      ASSERT_EQ(film.simulation.state.size(), loaded.size());
      for (std::size_t i = 0; i < loaded.size(); ++i)
        EXPECT_NEAR(film.simulation.state[i], loaded[i], 1e-9 * std::abs(loaded[i])) << i;
    }
  ASSERT_EQ(film.simulation.state.size(), 42u);
  EXPECT_GT(
      inference::agreement(film.peak_to_peak.sigma_hyd, film.simulation.peak_to_peak, std::vector<std::uint8_t>(42, 1))
          .relation.pearson.value,
      0.2);
  for (const char* what : {"film", "simulation"}) {
    const Json& orientations = j.at("contact_orientations").at(what);  // of the few contacts away from the border
    EXPECT_GT(orientations.at("contacts"), 0) << what;
    EXPECT_EQ(orientations.at("sectors").size(), 18u) << what;
    EXPECT_TRUE(orientations.contains("a_c")) << what;
  }
}

TEST(FilmCommand, ThreadsChangeNoBitOfTheResult) {
  const VirtualFilm virtual_film;
  ASSERT_EQ(virtual_film.film("--threads 1").status, 0);
  const auto file = io::stage_files(virtual_film.at("result")).front();
  const std::string alone = test::slurp(file);
  std::filesystem::remove(file);
  ASSERT_EQ(virtual_film.film("--threads 3").status, 0);
  EXPECT_TRUE(alone == test::slurp(file));
}

}  // namespace
