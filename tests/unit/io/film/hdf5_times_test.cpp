#include "io/film/hdf5_times.hpp"

#include <gtest/gtest.h>
#include <hdf5.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "support/films.hpp"
#include "unit/io/film/hdf5_file.hpp"
#include "unit/io/film/stated.hpp"

namespace arenite::io {
namespace {

using test::counted;
using Numbers64 = std::vector<std::int64_t>;
using Times = std::vector<double>;

/// A film of three frames.
struct ThreeFrames : Hdf5File {
  hid_t set = write<std::uint16_t>("film", {3, 4, 5}, H5T_STD_U16LE, H5T_NATIVE_UINT16, counted().level);
  void beside(const char* name, const Times& values, const char* attribute = nullptr, const char* text = nullptr) {
    const hid_t it = write<double>(name, {values.size()}, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, values);
    if (attribute != nullptr) state(it, attribute, text);
    H5Dclose(it);
  }
  static void list(hid_t at, const char* name, const Times& values) {
    const hsize_t count = values.size();
    const hid_t space = H5Screate_simple(1, &count, nullptr),
                it = H5Acreate2(at, name, H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(it, H5T_NATIVE_DOUBLE, values.data());
    H5Aclose(it), H5Sclose(space);
  }
  std::unique_ptr<FilmSource> film(const FilmChoice& choice = {}) {
    H5Dclose(set);
    H5Fclose(file);
    return open_film(folder / "a.h5", choice);
  }
};

TEST(Hdf5Times, NumbersOfFramesWithGapsAreMissingFrames) {
  for (const char* name : {"frame_number", "frame_numbers", "frame_index", "frame_id", "FrameID"}) {
    ThreeFrames h;
    h.beside(name, {7, 8, 11});
    const auto film = h.film();
    EXPECT_EQ(film->info().number, (Numbers64{0, 1, 4})) << name;
    EXPECT_TRUE(tells(*film, "By their numbers 2 frames are missing")) << name;
  }
  ThreeFrames halves;
  halves.beside("frame_number", {7, 8.5, 11});
  EXPECT_TRUE(tells(*halves.film(), "\"frame_number\" are not all whole numbers"));
}

TEST(Hdf5Times, StampsHaveManyNames) {
  for (const char* name :
       {"timestamp", "t", "frame_times", "frame_time", "time_s", "acquisition_time", "relative_time", "Timestamps"}) {
    ThreeFrames h;
    h.beside(name, {1, 1.5, 3});
    EXPECT_EQ(h.film()->info().time, (Times{0, 0.5, 2})) << name;
  }
  ThreeFrames of_name, of_attribute, temperatures;
  of_name.beside("time_ms", {1000, 1500, 3000});
  EXPECT_EQ(of_name.film()->info().time, (Times{0, 0.5, 2}));
  of_attribute.beside("timestamp", {1000, 1500, 3000}, "unit", "ms");
  EXPECT_EQ(of_attribute.film()->info().time, (Times{0, 0.5, 2}));
  temperatures.beside("T", {1, 1.5, 3});
  EXPECT_TRUE(temperatures.film()->info().time.empty());
}

TEST(Hdf5Times, AttributesOfOneNumberAFrameAreTimes) {
  ThreeFrames of_set, of_file, other;
  of_set.list(of_set.set, "time", {1, 1.5, 3});
  EXPECT_EQ(of_set.film()->info().time, (Times{0, 0.5, 2}));
  of_file.list(of_file.file, "timestamps", {1, 1.5, 3});
  EXPECT_EQ(of_file.film()->info().time, (Times{0, 0.5, 2}));
  other.list(other.set, "time", {1, 1.5});
  const auto film = other.film();
  EXPECT_TRUE(film->info().time.empty());
  EXPECT_TRUE(tells(*film, "\"time\" are not a number for each of the 3 frames"));
}

TEST(Hdf5Times, WithoutAUnitTheFrameRateShowsIt) {
  ThreeFrames h, seconds;
  h.state(h.set, "frame_rate", 50.0);
  h.beside("timestamp", {1e9, 1.02e9, 1.06e9});
  const auto film = h.film();
  ASSERT_EQ(film->info().time.size(), 3U);
  EXPECT_NEAR(film->info().time[2], 0.06, 1e-9);
  EXPECT_TRUE(tells(*film, "\"timestamp\" state no unit; ns are taken, which fit the frame rate"))
      << film->info().remarks.at(0);
}

TEST(Hdf5Times, TimesCountBeforeNumbersUnlessARateIsGiven) {
  const auto both = [](const Times& time) {
    auto h = std::make_unique<ThreeFrames>();
    h->beside("time", time, "units", "s");
    h->beside("frame_number", {7, 8, 11});
    return h;
  };
  const auto agreeing = both({1, 1.5, 3})->film();
  EXPECT_EQ(agreeing->info().time, (Times{0, 0.5, 2}));
  EXPECT_TRUE(agreeing->info().remarks.empty());
  EXPECT_TRUE(tells(*both({1, 1.5, 2})->film(), "By their numbers 2 frames are missing, by their times 0"));
  const auto rated = both({1, 1.5, 2})->film({.frame_rate = 30.0});
  EXPECT_TRUE(rated->info().time.empty());
  EXPECT_EQ(rated->info().number, (Numbers64{0, 1, 4}));
}

TEST(Hdf5Times, WhatIsLeftAsideIsTold) {
  ThreeFrames h, masked;
  h.beside("time", {1, 1.5, 3});
  h.beside("timestamps", {1, 1.5, 3.5});
  EXPECT_TRUE(tells(*h.film(), "\"timestamps\" are left aside beside \"time\""));
  const hid_t type = H5Tenum_create(H5T_STD_I8LE);  // as h5py writes truth values
  for (const std::int8_t value : {0, 1}) H5Tenum_insert(type, value == 0 ? "FALSE" : "TRUE", &value);
  H5Dclose(masked.write<std::int8_t>("mask", {3, 4, 5}, type, type, std::vector<std::int8_t>(60, 0)));
  H5Tclose(type);
  EXPECT_TRUE(tells(*masked.film(), "\"mask\" is left aside"));
}

TEST(Hdf5Times, TheUnitOfPixelsHasTwoNamesAndTwoPlaces) {
  for (const char* name : {"units", "unit"})
    for (const bool of_file : {false, true}) {
      ThreeFrames h;
      h.state(of_file ? h.file : h.set, name, "degC");
      const auto film = h.film();
      EXPECT_EQ(film->info().quantity, FilmQuantity::kelvin) << name;
      EXPECT_NEAR(test::all_of(*film).value[1], static_cast<float>(counted().level[1]) + 273.15F, 1e-3);
      EXPECT_EQ(tells(*film, "The file states the unit \"degC\""), of_file);
    }
}

}  // namespace
}  // namespace arenite::io
