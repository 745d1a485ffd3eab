#include "io/film/film.hpp"

#include <gtest/gtest.h>
#include <hdf5.h>

#include <stdexcept>

#include "core/error.hpp"
#include "support/films.hpp"
#include "support/pictures.hpp"
#include "support/small_disk.hpp"
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
  EXPECT_NE(test::complaint([&] { write_film(folder / "a.avi", film); }).find("tiff, npy, hdf5, sfmov, ptw"),
            std::string::npos);
  EXPECT_THROW(create_film(folder / "a.npy", film.about)->append(FrameBlock{0, 1, std::vector<std::uint16_t>(9), {}}),
               std::invalid_argument);
  EXPECT_EQ(folder.count(), 0);
}

/// Wherever the disk fills, at the header, in frames or at the end, there is a refusal and no file, and the process
/// goes on.
TEST(FilmWriter, AFullDiskLeavesNothingAndIsTold) {
  const test::TemporaryFolder folder;
  for (const std::string& ending : endings) {
    Film film = test::counted(40, 30, 8);
    film.about.time = {0, 1, 2, 3, 4, 5, 6, 7};
    write_film(folder / ("whole" + ending), film);
    const auto whole = std::filesystem::file_size(folder / ("whole" + ending));
    for (std::uintmax_t room = 0; room < whole; room += whole / 23 + 1) {
      SCOPED_TRACE(ending + " " + std::to_string(room));
      std::string said;
      {
        const test::SmallDisk disk(room);
        said = test::complaint([&] { write_film(folder / ("film" + ending), film); });
      }
      EXPECT_NE(said.find("cannot be written"), std::string::npos) << said;
      EXPECT_FALSE(std::filesystem::exists(folder / ("film" + ending)));
    }
    write_film(folder / ("film" + ending), film);
    EXPECT_EQ(std::filesystem::file_size(folder / ("film" + ending)), whole);
  }
  EXPECT_EQ(folder.count(), 10);
}

/// Not by our reader: HDF5 itself must find all of it.
TEST(FilmWriter, Hdf5IsReadByHdf5) {
  const test::TemporaryFolder folder;
  for (const bool floating : {false, true}) {
    Film film = test::counted(7, 5, 4, floating);
    film.about.time = {0, 0.008, 0.016, 0.032};
    write_film(folder / "film.h5", film);
    const hid_t file = H5Fopen((folder / "film.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    ASSERT_GE(file, 0);
    const hid_t set = H5Dopen2(file, "frames", H5P_DEFAULT), space = H5Dget_space(set),
                time = H5Dopen2(file, "time", H5P_DEFAULT);
    hsize_t shape[3] = {};
    ASSERT_EQ(H5Sget_simple_extent_dims(space, shape, nullptr), 3);
    EXPECT_EQ(shape[0], 4U);
    EXPECT_EQ(shape[1], 5U);
    EXPECT_EQ(shape[2], 7U);
    std::vector<float> value(140);
    ASSERT_GE(H5Dread(set, H5T_NATIVE_FLOAT, H5S_ALL, H5S_ALL, H5P_DEFAULT, value.data()), 0);
    for (std::size_t i = 0; i < value.size(); ++i)
      EXPECT_EQ(value[i], floating ? film.value[i] : static_cast<float>(film.level[i]));
    std::vector<double> stamps(4);
    ASSERT_GE(H5Dread(time, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, stamps.data()), 0);
    EXPECT_EQ(stamps, film.about.time);
    const hid_t rate = H5Aopen(set, "frame_rate", H5P_DEFAULT);
    double hertz = 0;
    ASSERT_GE(H5Aread(rate, H5T_NATIVE_DOUBLE, &hertz), 0);
    EXPECT_EQ(hertz, 125);
    H5Aclose(rate);
    H5Dclose(time);
    H5Sclose(space);
    H5Dclose(set);
    EXPECT_GE(H5Fclose(file), 0);
  }
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
