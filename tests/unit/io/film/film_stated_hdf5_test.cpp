// What a file states of its frames (how many, of which channel, when, which way up, what is missing) is used, refused
// or told.
#include <gtest/gtest.h>
#include <array>
#include <cmath>

#include "core/error.hpp"
#include "io/film/formats.hpp"
#include "support/films.hpp"
#include "support/pictures.hpp"
#include "unit/io/film/hdf5_file.hpp"
#include "unit/io/film/stated.hpp"

namespace arenite::io {
namespace {

using test::counted;
using Numbers64 = std::vector<std::int64_t>;

TEST(StatedFilm, PicturesOfMatlabAreTurned) {
  const auto film = open_film(data("matlab.mat"), {.frame_rate = 30.0});
  EXPECT_EQ(film->info().width, 10);
  EXPECT_EQ(film->info().height, 6);
  EXPECT_EQ(film->info().frames, 120);
  EXPECT_TRUE(tells(*film, "height x width x frames: 6 x 10 x 120"));
  // In its bytes, from HDF5 itself, the first length after the frames is the column.
  const hid_t file = H5Fopen(data("matlab.mat").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT),
              set = H5Dopen2(file, "frames", H5P_DEFAULT);
  std::vector<float> stored(7200);
  H5Dread(set, H5T_NATIVE_FLOAT, H5S_ALL, H5S_ALL, H5P_DEFAULT, stored.data());
  H5Dclose(set);
  H5Fclose(file);
  FrameBlock block;
  for (const std::int64_t f : {0, 7, 119}) {
    film->read(f, 1, block);
    for (std::size_t y = 0; y < 6; ++y)
      for (std::size_t x = 0; x < 10; ++x) {
        const float right = stored[static_cast<std::size_t>(f) * 60 + x * 6 + y];
        EXPECT_EQ(film->info().floating ? block.value[y * 10 + x] : static_cast<float>(block.level[y * 10 + x]), right);
      }
  }
}

TEST(StatedFilm, MatlabKeepsTimesAndRateAsArrays) {
  Hdf5File h;
  H5Dclose(h.write<std::uint16_t>("film", {3, 4, 5}, H5T_STD_U16LE, H5T_NATIVE_UINT16, counted().level));
  H5Dclose(h.write<double>("time", {1, 3}, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, {1, 1.5, 3}));
  H5Dclose(h.write<double>("fps", {1, 1}, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, {2}));
  const auto film = h.open();
  EXPECT_EQ(film->info().time, (std::vector<double>{0, 0.5, 2}));
  EXPECT_EQ(film->info().frame_rate, 2);
}

TEST(StatedFilm, TimesHaveUnits) {
  for (const auto& [unit, seconds] : {std::pair{"ms", 1e-3}, {"seconds since 2024-01-01", 1.0}, {"ns", 1e-9}}) {
    Hdf5File h;
    H5Dclose(h.write<std::uint16_t>("film", {3, 4, 5}, H5T_STD_U16LE, H5T_NATIVE_UINT16, counted().level));
    const hid_t time = h.write<double>("time", {3}, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, {10, 20, 40});
    h.state(time, "units", unit);
    H5Dclose(time);
    EXPECT_NEAR(h.open()->info().time.at(2), 30 * seconds, 1e-12 * seconds) << unit;
  }
  Hdf5File h;
  H5Dclose(h.write<std::uint16_t>("film", {3, 4, 5}, H5T_STD_U16LE, H5T_NATIVE_UINT16, counted().level));
  const hid_t time = h.write<double>("time", {3}, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, {10, 20, 40});
  h.state(time, "units", "fortnights");
  H5Dclose(time);
  const auto film = h.open();
  EXPECT_TRUE(film->info().time.empty());
  EXPECT_TRUE(tells(*film, "\"fortnights\""));
}

TEST(StatedFilm, TimesWithoutAUnitOrForOtherFramesAreTold) {
  Hdf5File other, h;
  for (Hdf5File* file : {&other, &h}) {
    H5Dclose(file->write<std::uint16_t>("film", {3, 4, 5}, H5T_STD_U16LE, H5T_NATIVE_UINT16, counted().level));
    H5Dclose(file->write<double>("time", {2}, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, {10, 20}));
  }
  EXPECT_TRUE(tells(*other.open(), "\"time\" are not a number for each of the 3 frames"));
  H5Dclose(h.write<double>("timestamps", {3}, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, {10, 20, 30}));
  const auto film = h.open();
  EXPECT_TRUE(tells(*film, "\"timestamps\" state no unit; seconds are taken"));
  EXPECT_EQ(film->info().time, (std::vector<double>{0, 10, 20}));
}

TEST(StatedFilm, RatesAndIntervalsAreNumbersOrTexts) {
  for (const auto& [name, text] : {std::pair{"frame_rate", "30 Hz"}, {"dt", "33.333333333333333 ms"}, {"fps", "30"}}) {
    Hdf5File h;
    const hid_t set = h.write<std::uint16_t>("film", {3, 4, 5}, H5T_STD_U16LE, H5T_NATIVE_UINT16, counted().level);
    h.state(set, name, text);
    H5Dclose(set);
    EXPECT_NEAR(h.open()->info().frame_rate, 30, 1e-12) << text;
  }
  Hdf5File said;
  const hid_t film = said.write<std::uint16_t>("film", {3, 4, 5}, H5T_STD_U16LE, H5T_NATIVE_UINT16, counted().level);
  said.state(film, "fps", "fast");
  H5Dclose(film);
  EXPECT_EQ(said.open()->info().frame_rate, 0);
  EXPECT_TRUE(tells(*said.open(), "fps = \"fast\""));
  for (const auto& [name, value] : {std::pair{"frame_interval_ms", 20.0}, {"dt", 0.02}, {"frame_interval_s", 0.02}}) {
    Hdf5File h;
    const hid_t set = h.write<std::uint16_t>("film", {3, 4, 5}, H5T_STD_U16LE, H5T_NATIVE_UINT16, counted().level);
    h.state(set, name, value);
    H5Dclose(set);
    EXPECT_NEAR(h.open()->info().frame_rate, 50, 1e-12) << name;
  }
}

TEST(StatedFilm, ScaleUnitAndMissingValuesOfNetcdf) {
  Hdf5File h;
  std::vector<std::int16_t> stored(60, 100);
  stored[7] = -999;
  const hid_t set = h.write<std::int16_t>("T", {3, 4, 5}, H5T_STD_I16LE, H5T_NATIVE_INT16, stored);
  h.state(set, "scale_factor", 0.01);
  h.state(set, "add_offset", 20);
  h.state(set, "_FillValue", -999);
  h.state(set, "units", "degC");
  H5Dclose(set);
  const auto film = h.open();
  EXPECT_EQ(film->info().quantity, FilmQuantity::kelvin);
  const FrameBlock all = test::all_of(*film);
  for (std::size_t i = 0; i < 60; ++i) {
    if (i == 7) EXPECT_TRUE(std::isnan(all.value[i]));
    else EXPECT_NEAR(all.value[i], 294.15, 1e-4);
  }
}

TEST(StatedFilm, WhatWasNeverWrittenIsNoNumber) {
  Hdf5File h;
  const hsize_t shape[] = {3, 4, 5}, chunk[] = {1, 4, 5}, start[] = {0, 0, 0};
  const hid_t creation = H5Pcreate(H5P_DATASET_CREATE), space = H5Screate_simple(3, shape, nullptr),
              one = H5Screate_simple(3, chunk, nullptr);
  H5Pset_chunk(creation, 3, chunk);
  const hid_t set = H5Dcreate2(h.file, "film", H5T_IEEE_F32BE, space, H5P_DEFAULT, creation, H5P_DEFAULT);
  const std::vector<float> frame(20, 7);
  H5Sselect_hyperslab(space, H5S_SELECT_SET, start, nullptr, chunk, nullptr);
  H5Dwrite(set, H5T_NATIVE_FLOAT, one, space, H5P_DEFAULT, frame.data());
  H5Dclose(set);
  H5Sclose(space);
  H5Sclose(one);
  H5Pclose(creation);
  const FrameBlock all = test::all_of(*h.open());
  for (std::size_t i = 0; i < 60; ++i) EXPECT_EQ(std::isnan(all.value[i]), i >= 20);
  EXPECT_EQ(all.value[3], 7);
}

/// The film of 3 frames of 4 rows and 5 columns whose number is 100 frame + 10 row + column, with its axes in another
/// order: 0 is that of frames, 1 that of rows.
std::vector<std::uint16_t> ordered(const std::array<std::size_t, 3>& roles) {
  constexpr std::size_t length[] = {3, 4, 5};
  constexpr unsigned weight[] = {100, 10, 1};
  std::vector<std::uint16_t> stored;
  for (unsigned i = 0; i < length[roles[0]]; ++i)
    for (unsigned j = 0; j < length[roles[1]]; ++j)
      for (unsigned k = 0; k < length[roles[2]]; ++k)
        stored.push_back(
            static_cast<std::uint16_t>(i * weight[roles[0]] + j * weight[roles[1]] + k * weight[roles[2]]));
  return stored;
}

TEST(StatedFilm, NamesOfAxesSayWhichIsWhich) {
  const std::vector<std::uint16_t> right = ordered({0, 1, 2});
  constexpr hsize_t length[] = {3, 4, 5};
  for (const bool by_scales : {false, true})
    for (const auto& roles : std::vector<std::array<std::size_t, 3>>{{0, 1, 2}, {0, 2, 1}, {1, 2, 0}, {2, 0, 1}}) {
      Hdf5File h;
      const std::vector<const char*> names = by_scales ? std::vector{"Time", "lat", "lon"} : std::vector{"t", "y", "x"};
      const hid_t set = h.write<std::uint16_t>("film", {length[roles[0]], length[roles[1]], length[roles[2]]},
                                               H5T_STD_U16LE, H5T_NATIVE_UINT16, ordered(roles));
      if (by_scales) h.scale(set, {names[roles[0]], names[roles[1]], names[roles[2]]});
      else h.label(set, {names[roles[0]], names[roles[1]], names[roles[2]]});
      H5Dclose(set);
      const auto film = h.open();
      EXPECT_EQ(film->info().frames, 3);
      EXPECT_EQ(film->info().height, 4);
      EXPECT_EQ(film->info().width, 5);
      EXPECT_EQ(test::all_of(*film).level, right) << roles[0] << roles[1] << roles[2];
      EXPECT_EQ(tells(*film, "Its axes are turned"), roles != (std::array<std::size_t, 3>{0, 1, 2}));
    }
}

TEST(StatedFilm, NamesOfAxesThatAreNotKnownAreToldAndDoubleOnesRefused) {
  const auto named = [](const std::vector<const char*>& names) {
    Hdf5File h;
    const hid_t set = h.write<std::uint16_t>("film", {3, 4, 5}, H5T_STD_U16LE, H5T_NATIVE_UINT16, counted().level);
    h.label(set, names);
    H5Dclose(set);
    return h.open();
  };
  EXPECT_TRUE(tells(*named({"scan", "y", "x"}), "The name of its axes \"scan\" is not known"));
  EXPECT_EQ(named({"scan", "v", "u"})->info().width, 5);
  EXPECT_TRUE(named({"", "", ""})->info().remarks.empty());
  EXPECT_NE(test::complaint([&] {
              named({"time", "y", "row"});
            }).find("two axes of rows, \"y\" and \"row\""),
            std::string::npos);
}

TEST(StatedFilm, NumbersBeyondTheValidOnesAreNone) {
  for (const bool as_range : {false, true}) {
    Hdf5File h;
    std::vector<std::int16_t> stored(60, 100);
    stored[3] = 401, stored[7] = -1, stored[9] = 400, stored[11] = 0;
    const hid_t set = h.write<std::int16_t>("T", {3, 4, 5}, H5T_STD_I16LE, H5T_NATIVE_INT16, stored);
    if (as_range) {
      const std::int16_t range[] = {0, 400};
      const hsize_t two = 2;
      const hid_t space = H5Screate_simple(1, &two, nullptr),
                  attribute = H5Acreate2(set, "valid_range", H5T_STD_I16LE, space, H5P_DEFAULT, H5P_DEFAULT);
      H5Awrite(attribute, H5T_NATIVE_INT16, range);
      H5Aclose(attribute), H5Sclose(space);
    } else {  // floating beside whole numbers: of what these stand for
      h.state(set, "valid_min", -0.1), h.state(set, "valid_max", 4.001);
      h.state(set, "scale_factor", 0.01), h.state(set, "add_offset", 0.0);
    }
    H5Dclose(set);
    const FrameBlock all = test::all_of(*h.open());
    for (const std::size_t i : {3, 9, 11, 20}) EXPECT_EQ(std::isnan(all.value[i]), i == 3) << i;
    EXPECT_EQ(std::isnan(all.value[7]), as_range);  // -0.01 is valid, -1 is not
  }
}

TEST(StatedFilm, DeepGroupsAreNotSearchedWithoutEnd) {
  Hdf5File h;
  hid_t group = H5Gcreate2(h.file, "g", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  H5Lcreate_hard(h.file, "g", group, "again", H5P_DEFAULT, H5P_DEFAULT);  // a loop
  for (int depth = 0; depth < 3000; ++depth) {
    const hid_t next = H5Gcreate2(group, "g", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    if (depth == 10)
      H5Dclose(
          H5Dcreate2(next, "numbers", H5T_NATIVE_INT, H5Screate(H5S_SCALAR), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    H5Gclose(group);
    group = next;
  }
  H5Gclose(group);
  EXPECT_NE(test::complaint([&] { h.open(); }).find("holds no dataset of numbers over frames x height x width"),
            std::string::npos);
}

}  // namespace
}  // namespace arenite::io
