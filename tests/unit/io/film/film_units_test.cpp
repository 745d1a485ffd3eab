// What a film says that its numbers are, temperatures in kelvin or degrees Celsius, is used.
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "io/film/formats.hpp"
#include "support/films.hpp"
#include "support/pictures.hpp"
#include "support/temporary_folder.hpp"
#include "unit/io/film/stated.hpp"
#include "unit/io/film/tiff_pages.hpp"

namespace arenite::io {
namespace {

using test::counted;

TEST(FilmUnits, ACalibrationOfImagejToTemperaturesIsUsed) {
  const test::TemporaryFolder folder;
  const Film film = counted(5, 4, 6);
  const std::string calibration = "ImageJ=1.5\nimages=6\nframes=6\nfinterval=0.04\ncf=0\nc0=-20\nc1=0.5\n";
  write_pages(folder / "a.tif", film, calibration + "vunit=Celsius\n");
  const auto first = [&](const FilmChoice& choice) {
    const auto opened = open_film(folder / "a.tif", choice);
    FrameBlock block;
    opened->read(2, 1, block);
    EXPECT_EQ(opened->info().quantity, FilmQuantity::kelvin);
    return block.value.at(3);
  };
  const auto level = film.level.at(2 * 20 + 3);
  EXPECT_FLOAT_EQ(first({}), static_cast<float>(253.15 + 0.5 * level));
  EXPECT_FLOAT_EQ(first({.scale = 2}), static_cast<float>(2 * level));
  write_pages(folder / "b.tif", film, calibration + "vunit=lux\n");
  const auto other = open_film(folder / "b.tif");
  EXPECT_TRUE(tells(*other, "\"lux\""));
  EXPECT_EQ(other->info().quantity, FilmQuantity::unknown);
}

TEST(FilmUnits, TextStatesTheUnitOfItsTemperatures) {
  const auto first = [](const std::string& text, const FilmChoice& choice = {}) {
    const auto film = open_film(bytes_in_memory(text, "a.txt"), choice);
    FrameBlock block;
    film->read(0, 1, block);
    return std::pair(film->info().quantity, block.value.front());
  };
  for (const std::string unit : {"[\xc2\xb0\x43]", "[\xb0\x43]", "(degC)"})
    EXPECT_EQ(first("Temperature " + unit + "\n20.5 21\n"), std::pair(FilmQuantity::kelvin, 293.65f)) << unit;
  EXPECT_EQ(first("# unit = K\n293.5 294\n"), std::pair(FilmQuantity::kelvin, 293.5f));
  EXPECT_EQ(first("Ambient [degC]: 20\n8000 8001\n"), std::pair(FilmQuantity::unknown, 8000.0f));
  EXPECT_EQ(first("Frame 1 (of 2)\n293.5 294\n"), std::pair(FilmQuantity::unknown, 293.5f));
  EXPECT_EQ(first("T [\xc2\xb0\x43]\n20 21\n", {.offset = 273.15}), std::pair(FilmQuantity::kelvin, 293.15f));
  EXPECT_THROW(first("T [K]\n20 21\n\nT [degC]\n20 21\n"), InputError);
}

TEST(FilmUnits, FilesOfASeriesAreOfOneUnit) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "f1.txt") << "T [degC]\n20 21\n";
  std::ofstream(folder / "f2.txt") << "T [degC]\n20 22\n";
  std::ofstream(folder / "f3.txt") << "T [K]\n293 294\n";
  std::ofstream(folder / "f4.txt") << "293 294\n";
  FrameBlock block;
  const auto film = open_film(folder.path());
  film->read(0, 2, block);
  EXPECT_EQ(block.value, (std::vector<float>{293.15f, 294.15f, 293.15f, 295.15f}));
  film->read(2, 1, block);
  EXPECT_EQ(block.value, (std::vector<float>{293, 294}));
  EXPECT_THROW(film->read(3, 1, block), InputError);
  const auto shifted = open_film(folder.path(), {.scale = 2, .offset = 1});
  shifted->read(0, 2, block);
  EXPECT_EQ(block.value, (std::vector<float>{41, 43, 41, 45}));
}

}  // namespace
}  // namespace arenite::io
