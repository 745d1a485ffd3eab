#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/random.hpp"
#include "io/film/film.hpp"
#include "support/films.hpp"
#include "support/virtual_film.hpp"

/// A film held against what is known beside it: each of these mistakes of a laboratory is found and said, or refused.
namespace {
using namespace arenite;
using test::VirtualFilm;
using Json = nlohmann::json;

constexpr const char* factors_times_one_and_a_half =
    "--set materials.POM.thermoelastic_factor='\"0.0225 K/MPa\"' --set materials.HDPE.thermoelastic_factor='\"0.0387 "
    "K/MPa\"'";
constexpr const char* factors_exchanged =
    "--set materials.POM.thermoelastic_factor='\"0.0258 K/MPa\"' --set materials.HDPE.thermoelastic_factor='\"0.015 "
    "K/MPa\"'";

double given_load(const VirtualFilm& of) {
  const std::string text = test::slurp(of.at("film/film.toml"));
  return std::stod(text.substr(text.find("load_peak_to_peak = \"") + 21));
}

TEST(FilmOutside, AFilmThatAgreesIsNotDoubted) {
  const VirtualFilm of;
  const auto done = of.film("--json");
  ASSERT_EQ(done.status, 0) << done.err;
  const Json checks = Json::parse(done.out).at("checks");
  EXPECT_EQ(checks.at("doubts").size(), 0u) << checks.dump(2);
  EXPECT_NEAR(checks.at("load_by_forces_N").get<double>() / (1e3 * given_load(of)), 1, 0.05);
  for (const auto& [name, scale] : checks.at("factor_scale").items())
    EXPECT_NEAR(scale.at("value").get<double>(), 1, 0.08) << name;
}

TEST(FilmOutside, MistakesOfALaboratoryAreFound) {
  const VirtualFilm of;
  ASSERT_EQ(of.filmed.status, 0) << of.filmed.err;
  const auto said = [&](const std::string& changes, const std::string& words) {
    const auto done = of.film("--json " + changes);
    EXPECT_EQ(done.status, 0) << done.err;
    EXPECT_NE(done.err.find(words), std::string::npos) << changes << '\n' << done.err;
    EXPECT_NE(Json::parse(done.out).at("checks").at("doubts").dump().find(words), std::string::npos);
    const auto again = of.film("--json " + changes);  // from the store
    EXPECT_NE(again.err.find(words), std::string::npos) << again.err;
    return done.err.substr(std::min(done.err.size(), done.err.find(words) + words.size()));
  };
  said(factors_times_one_and_a_half, "times the forces that the peak-to-peak load");
  said(factors_exchanged, "the two materials are probably swapped");
  const std::string times =
      said("--set container.load_peak_to_peak='\"" + std::to_string(2 * given_load(of)) + " kN\"'",
           "the likely causes are load_peak_to_peak or all thermoelastic factors (given as ");
  EXPECT_NEAR(std::stod(times), 2, 0.04);  // three errors of a factor that 42 grains and their load give
  const auto quadrature = of.film("--set lockin.phase='\"90 deg\"'");
  EXPECT_EQ(quadrature.status, 2);
  EXPECT_NE(quadrature.err.find("lockin.phase = \"90 deg\""), std::string::npos) << quadrature.err;
}

TEST(FilmOutside, CountsTakenForKelvinAreRefused) {
  const VirtualFilm of;
  ASSERT_EQ(of.filmed.status, 0) << of.filmed.err;
  const auto source = io::open_film(of.at("film/film.ptw"));
  Film film;
  film.about = source->info();
  film.about.quantity = {};
  film.level = test::all_of(*source).level;
  io::write_film(of.at("film/counts.tif"), film);
  of.edit("kelvin.toml", "from = \"references\"", "from = \"film\"\nassumed_emissivity = 1");
  const auto done = test::arenite("film " + of.at("film/counts.tif").string() + " --recipe " +
                                  of.at("film/kelvin.toml").string() + " --quiet --out " + of.at("result").string());
  EXPECT_EQ(done.status, 2) << done.err;
  EXPECT_NE(done.err.find("kelvin"), std::string::npos) << done.err;
}

/// Share of the grains whose stress lies within two of its errors, and contacts that are there.
struct Judged {
  double covered = 0, contacts = 0, contacts_error = 0, mean_force = 0, mean_force_error = 0;
};

Judged judged(const VirtualFilm& of, const Json& j) {
  const FilmResult film = of.result();
  const Packing low = of.state("low"), high = of.state("high");
  const auto match = test::nearest_of(film.packing.grains, high.grains, low.domain.corner());
  const auto released = test::stress_by_forces(low), loaded = test::stress_by_forces(high);
  Judged out;
  double within = 0, known = 0;
  for (std::size_t i = 0; i < match.size(); ++i) {
    if (!std::isfinite(film.peak_to_peak.error[i])) continue;
    within += std::abs(film.peak_to_peak.sigma_hyd[i] - (loaded[match[i]] - released[match[i]])) <
              2 * film.peak_to_peak.error[i],
        ++known;
  }
  out.covered = within / known;
  out.contacts = static_cast<double>(film.packing.contacts.size());
  out.contacts_error = film.fit.present_error;
  out.mean_force = j.at("forces").at("mean_N").at("value");
  out.mean_force_error = j.at("forces").at("mean_N").at("error");
  return out;
}

TEST(FilmOutside, ContactsAndTheirMeanForceDoNotFollowTheNoise) {
  std::vector<Judged> all;
  double truth = 0;
  for (const char* camera : {"--set camera.netd='\"10 mK\"' --set camera.electrons=2.4e7 --set camera.full_well=4.8e7",
                             "", "--set camera.netd='\"40 mK\"'"}) {
    const VirtualFilm of(camera);
    const auto done = of.film("--json");
    ASSERT_EQ(done.status, 0) << done.err;
    all.push_back(judged(of, Json::parse(done.out)));
    truth = static_cast<double>(of.state("high").contacts.size());
    EXPECT_NEAR(all.back().contacts, truth, 3 + 2 * all.back().contacts_error) << camera;
    EXPECT_GE(all.back().covered, 0.88) << camera;  // 37 of 42
  }
  for (const Judged& one : all) EXPECT_NEAR(one.mean_force, all.front().mean_force, 0.5 * one.mean_force_error);
}

TEST(FilmOutside, ErrorsCoverABlurThatIsWrong) {
  const VirtualFilm of("--set camera.blur=0.7");
  ASSERT_EQ(of.filmed.status, 0) << of.filmed.err;
  const auto done = of.film("--json --set forces.blur=0.5");
  ASSERT_EQ(done.status, 0) << done.err;
  EXPECT_GE(judged(of, Json::parse(done.out)).covered, 0.88);
  EXPECT_NE(done.err.find("the rims of grains show a blur of"), std::string::npos) << done.err;
}

TEST(FilmOutside, ErrorsCoverNoiseThatIsCorrelatedInTime) {
  const VirtualFilm of;
  ASSERT_EQ(of.filmed.status, 0) << of.filmed.err;
  const auto source = io::open_film(of.at("film/film.ptw"));
  Film film;
  film.about = source->info();
  film.level = test::all_of(*source).level;
  RandomStream random(3, Purpose::test);
  std::vector<double> before(film.about.pixels(), 0.0);
  constexpr double memory = 0.5, spread = 6;  // levels; about as much as the camera's own
  for (std::size_t k = 0; k < film.level.size(); ++k) {
    double& noise = before[k % before.size()];
    noise = memory * noise + std::sqrt(1 - memory * memory) * spread * random.normal();
    film.level[k] = static_cast<std::uint16_t>(std::clamp(std::lround(film.level[k] + noise), 0l, 16383l));
  }
  io::write_film(of.at("film/film.ptw"), film);
  const auto done = of.film("--json");
  ASSERT_EQ(done.status, 0) << done.err;
  EXPECT_GE(judged(of, Json::parse(done.out)).covered, 0.88);
}

TEST(CameraCommand, ABlindRecipeHoldsWhatALaboratoryKnows) {
  const VirtualFilm of;
  ASSERT_EQ(of.camera("blind", "--blind").status, 0);
  const std::string informed = test::slurp(of.at("film/film.toml")), blind = test::slurp(of.at("blind/film.toml"));
  const auto line = [](const std::string& text, const std::string& key) {
    const auto at = text.find("\n" + key + " = ");
    return at == std::string::npos ? std::string() : text.substr(at + 1, text.find('\n', at + 1) - at - 1);
  };
  EXPECT_EQ(line(informed, "phase"), "phase = \"180 deg\"");
  EXPECT_EQ(line(blind, "phase"), "");
  for (const char* key : {"travel", "ambient"}) EXPECT_NE(line(informed, key), line(blind, key)) << key;
  EXPECT_NE(blind.find("load_peak_to_peak = "), std::string::npos);
  EXPECT_TRUE(test::slurp(of.at("film/film.ptw")) == test::slurp(of.at("blind/film.ptw")));
}

}  // namespace
