#include "io/sample/contact_geometry.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "unit/io/sample/sample_files.hpp"

namespace arenite::io {
namespace {

SampleOptions boxed(std::vector<double> box, std::vector<double> origin = {}) {
  SampleOptions o;
  o.box = std::move(box);
  o.origin = std::move(origin);
  return o;
}

const std::string one_grain = "id,x,y,radius\n5,1,0.9,1\n", on_the_floor = "i,j,fn,ft\n5,bottom,10,1\n";

TEST(ContactsWithWalls, AWallFarFromTheGrainThatTouchesItIsRefused) {
  const Files files(one_grain, on_the_floor);
  EXPECT_EQ(files.problems(boxed({4, 4}, {0, 0})), "");
  const std::string far = files.problems(boxed({4, 4}, {0, -1.5}));  // 2.4 radii
  expect_part(far, "contacts.csv:2: grain 5 of radius 1 m touches the side bottom, but its centre is 2.4 m inside");
  expect_part(far, "correct the row, --box, --origin");
  expect_part(Files(one_grain, "i,j,fn,ft\n5,right,10,1\n").problems(boxed({400, 400})), "399 m inside the box there");
  expect_part(Files(one_grain, "i,j,fn,ft,overlap\n5,right,10,1,0.1\n").problems(boxed({400, 400})), "399 m inside");
  // The file's own box counts as much, and a grain behind its wall touches it no more.
  const auto dump = [](const char* y) {
    return std::string(
               "ITEM: TIMESTEP\n0\nITEM: BOX BOUNDS ff ff pp\n0 4\n0 4\n-1 1\nITEM: ATOMS id x y radius\n1 1 ") +
           y + " 0.5\n";
  };
  const std::string floor = "i,j,fn,ft\n1,bottom,10,0\n";
  EXPECT_EQ(Files(dump("0.5"), floor).problems(), "");
  expect_part(Files(dump("1.5"), floor).problems(), "1.5 m inside the box there");
  expect_part(Files(dump("-0.5"), floor).problems(), "0.5 m outside the box there");
}

TEST(ContactsWithWalls, ABoxThatDoesNotFitTheGrainsIsTold) {
  const Files files(one_grain, on_the_floor);
  EXPECT_FALSE(says(files.read(boxed({4, 4}, {0, 0})).notes, "does not fit")) << "10 % is what grains overlap";
  const Sample s = files.read(boxed({4, 4}, {0, -0.5}));
  EXPECT_TRUE(says(s.notes, "In 1 of 1 contacts with walls the box does not fit the grain"));
  EXPECT_TRUE(says(s.notes, "1.4 radii"));
}

TEST(ContactsWithWalls, APeriodicAxisHasNone) {
  SampleOptions o = boxed({4, 4});
  o.periodic[1] = true;
  expect_part(Files(one_grain, on_the_floor).problems(o),
              "contacts.csv:2: grain 5 touches the side bottom, but the box is periodic along y");
  o.periodic = {true, false, false};
  EXPECT_EQ(Files(one_grain, on_the_floor).problems(o), "");
}

/// MercuryDPM and YADE name no side; their walls need not be those of the box.
TEST(ContactsWithWalls, WallsThatAFileDoesNotNameAreNotRefused) {
  const std::string grains = "2 0.5 0 0 0 4 4 4\n2 1 1 0 0 0 0.5 1 0 0 0 0 0 0\n1.9 1 2.1 0 0 0 0.5 1 0 0 0 0 0 0\n",
                    wall = "# 0.5 0\n# 0 0 0 4 4 4\n# 0.5 0.5 0 0 0 0\n0.5 0 -1 1.5 1 1 0.01 0 7 0 -1 0 0 0 0 0\n";
  EXPECT_EQ(Files(grains, wall).problems_of_spheres(), "");
  EXPECT_TRUE(says(Files(grains, wall).spheres().notes, "the box does not fit the grain"));
}

std::string turned_by(double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  return std::to_string(std::cos(angle)) + "," + std::to_string(std::sin(angle)) + "\n";
}

TEST(NormalsOfContacts, ThatContradictTheCentresAreRefusedAndAFewAreTold) {
  const std::string grains = "id,x,y,radius\n1,0,0,1\n2,1.9,0,1\n3,3.8,0,1\n", head = "i,j,fn,ft,nx,ny\n";
  const auto with = [&](double first, double second) {
    return Files(grains, head + "1,2,10,0," + turned_by(first) + "2,3,10,0," + turned_by(second));
  };
  EXPECT_FALSE(says(with(10, -15).read().notes, "normals"));
  EXPECT_TRUE(says(with(0, 30).read().notes, "1 of 2 normals are turned by more than 20 degrees"));
  EXPECT_TRUE(says(with(0, 30).read().notes, "by up to 30"));
  expect_part(with(90, 90).problems(), "2 of 2 normals are turned by more than 20 degrees");
  expect_part(with(180, 175).problems(), "by up to 180; give nx, ny from i to j");
  // Grains that give the points where they touch need not be round.
  EXPECT_EQ(Files(grains, "i,j,fn,ft,nx,ny,x,y\n1,2,10,0,0,1,0.95,0.2\n").problems(), "");
  // Across a side whose cell nobody gave the normal is all that is known.
  EXPECT_EQ(Files("id,x,y,radius\n1,0,0,1\n2,9,0,1\n", head + "1,2,10,0,-1,0\n").problems(), "");
}

}  // namespace
}  // namespace arenite::io
