#include "io/volume/spheres.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "support/temporary_folder.hpp"

namespace arenite::io {
namespace {

SpherePack read(const char* name, const std::string& text) {
  const test::TemporaryFolder folder;
  const auto file = folder / name;
  std::ofstream(file) << text;
  EXPECT_TRUE(is_sphere_table(file));
  std::vector<std::string> notes;
  return read_spheres(file, notes);
}

std::string refusal(const char* name, const std::string& text) {
  try {
    read(name, text);
  } catch (const InputError& error) { return error.what(); }
  return {};
}

TEST(Spheres, ATableSaysItsColumnsAndTheirUnits) {
  const SpherePack pack = read("s.csv", "id,z [mm],x [mm],y [mm],diameter [mm]\n1,3,1,2,2\n2,6,1,2,4\n");
  ASSERT_EQ(pack.size(), 2u);
  EXPECT_FALSE(pack.periodic);
  EXPECT_DOUBLE_EQ(pack.centre[0].z, 3e-3);
  EXPECT_DOUBLE_EQ(pack.radius[1], 2e-3);
  EXPECT_DOUBLE_EQ(pack.low.z, 2e-3);
  EXPECT_DOUBLE_EQ(pack.high.z, 8e-3);
  EXPECT_DOUBLE_EQ(pack.low.x, -1e-3);
  EXPECT_EQ(pack.label[1], 1);
}

TEST(Spheres, OfLbpmTheDomainCounts) {
  const std::string head = "Number of Spheres: 2\nDomain Length (x,y,z):  1, 2, 3\nMedia porosity: 0.36\n";
  const SpherePack pack = read("pack.out", head + "0.1 0.2 0.3 0.05\n0.4 0.5 0.6 0.07\n");
  ASSERT_EQ(pack.size(), 2u);
  EXPECT_TRUE(pack.periodic);
  EXPECT_EQ(pack.high, (Vec3{1, 2, 3}));
  EXPECT_EQ(pack.radius[1], 0.07);
  EXPECT_NE(refusal("pack.out", head + "0.1 0.2 0.3 0.05\n").find("says 2 spheres and holds 1"), std::string::npos);
  EXPECT_NE(refusal("pack.out", head + "0.1 0.2 0.3 0.05\n0.4 0.5 0.07\n").find("pack.out:5"), std::string::npos);
  EXPECT_NE(refusal("pack.out", "Number of Spheres: 1\n0.1 0.2 0.3 0.05\n").find("domain"), std::string::npos);
}

TEST(Spheres, WhatIsNoSphereIsRefused) {
  EXPECT_NE(refusal("s.csv", "x,y,radius\n1,2,3\n").find("there is no column \"z\""), std::string::npos);
  EXPECT_NE(refusal("s.csv", "x,y,z,radius\n1,2,3,-1\n").find("s.csv:2"), std::string::npos);
  EXPECT_NE(refusal("s.csv", "x,y,z,radius\n1,2,three,1\n").find("three"), std::string::npos);
}

}  // namespace
}  // namespace arenite::io
