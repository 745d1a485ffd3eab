#include "io/hdf5/group.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "core/error.hpp"

namespace {
using namespace arenite;
using io::Hdf5Reader;
using io::Hdf5Writer;

std::string complaint(const std::function<void()>& act) {
  try {
    act();
  } catch (const InputError& error) { return error.what(); }
  return "";
}

Hdf5Reader sample() {
  const Hdf5Writer file;
  const auto group = file.create_group("frames").create_group("0000");
  group.write("x", std::vector<double>{1, 2}, "m");
  group.write("empty", std::vector<std::int32_t>{});
  group.set("time [s]", 0.5);
  group.set("label", std::string_view(""));
  group.write_text("recipe", "a = 1\n");
  return {file.bytes(), "some.h5"};
}

TEST(Hdf5Reader, TellsTheFileAndThePlaceOfWhatIsMissing) {
  const auto frame = sample().group("frames").group("0000");
  EXPECT_EQ(complaint([&] { frame.array<double>("y"); }), "some.h5: /frames/0000 has no array \"y\"; remove the file and make it again with \"arenite run\"");
  EXPECT_NE(complaint([&] { frame.group("contacts"); }).find("no group \"contacts\""), std::string::npos);
  EXPECT_NE(complaint([&] { frame.number("step"); }).find("no attribute \"step\""), std::string::npos);
  EXPECT_NE(complaint([&] { frame.text("label"); }).find("no text \"label\""), std::string::npos);
}

TEST(Hdf5Reader, TellsWhatIsOfAnotherKind) {
  const auto frame = sample().group("frames").group("0000");
  EXPECT_NE(complaint([&] { frame.text("x"); }).find("not text"), std::string::npos);
  EXPECT_NE(complaint([&] { frame.label("time [s]"); }).find("not text"), std::string::npos);
  EXPECT_NE(complaint([&] { frame.array<double>("recipe"); }).find("not a one-dimensional array"), std::string::npos);
  EXPECT_NE(complaint([&] { frame.number("label"); }).find("not one number"), std::string::npos);
}

TEST(Hdf5Reader, GivesBackEmptyArraysAndTextsAndTheOrderOfMembers) {
  const auto frame = sample().group("frames").group("0000");
  EXPECT_TRUE(frame.array<std::int32_t>("empty").empty());
  EXPECT_EQ(frame.label("label"), "");
  EXPECT_EQ(frame.unit("x"), "m");
  EXPECT_EQ(frame.names(), (std::vector<std::string>{"x", "empty", "recipe"}));
  EXPECT_EQ(frame.attribute_names(), (std::vector<std::string>{"time [s]", "label"}));
}

TEST(Hdf5Reader, BytesThatAreNotHdf5AreAnInputError) {
  EXPECT_NE(complaint([] { Hdf5Reader("not HDF5 at all", "some.h5"); }).find("some.h5: is not a readable HDF5 file"), std::string::npos);
}

}  // namespace
