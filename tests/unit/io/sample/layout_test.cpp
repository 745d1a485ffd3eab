#include "io/sample/layout.hpp"

#include <gtest/gtest.h>

#include "unit/io/sample/sample_files.hpp"

namespace arenite::io {
namespace {

std::string frame_of(const std::string& lattice, const std::string& pbc) {
  return "2\nLattice=\"" + lattice + "\" pbc=\"" + pbc +
         "\" Properties=species:S:1:pos:R:3:radius:R:1\nX 1 1 1 0.5\nX 1.9 1 3.5 0.5\n";
}

TEST(StatedBox, OneThatDoesNotHoldTheCentresBetweenItsWallsIsRefused) {
  const auto problems = [](const std::string& lattice, const std::string& pbc, const SampleOptions& o = {}) {
    return Files(frame_of(lattice, pbc), "").problems_of_spheres(o);
  };
  const std::string small = "4 0 0 0 4 0 0 0 2", whole = "4 0 0 0 4 0 0 0 4";
  EXPECT_EQ(problems(whole, "F F F"), "");
  const std::string told = problems(small, "F F F");
  expect_part(told, "the centres span 2.5 m along z, more than the box's 2 m; correct the box that the file states");
  EXPECT_EQ(problems(small, "F F T"), "") << "images of one another";
  SampleOptions larger;
  larger.box = {4, 4, 4};
  EXPECT_EQ(problems(small, "F F F", larger), "") << "the one that is given counts";
  std::string dump = lammps_atoms;
  dump.replace(dump.find("ff pp\n0 4"), 9, "ff pp\n0 0.8");
  expect_part(Files(dump, "i,j,fn,ft\n").problems(), "the centres span 0.9 m along x, more than the box's 0.8 m");
}

TEST(StatedBox, CentresBesideItAreTold) {
  std::string dump = lammps_atoms;
  dump.replace(dump.find("ff pp\n0 4"), 9, "ff pp\n1.5 4");
  EXPECT_TRUE(says(Files(dump, "i,j,fn,ft\n").read().notes, "Centres lie from 1 to 1.9 m along x, in part outside"));
  EXPECT_FALSE(says(Files(lammps_atoms, "i,j,fn,ft\n").read().notes, "outside"));
}

TEST(StatedBox, OneOfNoSizeIsLeftAsideAndTold) {
  const auto s = Files(frame_of("-4 0 0 0 4 0 0 0 4", "T T T"), "").spheres();
  EXPECT_TRUE(says(s.notes, "a box of -4 m along x, which is no size, so its box is left aside"));
  EXPECT_FALSE(s.packing.domain.is_cell());
}

TEST(GivenBox, ItsAxesAreNamedAsTheSampleLies) {
  SampleOptions o;
  o.box = {4, 0.5};
  expect_part(Files("id,x,y,z,radius\n1,1,0,1,0.5\n2,1.9,0,2,0.5\n", "i,j,fn,ft\n").problems(o),
              "the centres span 1 m along z, more than the box's 0.5 m; correct --box");
}

}  // namespace
}  // namespace arenite::io
