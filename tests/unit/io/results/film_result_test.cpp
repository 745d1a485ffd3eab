#include "io/results/results.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "core/error.hpp"
#include "io/disk/file.hpp"
#include "io/disk/store_file.hpp"
#include "support/film_page_sample.hpp"
#include "support/pictures.hpp"
#include "support/program.hpp"

namespace {
using namespace arenite;
using test::TemporaryFolder;

const FilmResult& sample() {
  static const test::FilmPageSample made(60, 4e-3);
  return made.film;
}

TEST(FilmResultFile, ReadsBackWhatWasWritten) {
  const TemporaryFolder folder;
  const FilmResult& r = sample();
  io::write_film_result(folder / "f.h5", r);
  EXPECT_EQ(io::stored_kind(folder / "f.h5"), "film");
  const FilmResult back = io::read_film_result(folder / "f.h5");
  EXPECT_EQ(back.name, r.name);
  EXPECT_EQ(back.outcome, r.outcome);
  EXPECT_TRUE(back.converged);
  EXPECT_EQ(back.provenance.recipe, r.provenance.recipe);
  EXPECT_EQ(back.numbers, r.numbers);
  EXPECT_EQ(back.film.width, r.film.width);
  EXPECT_EQ(back.film.height, r.film.height);
  EXPECT_EQ(back.film.frames, r.film.frames);
  EXPECT_EQ(back.film.integration, r.film.integration);
  EXPECT_EQ(back.film.camera, "JADE III");
  EXPECT_EQ(back.pixel, r.pixel);
  EXPECT_EQ(back.origin.x, r.origin.x);
  EXPECT_EQ(back.origin.y, r.origin.y);
  EXPECT_EQ(back.picture, r.picture);
  EXPECT_EQ(back.bad, r.bad);
  EXPECT_EQ(back.maps.frequency_error, r.maps.frequency_error);
  EXPECT_EQ(back.maps.reference_phase, r.maps.reference_phase);
  EXPECT_EQ(back.maps.frames, r.maps.frames);
  EXPECT_EQ(back.maps.convention, r.maps.convention);
  for (auto map :
       {&LockinMaps::mean, &LockinMaps::amplitude, &LockinMaps::phase, &LockinMaps::in_phase, &LockinMaps::quadrature,
        &LockinMaps::standard_error, &LockinMaps::second_harmonic, &LockinMaps::residual})
    EXPECT_EQ(back.maps.*map, r.maps.*map);
  EXPECT_EQ(back.grains.centre, r.grains.centre);
  for (auto column : {&PictureGrains::radius, &PictureGrains::position_error})
    EXPECT_EQ(back.grains.*column, r.grains.*column);
  for (auto column : {&GrainMotion::cosine, &GrainMotion::sine}) EXPECT_EQ(back.motion.*column, r.motion.*column);
  EXPECT_EQ(back.motion.error, r.motion.error);
  for (auto column : {&PeakToPeak::temperature, &PeakToPeak::sigma_hyd, &PeakToPeak::error, &PeakToPeak::pixels})
    EXPECT_EQ(back.peak_to_peak.*column, r.peak_to_peak.*column);
  EXPECT_EQ(back.simulation.peak_to_peak, r.simulation.peak_to_peak);
  EXPECT_EQ(back.simulation.state, r.simulation.state);
  EXPECT_EQ(back.packing.grains.material, r.packing.grains.material);
  EXPECT_EQ(back.packing.contacts.ft, r.packing.contacts.ft);
  EXPECT_EQ(back.fn_error, r.fn_error);
  EXPECT_EQ(back.ft_error, r.ft_error);
  EXPECT_EQ(back.presence, r.presence);
  EXPECT_EQ(back.fit.proposed, r.fit.proposed);
  EXPECT_EQ(back.fit.over_noise, r.fit.over_noise);
  EXPECT_EQ(back.fit.load, r.fit.load);
  EXPECT_EQ(back.fit.factor_scale, r.fit.factor_scale);
  ASSERT_EQ(back.fit.picture.size(), r.fit.picture.size());
  for (std::size_t p = 0; p < r.fit.picture.size(); ++p)
    EXPECT_TRUE(back.fit.picture[p] == r.fit.picture[p] || std::isnan(r.fit.picture[p])) << p;
}

TEST(FilmResultFile, OfVersion01IsRefused) {
  const std::string file = std::string(ARENITE_SOURCE_DIR) + "/tests/data/results/film-0.1.h5";
  EXPECT_EQ(test::complaint([&] { io::read_film_result(file); }),
            file +
                ": was written by Arenite 0.1, whose results are no longer read; run the recipe in it "
                "(/provenance/recipe) again");
}

TEST(FilmResultFile, MapsAloneReadBack) {
  const TemporaryFolder folder;
  FilmResult maps = sample();
  maps.packing = {};
  maps.grains = {};
  maps.motion = {};
  maps.peak_to_peak = {};
  maps.simulation = {};
  maps.fn_error.clear();
  maps.ft_error.clear();
  maps.presence.clear();
  maps.fit = {};
  maps.bad.clear();
  maps.maps.second_harmonic.clear();
  maps.maps.convention = AmplitudeConvention::peak_to_peak;
  maps.converged = false;
  io::write_film_result(folder / "f.h5", maps);
  const FilmResult back = io::read_film_result(folder / "f.h5");
  EXPECT_EQ(back.maps.in_phase, maps.maps.in_phase);
  EXPECT_EQ(back.maps.convention, AmplitudeConvention::peak_to_peak);
  EXPECT_FALSE(back.converged);
  EXPECT_TRUE(back.maps.second_harmonic.empty());
  EXPECT_TRUE(back.bad.empty());
  EXPECT_TRUE(back.simulation.empty());
  EXPECT_EQ(back.peak_to_peak.size(), 0u);
}

TEST(FilmResultFile, ArraysOfDifferentLengthsAreRefused) {
  const TemporaryFolder folder;
  FilmResult of_grains = sample(), of_contacts = sample();
  of_grains.peak_to_peak.error.pop_back();
  of_contacts.presence.push_back(0);
  for (const FilmResult* wrong : {&of_grains, &of_contacts}) {
    io::write_film_result(folder / "f.h5", *wrong);
    EXPECT_THROW(io::read_film_result(folder / "f.h5"), InputError);
  }
}

TEST(FilmResultFile, CutShortOrChangedIsDamaged) {
  const TemporaryFolder folder;
  io::write_film_result(folder / "f.h5", sample());
  const std::string whole = io::read_file(folder / "f.h5");
  for (std::size_t k = 0; k < whole.size(); k += whole.size() / 37) {
    std::ofstream(folder / "cut.h5", std::ios::binary) << whole.substr(0, k);
    EXPECT_THROW(io::read_film_result(folder / "cut.h5"), InputError) << k;
    if (k < io::header_size) continue;
    std::string changed = whole;
    changed[k] = static_cast<char>(changed[k] ^ 1);
    std::ofstream(folder / "changed.h5", std::ios::binary) << changed;
    EXPECT_THROW(io::read_film_result(folder / "changed.h5"), io::DamagedFile) << k;
  }
}

}  // namespace
