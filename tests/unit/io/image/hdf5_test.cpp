#include <gtest/gtest.h>
#include <hdf5.h>

#include "io/disk/file.hpp"
#include "io/image/image.hpp"
#include "support/pictures.hpp"
#include "support/temporary_folder.hpp"

namespace {
using namespace arenite;
using namespace arenite::test;
using Values = std::vector<std::int32_t>;

/// A file with datasets of any shape, all of the same numbers.
class Hdf5Image : public ::testing::Test {
 protected:
  Hdf5Image() : path_(folder_ / "a.h5"), file_(H5Fcreate(path_.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT)) {}
  void write(const char* name, std::vector<hsize_t> shape, hid_t type, std::vector<std::int64_t> values) {
    const hid_t space = H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr);
    const hid_t set = H5Dcreate2(file_, name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    if (!values.empty()) H5Dwrite(set, H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    H5Dclose(set);
    H5Sclose(space);
  }
  std::string bytes() {
    if (file_ >= 0) H5Fclose(file_);
    file_ = -1;
    return io::read_file(path_);
  }
  Image decode(const io::ImageChoice& choice = {}) { return io::decode_image(bytes(), "a.h5", choice); }
  std::string refusal(const io::ImageChoice& choice = {}) {
    return complaint([&] { decode(choice); });
  }
  TemporaryFolder folder_;
  std::filesystem::path path_;
  hid_t file_;
};

TEST_F(Hdf5Image, FindsTheOnlyDatasetThatCanBeAPicture) {
  write("numbers", {3}, H5T_STD_I32LE, {1, 2, 3});
  write("fractions", {1, 2}, H5T_IEEE_F64LE, {1, 2});
  write("map", {2, 3}, H5T_STD_U8BE, {0, 85, 170, 1, 2, 255});
  const Image image = decode();
  EXPECT_EQ(image.width, 3);
  EXPECT_EQ(image.height, 2);
  EXPECT_EQ(image.value, (Values{0, 85, 170, 1, 2, 255}));
}

TEST_F(Hdf5Image, FloatingNumbersMustBeWhole) {
  write("labels", {2, 2}, H5T_IEEE_F64LE, {1, 2, 0, -3});
  EXPECT_EQ(decode().value, (Values{1, 2, 0, -3}));
}

TEST_F(Hdf5Image, FractionsAreNoLabels) {
  const double values[] = {1, 2.5};
  const hsize_t shape[] = {1, 2};
  const hid_t space = H5Screate_simple(2, shape, nullptr);
  const hid_t set = H5Dcreate2(file_, "labels", H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values);
  H5Dclose(set);
  H5Sclose(space);
  EXPECT_EQ(
      refusal(),
      "a.h5: holds floating-point numbers with fractions (2.5 at pixel 1, 0); save whole numbers, one value per phase");
}

/// MATLAB's array of 2 rows and 3 columns, [1 2 3; 4 5 6], and a stack of two of them along the third axis.
TEST_F(Hdf5Image, OfMatlabIsTurned) {
  const auto by_matlab = [&](const char* name) {
    const hid_t set = H5Dopen2(file_, name, H5P_DEFAULT), space = H5Screate(H5S_SCALAR);
    const hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, 6);
    const hid_t attribute = H5Acreate2(set, "MATLAB_class", type, space, H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(attribute, type, "double");
    H5Aclose(attribute);
    H5Tclose(type);
    H5Sclose(space);
    H5Dclose(set);
  };
  write("map", {3, 2}, H5T_IEEE_F64LE, {1, 4, 2, 5, 3, 6});
  write("stack", {2, 3, 2}, H5T_STD_U8LE, {1, 4, 2, 5, 3, 6, 11, 14, 12, 15, 13, 16});
  by_matlab("map");
  by_matlab("stack");
  const Image map = decode({.slice = {}, .dataset = "map"});
  EXPECT_EQ(map.width, 3);
  EXPECT_EQ(map.height, 2);
  EXPECT_EQ(map.value, (Values{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(decode({.slice = 1, .dataset = "stack"}).value, (Values{11, 12, 13, 14, 15, 16}));
}

TEST_F(Hdf5Image, WhatStandsForNoNumberIsRefusedAndScalesCount) {
  const auto state = [&](const char* set, const char* name, int value) {
    const hid_t at = H5Dopen2(file_, set, H5P_DEFAULT), space = H5Screate(H5S_SCALAR);
    const hid_t attribute = H5Acreate2(at, name, H5T_STD_I32LE, space, H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(attribute, H5T_NATIVE_INT, &value);
    H5Aclose(attribute), H5Sclose(space), H5Dclose(at);
  };
  for (const char* name : {"filled", "unused", "beyond", "scaled"}) write(name, {1, 3}, H5T_STD_U8LE, {1, 2, 1});
  state("filled", "_FillValue", 2);
  state("unused", "_FillValue", 255);
  state("beyond", "valid_max", 1);
  state("scaled", "add_offset", 4);
  EXPECT_NE(refusal({.slice = {}, .dataset = "filled"}).find("holds 2 at pixel 1, 0, which stands for no number"),
            std::string::npos);
  EXPECT_NE(refusal({.slice = {}, .dataset = "beyond"}).find("valid range"), std::string::npos);
  EXPECT_EQ(decode({.slice = {}, .dataset = "unused"}).value, (Values{1, 2, 1}));
  EXPECT_EQ(decode({.slice = {}, .dataset = "scaled"}).value, (Values{5, 6, 5}));
}

TEST_F(Hdf5Image, AsksWhichOfTwoAndWhichSlice) {
  write("labels", {1, 2}, H5T_STD_I32LE, {-1, 70000});
  write("stack", {2, 1, 2}, H5T_STD_U16LE, {1, 2, 3, 4});
  EXPECT_EQ(refusal(), "a.h5: holds 2 possible datasets; choose one with --dataset: labels, stack");
  EXPECT_EQ(decode({.slice = {}, .dataset = "labels"}).value, (Values{-1, 70000}));
  EXPECT_NE(refusal({.slice = {}, .dataset = "stack"}).find("stack of 2 slices"), std::string::npos);
  EXPECT_EQ(decode({.slice = 1, .dataset = "stack"}).value, (Values{3, 4}));
  EXPECT_EQ(refusal({.slice = {}, .dataset = "lables"}),
            "a.h5: has no dataset \"lables\" of whole numbers with two or three dimensions; it has: labels, stack");
}

TEST_F(Hdf5Image, RefusesWhatIsNoPicture) {
  write("line", {2}, H5T_STD_I32LE, {1, 2});
  EXPECT_NE(refusal().find("no dataset of whole numbers"), std::string::npos);
  EXPECT_NE(refusal({.slice = {}, .dataset = "fraction"}).find("has no dataset \"fraction\" of whole numbers"),
            std::string::npos);
}

TEST_F(Hdf5Image, RefusesValuesAndSizesBeyondItsMeans) {
  write("large", {1, 1}, H5T_STD_U32LE, {4000000000});
  write("huge", {1 << 20, 1 << 20}, H5T_STD_U8LE, {});
  write("empty", {0, 4}, H5T_STD_U8LE, {});
  EXPECT_NE(refusal({.slice = {}, .dataset = "large"}).find("the value 4000000000"), std::string::npos);
  EXPECT_NE(refusal({.slice = {}, .dataset = "huge"}).find("100 million can be read"), std::string::npos);
  EXPECT_NE(refusal({.slice = {}, .dataset = "empty"}).find("4 x 0 pixels"), std::string::npos);
}

TEST_F(Hdf5Image, RefusesAFileCutShort) {
  write("map", {2, 3}, H5T_STD_U8LE, {0, 85, 170, 1, 2, 255});
  const std::string whole = bytes();
  for (std::size_t n = 8; n < whole.size(); n += 64)
    EXPECT_FALSE(complaint([&] { io::decode_image(whole.substr(0, n), "a.h5"); }).empty()) << n;
}

}  // namespace
