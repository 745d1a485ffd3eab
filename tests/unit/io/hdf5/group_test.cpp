#include "io/hdf5/group.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "core/error.hpp"

namespace {
using namespace arenite;
using io::Hdf5Group;

std::string refusal(const std::function<void()>& act) {
  try {
    act();
  } catch (const InputError& error) { return error.what(); }
  return "";
}

/// Puts a value into what is written.
template <class T> void put(const Hdf5Group& at, const char* name, T value) { at(name, value); }
template <class T> void put(const Hdf5Group& at, const char* name, std::vector<T> values, const char* unit = "1") {
  at.array(name, values, unit);
}

/// Takes a value out of what is read.
template <class T> T take(const Hdf5Group& at, const char* name) {
  T value{};
  at(name, value);
  return value;
}
template <class T> std::vector<T> take_array(const Hdf5Group& at, const char* name) {
  std::vector<T> values;
  at.array(name, values);
  return values;
}
std::string take_text(const Hdf5Group& at, const char* name) {
  std::string text;
  at.text(name, text);
  return text;
}

Hdf5Group written() {
  const Hdf5Group file;
  const auto group = file.group("frames").group("0000");
  put(group, "x", std::vector<double>{1, 2}, "m");
  put(group, "empty", std::vector<std::int32_t>{});
  put(group, "time [s]", 0.5);
  put(group, "label", std::string());
  std::string recipe = "a = 1\n";
  group.text("recipe", recipe);
  return {file.bytes(), "some.h5"};
}

TEST(Hdf5Group, TellsTheFileAndThePlaceOfWhatIsMissing) {
  const auto frame = written().group("frames").group("0000");
  EXPECT_EQ(refusal([&] { take_array<double>(frame, "y"); }),
            "some.h5: /frames/0000 has no array \"y\"; remove the file and make it again with \"arenite run\"");
  EXPECT_NE(refusal([&] { frame.group("contacts"); }).find("no group \"contacts\""), std::string::npos);
  EXPECT_NE(refusal([&] { take<double>(frame, "step"); }).find("no attribute \"step\""), std::string::npos);
  EXPECT_NE(refusal([&] { take_text(frame, "label"); }).find("no text \"label\""), std::string::npos);
}

TEST(Hdf5Group, TellsWhatIsOfAnotherKind) {
  const auto frame = written().group("frames").group("0000");
  EXPECT_NE(refusal([&] { take_text(frame, "x"); }).find("not text"), std::string::npos);
  EXPECT_NE(refusal([&] { take<std::string>(frame, "time [s]"); }).find("not text"), std::string::npos);
  EXPECT_NE(refusal([&] { take_array<double>(frame, "recipe"); }).find("not a one-dimensional array"),
            std::string::npos);
  EXPECT_NE(refusal([&] { take<double>(frame, "label"); }).find("not one number"), std::string::npos);
}

TEST(Hdf5Group, GivesBackEmptyArraysAndTextsAndTheOrderOfMembers) {
  const auto frame = written().group("frames").group("0000");
  EXPECT_TRUE(take_array<std::int32_t>(frame, "empty").empty());
  EXPECT_EQ(take<std::string>(frame, "label"), "");
  EXPECT_EQ(frame.unit("x"), "m");
  EXPECT_EQ(frame.names(), (std::vector<std::string>{"x", "empty", "recipe"}));
  EXPECT_EQ(frame.attribute_names(), (std::vector<std::string>{"time [s]", "label"}));
}

TEST(Hdf5Group, BytesThatAreNotHdf5AreAnInputError) {
  EXPECT_NE(refusal([] { Hdf5Group("not HDF5 at all", "some.h5"); }).find("some.h5: is not a readable HDF5 file"),
            std::string::npos);
}

}  // namespace
