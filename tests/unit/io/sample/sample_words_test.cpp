#include <gtest/gtest.h>

#include <numbers>

#include "io/sample/placed_grains.hpp"
#include "unit/io/sample/sample_files.hpp"

// What a file says of its cell, its columns and its forces is used, or refused, or told.
namespace arenite::io {
namespace {

std::string frame_of_xyz(const std::string& pbc) {
  return "2\nLattice=\"4 0 0 0 4 0 0 0 4\" " + pbc +
         " Properties=species:S:1:pos:R:3:radius:R:1\nA 1 1 0 0.6\nA 3.5 1 0 0.6\n";
}

TEST(SampleXyz, PeriodicSidesAreReadAsProgramsWriteThem) {
  using Sides = std::array<bool, 2>;
  const auto sides = [](const std::string& pbc) -> Sides {
    const auto domain = Files(frame_of_xyz(pbc), "").any();
    return std::visit(
        [](const auto& s) {
          return Sides{s.packing.domain.periodic[0], s.packing.domain.periodic[1]};
        },
        domain);
  };
  for (const char* all : {"pbc=\"T T F\"", "pbc=[T, T, F]", "pbc='T T F'", "pbc={T T F}", "pbc=\"true true false\"",
                          "pbc=\"1 1 0\"", "pbc=\"yes yes no\"", "pbc = \"T T F\"", "pbc=T", ""})
    EXPECT_EQ(sides(all), (Sides{true, true})) << all;
  EXPECT_EQ(sides("pbc=\"F T F\""), (Sides{false, true}));
  EXPECT_EQ(sides("pbc=F"), (Sides{false, false}));
  for (const char* other : {"pbc=TTF", "pbc=\"p p f\"", "pbc=\"T T\"", "pbc=garbage"})
    expect_part(Files(frame_of_xyz(other), "").problems(), "which is not understood; write three of T and F");
}

TEST(SampleYade, ColumnsAreThoseThatTheFormatLineNames) {
  const auto grains = [](const std::string& text) { return std::get<Sample>(Files(text, "").any()).packing.grains; };
  EXPECT_DOUBLE_EQ(grains("#format x_y_r_z_matId\n1 2 0.5 0 7\n4 2 0.5 0 7\n").radius.at(1), 0.5);
  EXPECT_EQ(grains("#format id_x_y_z_r_matId\n9 1 2 0 0.5 7\n").id.at(0), 9);
  EXPECT_DOUBLE_EQ(grains("#format x_y_z_r_attrs\n1 2 0 0.5 a b\n").radius.at(0), 0.5);
  expect_part(Files("#format x_y_z_d\n1 2 0 0.5\n", "").problems(),
              "grains.csv:1: the #format line is x_y_z_d and names no r");
}

TEST(SampleYade, APeriodicPackHasItsCell) {
  const std::string pack = "##PERIODIC:: 4 4 4\n1 1 1 0.6\n3.5 1 1 0.6\n1 3 3 0.6\n";
  const auto s = Files(pack, "").spheres();
  EXPECT_EQ(s.packing.domain.periodic, (std::array<bool, 3>{true, true, true}));
  EXPECT_DOUBLE_EQ(s.packing.domain.extent(2), 4);
  EXPECT_EQ(s.packing.grains.size(), 3u);
  expect_part(Files("##PERIODIC:: 4 4\n1 1 1 0.6\n", "").problems(), "has 2 lengths instead of 3");
}

const std::string pair = "id,x,y,radius\n1,0.5,1,0.5\n2,3.5,1,0.5\n", across = "i,j,fn,ft,nx,ny\n1,2,5,0,-1,0\n";

TEST(SampleContacts, ANormalDoesNotJoinGrainsThroughTheWallsOfABox) {
  SampleOptions o;
  EXPECT_EQ(Files(pair, across).read(o).packing.contacts.size(), 1u) << "where no box is known it may be periodic";
  o.box = {4, 4};
  expect_part(Files(pair, across).problems(o),
              "contacts.csv:2: grains 1 and 2 are 3 times the sum of their radii apart");
  o.periodic = {true, true, false};
  EXPECT_EQ(Files(pair, across).read(o).packing.contacts.size(), 1u);
}

TEST(SampleContacts, ForcesAcrossThePlaneAreTold) {
  const std::string grains = "id,x,y,radius\n1,1,1,0.5\n2,2,1,0.5\n";
  const auto notes = [&](const std::string& contacts) { return Files(grains, contacts).read().notes; };
  EXPECT_TRUE(says(notes("i,j,fx,fy,fz\n1,2,10,0,5\n"), "parts across the plane of the grains, 0.5 times"));
  EXPECT_FALSE(says(notes("i,j,fx,fy,fz\n1,2,10,0,0\n"), "across the plane"));
}

TEST(SampleContacts, ForcesThatContradictEachOtherAreRefusedAndMissingOnesTold) {
  const std::string grains = "id,x,y,radius\n1,1,1,0.5\n2,2,1,0.5\n";
  expect_part(Files(grains, "i,j,fn,ft,fx,fy\n1,2,5,0,5,0\n1,2,7,1,3,0\n").problems(),
              "contacts.csv:3: fx, fy and fn, ft contradict each other");
  EXPECT_EQ(Files(grains, "i,j,fn,ft,fx,fy\n1,2,3,4,4,3\n").problems(), "");
  EXPECT_TRUE(says(Files(grains, "i,j,fn\n1,2,5\n").read().notes, "no column ft, so they were taken as frictionless"));
  EXPECT_FALSE(says(Files(grains, "i,j,fn,ft\n1,2,5,0\n").read().notes, "frictionless"));
}

TEST(SampleGrains, ALegacyVtkFileIsRefusedInOneSentence) {
  const std::string problems = Files("# vtk DataFile Version 2.0\ngrains\nASCII\nDATASET POLYDATA\n", "").problems();
  expect_part(problems, "legacy VTK file");
  EXPECT_EQ(problems.find("grains.csv"), problems.rfind("grains.csv")) << problems;
}

TEST(SampleLammps, WithoutATypeTheElementIsTheMaterial) {
  const std::string dump =
      "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff ff pp\n0 4\n0 4\n-1 1\n"
      "ITEM: ATOMS id element x y radius\n1 POM 1 1 0.5\n2 HDPE 3 1 0.5\n";
  const Sample s = std::get<Sample>(Files(dump, "").any());
  ASSERT_EQ(s.packing.materials.size(), 2u);
  EXPECT_EQ(s.packing.materials[static_cast<std::size_t>(s.packing.grains.material[0])].name, "POM");
}

/// Of several moments in a table a recipe takes the last, as `measure` does.
TEST(PlacedGrains, AreOfTheLastMomentAndTellWhatWasTaken) {
  const Files files("time,id,x,y,radius,material\n0,1,1,1,0.5,POM\n1,1,2,1,0.5,POM\n", "");
  Domain frame;
  frame.wall[right].position = frame.wall[top].position = 4;
  std::vector<std::string> notes;
  const Grains grains = read_placed_grains(files / "grains.csv", {{"POM", 1410, 1e6, 0}}, frame, notes);
  ASSERT_EQ(grains.size(), 1u);
  EXPECT_DOUBLE_EQ(grains.position[0].x, 2);
  EXPECT_TRUE(says(notes, "time 1 was taken"));
  EXPECT_TRUE(says(notes, "states no unit of length, so m was assumed; a header such as"));
  EXPECT_FALSE(says(notes, "--"));
  const Files dump(lammps_atoms, "");
  EXPECT_THROW(read_placed_grains(dump / "grains.csv", {{"POM", 1410, 1e6, 0}}, frame, notes), InputError);
}

}  // namespace
}  // namespace arenite::io
