#include <gtest/gtest.h>

#include "unit/io/sample/sample_files.hpp"

// What tables of other programs leave open is used, refused or told.
namespace arenite::io {
namespace {

const std::string no_contacts = "i,j,fn,ft\n", touching = "id,x,y,radius\n1,0,0,1\n2,1.9,0,1\n";

TEST(SampleCsv, UnitsOfSomeColumnsOnlyAreToldAndOfAVectorRefused) {
  const auto notes = [](const std::string& grains, const SampleOptions& o = {}) {
    return Files(grains, no_contacts).read(o).notes;
  };
  const std::string some = "id,x [mm],y [mm],radius\n1,0,0,1\n";
  EXPECT_TRUE(says(notes(some), "No unit is stated for radius, while one is for x, y: SI (m, N) was assumed"));
  EXPECT_FALSE(says(notes("id,x [mm],y [mm],radius [mm]\n1,0,0,1\n"), "unit of length")) << "all state theirs";
  EXPECT_FALSE(says(notes(touching), "while")) << "none states any";
  SampleOptions metres;
  metres.length_unit = 1;
  EXPECT_FALSE(says(notes(some, metres), "unit is stated")) << "the option says it";
  expect_part(Files("id,x [mm],y,radius [mm]\n1,0,0,1\n", no_contacts).problems(),
              "grains.csv:1: a unit is stated for x and none for y, which is the same vector; give it for all");
  const Sample s = Files(touching, "i,j,fn [kN],ft,overlap [mm]\n1,2,5,1,1\n").read();
  EXPECT_TRUE(says(s.notes, "No unit is stated for ft, while one is for fn, overlap"));
  expect_part(Files(touching, "i,j,fx [kN],fy\n1,2,5,1\n").problems(),
              "contacts.csv:1: a unit is stated for fx and none");
}

TEST(SampleCsv, ARadiusThatItsDiameterContradictsIsRefused) {
  EXPECT_EQ(Files("id,x,y,radius,diameter [mm]\n1,0,0,1,2000\n", no_contacts).read().packing.grains.radius.at(0), 1);
  expect_part(Files("id,x,y,radius,diameter\n1,0,0,1,2\n2,3,0,1,1\n", no_contacts).problems(),
              "grains.csv:3: radius and diameter contradict each other");
}

TEST(SampleCsv, GrainsAtOnePlaceAreTold) {
  const auto notes = [](const std::string& rows) { return Files("id,x,y,radius\n" + rows, no_contacts).read().notes; };
  EXPECT_TRUE(says(notes("1,0,0,1\n2,3,0,1\n7,0,0,1\n"),
                   "One grain lies at the centre of another, the first with ids 1 and 7; each counts"));
  EXPECT_TRUE(says(notes("1,3,0,1\n2,3,0,1\n7,0,0,1\n8,0,0,1\n"), "2 grains lie at the centre of another"));
  EXPECT_FALSE(says(notes("1,0,0,1\n2,3,0,1\n"), "centre of another"));
}

TEST(SampleCsv, AWallThatIsNamedFirstIsTheSameContact) {
  SampleOptions o;
  o.box = {4, 4};
  const std::string grain = "id,x,y,radius\n1,1,0.9,1\n";
  for (const char* contacts : {"i,j,fn,ft\n1,bottom,10,1\n", "i,j,fn,ft\nbottom,1,10,1\n",
                               "i,j,fx,fy\n1,bottom,1,-10\n", "i,j,fx,fy\nbottom,1,-1,10\n",
                               "i,j,fn,ft,nx,ny\n1,bottom,10,1,0,-1\n", "i,j,fn,ft,nx,ny\nbottom,1,10,1,0,1\n"}) {
    const Contacts c = Files(grain, contacts).read(o).packing.contacts;
    ASSERT_EQ(c.size(), 1u) << contacts;
    EXPECT_EQ(c.wall_side(0), bottom) << contacts;
    EXPECT_NEAR(norm(c.force_on_i(0) - Vec2{-1, 10}), 0, 1e-12) << contacts;
  }
}

TEST(SampleCsv, TheLargestStepIsTheLastAndOneWithFewerGrainsIsTold) {
  const std::string back = "step,id,x,y,radius\n200,1,2,0,1\n200,2,5,0,1\n100,1,1,0,1\n100,2,4,0,1\n";
  const Sample s = Files(back, no_contacts).read();
  EXPECT_DOUBLE_EQ(s.packing.grains.position.at(0).x, 2);
  EXPECT_TRUE(says(s.notes, "2 snapshots, of which that of step 200 was taken"));
  EXPECT_FALSE(says(s.notes, "cut off"));
  const Sample cut = Files("step,id,x,y,radius\n1,1,2,0,1\n1,2,5,0,1\n2,1,1,0,1\n", no_contacts).read();
  EXPECT_EQ(cut.packing.grains.size(), 1u);
  EXPECT_TRUE(says(cut.notes, "has 1 grains, and another of the file 2"));
}

TEST(SampleCsv, GrainsWithoutAMaterialAmongOthersAreTold) {
  const auto read = [](const std::string& first, const std::string& second) {
    return Files("id,x,y,radius,material\n7,0,0,1," + first + "\n9,3,0,1," + second + "\n", no_contacts).read();
  };
  EXPECT_TRUE(says(read("POM", "").notes,
                   "1 of 2 grains state no material, the first, 9, in line 3; they are of the "
                   "material \"grain\""));
  EXPECT_NE(read("POM", "").packing.grains.material[0], read("POM", "").packing.grains.material[1]);
  EXPECT_TRUE(says(read("", "POM").notes, "the first, 7, in line 2"));
  EXPECT_FALSE(says(read("", "").notes, "material"));
  EXPECT_FALSE(says(read("POM", "HDPE").notes, "material"));
}

}  // namespace
}  // namespace arenite::io
