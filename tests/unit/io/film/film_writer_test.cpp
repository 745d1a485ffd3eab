#include "io/film/film.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "core/error.hpp"
#include "support/films.hpp"
#include "support/pictures.hpp"
#include "support/temporary_folder.hpp"

namespace arenite::io {
namespace {

const std::vector<std::string> endings{".tif", ".npy", ".h5", ".sfmov", ".ptw"};

Film film_for(const std::string& ending, bool floating) {
  Film film = test::counted(7, 5, 4, floating);
  if (ending == ".tif" || ending == ".h5" || ending == ".ptw") film.about.time = {0, 0.008, 0.016, 0.032};
  return film;
}

TEST(FilmWriter, EveryFormatReadsBackThePixelsAndWhatItHasAPlaceFor) {
  const test::TemporaryFolder folder;
  for (const std::string& ending : endings)
    for (const bool floating : {false, true}) {
      SCOPED_TRACE(ending + (floating ? " floating" : " levels"));
      if (ending == ".ptw" && floating) continue;
      Film film = film_for(ending, floating);
      write_film(folder / ("film" + ending), film);
      const auto read = open_film(folder / ("film" + ending));
      const FrameBlock all = test::all_of(*read);
      EXPECT_EQ(all.level, film.level);
      EXPECT_EQ(all.value, film.value);
      const FilmInfo& info = read->info();
      EXPECT_EQ(info.width, 7);
      EXPECT_EQ(info.height, 5);
      EXPECT_EQ(info.frames, 4);
      if (ending != ".npy") {
        EXPECT_DOUBLE_EQ(info.frame_rate, 125);
        EXPECT_DOUBLE_EQ(info.integration, 0.0015);
        EXPECT_EQ(info.bits, floating ? 0 : 14);
      }
      if (ending != ".npy" && ending != ".sfmov") {
        EXPECT_EQ(info.camera, "Counter");
        EXPECT_EQ(info.quantity, film.about.quantity);
        ASSERT_EQ(info.time.size(), 4U);
        for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(info.time[i], film.about.time[i], 1e-9);
      }
    }
  EXPECT_EQ(folder.count(), 5);  // nothing is left beside
}

TEST(FilmWriter, SameFilmSameBytes) {
  const test::TemporaryFolder folder;
  for (const std::string& ending : endings) {
    Film film = film_for(ending, false);
    write_film(folder / ("a" + ending), film);
    const auto writer = create_film(folder / ("b" + ending), film.about);
    FrameBlock block;
    for (std::int64_t f = 0; f < 4; ++f) {
      film.read(f, 1, block);
      writer->append(block);
    }
    writer->finish();
    const auto bytes = [&](const char* name) { return open_bytes(folder / (name + ending))->text(0, 1 << 20); };
    EXPECT_TRUE(bytes("a") == bytes("b")) << ending;
  }
}

TEST(FilmWriter, WhatIsNotFinishedLeavesNothing) {
  const test::TemporaryFolder folder;
  for (const std::string& ending : endings) {
    Film film = film_for(ending, false);
    test::spill(folder / ("film" + ending), "as it was");
    {
      const auto writer = create_film(folder / ("film" + ending), film.about);
      writer->append(test::all_of(film));
    }
    EXPECT_EQ(open_bytes(folder / ("film" + ending))->text(0, 100), "as it was");
  }
  EXPECT_EQ(folder.count(), static_cast<std::ptrdiff_t>(endings.size()));
}

TEST(FilmWriter, RefusesWhatAFormatHasNoPlaceFor) {
  const test::TemporaryFolder folder;
  Film film = test::counted(3, 3, 2, true);
  EXPECT_NE(test::complaint([&] { write_film(folder / "a.ptw", film); }).find("levels"), std::string::npos);
  EXPECT_NE(test::complaint([&] { write_film(folder / "a.avi", film); }).find("tiff, npy, hdf5, sfmov, ptw"), std::string::npos);
  EXPECT_THROW(create_film(folder / "a.npy", film.about)->append(FrameBlock{0, 1, std::vector<std::uint16_t>(9), {}}), std::invalid_argument);
  EXPECT_EQ(folder.count(), 0);
}

/// A film that announces more than 4 GiB is a BigTIFF, however many frames come.
TEST(FilmWriter, TiffBecomesBigTiff) {
  const test::TemporaryFolder folder;
  Film film = test::counted(5, 3, 3);
  film.about.time = {0, 0.008, 0.016};
  FilmInfo info = film.about;
  for (const std::int64_t frames : {std::int64_t{3}, std::int64_t{150000000}}) {
    info.frames = frames;
    const auto writer = create_film(folder / "film.tif", info);
    writer->append(test::all_of(film));
    writer->finish();
    EXPECT_EQ(open_bytes(folder / "film.tif")->text(2, 1), std::string(1, static_cast<char>(frames == 3 ? 42 : 43)));
    const auto read = open_film(folder / "film.tif");
    EXPECT_EQ(test::all_of(*read).level, film.level);
    EXPECT_EQ(read->info().camera, "Counter");
    EXPECT_EQ(read->info().time.size(), 3U);
  }
}

}  // namespace
}  // namespace arenite::io
