#include "io/sample/sample.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "core/error.hpp"
#include "unit/io/sample/sample_files.hpp"

namespace arenite::io {
namespace {

const std::string two_grains = "id,x,y,radius\n7,0,0,1\n9,1.9,0,1\n";

TEST(SampleCsv, TurnsTheFilesForceOnJIntoTheModelsForceOnI) {
  const Sample s = Files(two_grains, "i,j,fn,ft\n7,9,10,2\n").read();
  const Contacts& c = s.packing.contacts;
  ASSERT_EQ(c.size(), 1u);
  // n from i to j is +x, t is +y: the force on grain 9 is (10, 2), on grain 7 (-10, -2).
  EXPECT_DOUBLE_EQ(c.force_on_i(0).x, -10);
  EXPECT_DOUBLE_EQ(c.force_on_i(0).y, -2);
  EXPECT_DOUBLE_EQ(c.normal[0].x, -1);
  EXPECT_DOUBLE_EQ(c.arm_i[0], 0.95);  // the point halves the overlap
  EXPECT_EQ(s.packing.grains.id[1], 9);
}

TEST(SampleCsv, ReadsUnitsFromTheHeaderARowOfUnitsOrOptions) {
  const auto radius = [](const std::string& grains, const SampleOptions& o = {}) {
    return Files(grains, "i,j,fn,ft\n").read(o).packing.grains.radius.at(0);
  };
  SampleOptions millimetres;
  millimetres.length_unit = 1e-3;
  EXPECT_DOUBLE_EQ(radius("id,x [mm],y [mm],radius [mm]\n1,0,0,16.4\n"), 0.0164);
  EXPECT_DOUBLE_EQ(radius("id; x (mm); y (mm); radius (mm)\n1; 0; 0; 16.4\n"), 0.0164);
  EXPECT_DOUBLE_EQ(radius("id,x,y,radius\n-,mm,mm,mm\n1,0,0,16.4\n"), 0.0164);
  EXPECT_DOUBLE_EQ(radius("id x y radius\n1 0 0 16.4\n", millimetres), 0.0164);
  EXPECT_DOUBLE_EQ(radius("id,x,y,diameter [cm]\n1,0,0,3.28\n"), 0.0164);
  EXPECT_DOUBLE_EQ(radius("# a comment\n\nid,x,y,radius [mm]\r\n1,0,0,16.4\r\n", millimetres), 0.0164);
}

TEST(SampleCsv, DoesNotTakeARowOfOnesForUnits) {
  EXPECT_EQ(Files("id,x,y,radius\n1,1,1,1\n", "i,j,fn,ft\n").read().packing.grains.size(), 1u);
}

TEST(SampleCsv, ReadsQuotedCellsAndZones) {
  const Packing p =
      Files("id,x,y,radius,material,zone\n1,0,0,1,\"POM, black\",1\n2,3,0,1,HDPE,0\n", "i,j,fn,ft\n").read().packing;
  EXPECT_EQ(p.materials.at(0).name, "POM, black");
  EXPECT_EQ(p.grains.zone[0], 1);
  EXPECT_EQ(p.grains.zone[1], 0);
}

TEST(SampleCsv, SaysWhereItAssumedAUnit) {
  const Sample assumed = Files(two_grains, "i,j,fn [kN],ft [kN]\n7,9,10,2\n").read();
  ASSERT_EQ(assumed.notes.size(), 1u);
  expect_part(assumed.notes[0], "--length-unit");
  EXPECT_DOUBLE_EQ(assumed.packing.contacts.fn[0], 1e4);
}

TEST(SampleCsv, ReportsEveryProblemOfBothFilesInOnePassWithItsLine) {
  const std::string text = Files("id,x,y,radius\n1,0,0,1\n2,1.9,zero,1\n", "i,j,fn,ft\n1,2,nan,0\n1,2\n").problems();
  expect_part(text, "grains.csv:3: y is \"zero\", which is not a finite number");
  const std::string checked =
      Files("id,x,y,radius\n1,0,0,-3\n2,1.9,0,1\n2,3.8,0,1\n", "i,j,fn,ft\n1,2,5,0\n2,1,5,0\n1,44,5,0\n1,1,5,0\n")
          .problems();
  expect_part(checked, "grains.csv:2: the radius of grain 1 is -3 m; a radius must be positive");
  expect_part(checked, "grains.csv:4: grain 2 appears twice");
  expect_part(checked, "contacts.csv:3: the contact of 2 and 1 is already in line 2");
  expect_part(checked, "contacts.csv:4: this contact names grain 44, which is not among the grains");
  expect_part(checked, "contacts.csv:5: grain 1 cannot touch itself");
}

TEST(SampleCsv, RefusesWhatIsNoTable) {
  expect_part(Files("", "i,j,fn,ft\n").problems(), "grains.csv: the file is empty");
  expect_part(Files("id,x,y,radius\n", "i,j,fn,ft\n").problems(), "there are no grains");
  expect_part(Files("1,0,0,1\n2,0,0,1\n", "i,j,fn,ft\n").problems(),
              "grains.csv:1: the first row must name the columns");
  expect_part(Files("id,x,y\n1,0,0\n", "i,j,fn,ft\n").problems(), "there is no column \"radius\"");
  expect_part(Files(two_grains, "i,j,fn,ft\n7,9,1\n").problems(),
              "contacts.csv:2: this row has 3 cells, but there are 4 columns");
  expect_part(Files("id,x [kN],y,radius\n1,0,0,1\n", "i,j,fn,ft\n").problems(), "\"kN\" is not a length");
  expect_part(Files("# from the laboratory\nid,x [kN],y,radius\n1,0,0,1\n", "i,j,fn,ft\n").problems(),
              "grains.csv:2: column x");
  expect_part(Files("id,x [mn],y,radius\n1,0,0,1\n", "i,j,fn,ft\n").problems(), "mn");
}

TEST(SampleCsv, CountsProblemsBeyondTwenty) {
  std::string grains = "id,x,y,radius\n";
  for (int k = 0; k < 50; ++k) grains += std::to_string(k) + ",0,inf,1\n";
  const std::string text = Files(grains, "i,j,fn,ft\n").problems();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 21);
  expect_part(text, "and 30 more problems");
}

TEST(SampleCsv, MergesRowsThatRepeatAContactOnlyWhenAsked) {
  SampleOptions merge;
  merge.merge_doubled = true;
  const Sample s = Files(two_grains, "i,j,fn,ft\n7,9,10,2\n9,7,12,4\n").read(merge);
  EXPECT_EQ(s.doubled_rows, 1u);
  ASSERT_EQ(s.packing.contacts.size(), 1u);
  EXPECT_DOUBLE_EQ(s.packing.contacts.fn[0], 11);  // fn and ft keep their signs when i and j change places
  EXPECT_DOUBLE_EQ(s.packing.contacts.ft[0], 3);
}

TEST(SampleCsv, JoinsGrainsAcrossPeriodicSidesWithTilt) {
  SampleOptions o;
  o.box = {10, 10, 2};
  o.periodic[0] = o.periodic[1] = true;
  // Grain 2 is above the cell's middle; its image below is shifted by -tilt: (3.4 - 2, 9.6 - 10) = (1.4, -0.4).
  const Sample s = Files("id,x,y,radius\n1,1,0.2,0.5\n2,3.4,9.6,0.5\n", "i,j,fn,ft\n1,2,1,0\n").read(o);
  EXPECT_NEAR(s.packing.contacts.normal[0].x, -0.4 / std::hypot(0.4, 0.6), 1e-12);
  EXPECT_NEAR(s.packing.contacts.normal[0].y, 0.6 / std::hypot(0.4, 0.6), 1e-12);
  EXPECT_NEAR(s.packing.contacts.arm_i[0] + s.packing.contacts.arm_j[0], std::hypot(0.4, 0.6), 1e-12);
}

TEST(SampleCsv, RefusesAGrainOutsideTheBoxAndAContactOfFarGrains) {
  SampleOptions o;
  o.box = {2, 2};
  o.origin = {0, 0};
  expect_part(Files("id,x,y,radius\n1,1,1,0.5\n2,5,1,0.5\n", "i,j,fn,ft\n").problems(o),
              "grains.csv:3: grain 2 lies outside the box");
  expect_part(Files("id,x,y,radius\n1,1,1,0.5\n2,5,1,0.5\n", "i,j,fn,ft\n1,2,1,0\n").problems(),
              "4 times the sum of their radii apart");
}

TEST(SampleCsv, NamesWallsByTheirSide) {
  SampleOptions o;
  o.box = {4, 4};
  const Sample s = Files("id,x,y,radius\n1,1,0.9,1\n", "i,j,fn,ft\n1,bottom,10,1\n").read(o);
  EXPECT_TRUE(s.packing.contacts.is_wall(0));
  EXPECT_EQ(s.packing.contacts.wall_side(0), bottom);
  EXPECT_DOUBLE_EQ(s.packing.contacts.force_on_i(0).y, 10);  // the wall pushes up
  EXPECT_DOUBLE_EQ(s.packing.contacts.arm_i[0], 0.9);
}

TEST(SampleCsv, TakesMaterialsFromATableInItsOrder) {
  const Files files("id,x,y,radius,material\n1,0,0,1,HDPE\n2,3,0,1,POM\n", "i,j,fn,ft\n");
  std::ofstream(files / "materials.csv")
      << "material,density [kg/m^3],stiffness [kN/mm]\nPOM,1410,27.35\nHDPE,950,6.43\n";
  SampleOptions o;
  o.materials = files / "materials.csv";
  const Packing p = files.read(o).packing;
  EXPECT_EQ(p.materials.at(0).name, "POM");
  EXPECT_DOUBLE_EQ(p.materials.at(0).stiffness, 27.35e6);
  EXPECT_EQ(p.grains.material[0], 1);
  std::ofstream(files / "materials.csv") << "material\nPOM\nHDPF\n";
  expect_part(files.problems(o), "did you mean \"HDPF\"?");
}

TEST(SampleCsv, RowsOfTheLastCommonStepAreTaken) {
  const std::string grains = "step,id,x,y,radius\n1,7,0,0,1\n1,9,1.9,0,1\n2,7,0,0,1\n2,9,1.8,0,1\n";
  const Sample s = Files(grains, "step,i,j,fn,ft\n1,7,9,10,2\n").read();
  EXPECT_DOUBLE_EQ(s.packing.grains.position[1].x, 1.9);
  EXPECT_EQ(Files(grains, "i,j,fn,ft\n7,9,10,2\n").read().packing.grains.position[1].x,
            1.8);  // the contacts state none: the last
  expect_part(Files(grains, "step,i,j,fn,ft\n3,7,9,10,2\n").problems(),
              "the contacts are of step 3, the grains of step 2");
  // Times at which grains were born are no snapshots.
  EXPECT_EQ(
      Files("time,id,x,y,radius\n0.1,7,0,0,1\n0.2,9,1.9,0,1\n", "i,j,fn,ft\n7,9,10,2\n").read().packing.grains.size(),
      2u);
}

TEST(SampleCsv, MomentsThatCannotBeComparedAreToldAndOthersRefused) {
  const std::string by_step = "id,x,y,radius,step\n7,0,0,1,4\n9,1.9,0,1,4\n",
                    by_time = "id,x,y,radius,time\n7,0,0,1,4\n9,1.9,0,1,4\n";
  const auto notes = [](const std::string& grains, const std::string& contacts) {
    return Files(grains, contacts).read().notes;
  };
  const std::string at_time = "i,j,fn,ft,time\n7,9,10,2,", at_step = "i,j,fn,ft,step\n7,9,10,2,4\n";
  EXPECT_TRUE(says(notes(by_step, at_time + "4\n"), "The grains are of step 4, the contacts of time 4: that they"));
  EXPECT_TRUE(says(notes(by_time, at_step), "The grains are of time 4, the contacts of step 4"));
  EXPECT_TRUE(says(notes(by_step, "i,j,fn,ft\n7,9,10,2\n"), "the contacts of a moment that is not stated"));
  EXPECT_TRUE(says(notes(two_grains, at_step), "The grains are of a moment that is not stated"));
  for (const auto& [grains, contacts] :
       {std::pair(two_grains, std::string("i,j,fn,ft\n7,9,10,2\n")), {by_step, at_step}, {by_time, at_time + "4\n"}})
    EXPECT_FALSE(says(notes(grains, contacts), "of one moment")) << grains;
  expect_part(Files(by_time, at_time + "3\n").problems(), "the contacts are of time 3, the grains of time 4");
}

TEST(SampleVtk, ItsTimeIsThatOfItsGrains) {
  const auto points = [](const char* fields) {
    return std::string("<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\"><PolyData><FieldData>") + fields +
           "</FieldData><Piece NumberOfPoints=\"2\"><PointData><DataArray Name=\"radius\" format=\"ascii\">1 1"
           "</DataArray></PointData><Points><DataArray NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1.9 0 0"
           "</DataArray></Points></Piece></PolyData></VTKFile>";
  };
  const std::string time = points("<DataArray Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">2</DataArray>"),
                    cycle = points("<DataArray Name=\"CYCLE\" NumberOfTuples=\"1\" format=\"ascii\">7</DataArray>");
  expect_part(Files(time, "i,j,fn,ft,time\n0,1,10,2,1\n").problems(),
              "the contacts are of time 1, the grains of time 2");
  EXPECT_FALSE(says(Files(time, "i,j,fn,ft,time\n0,1,10,2,2\n").read().notes, "of one moment"));
  expect_part(Files(cycle, "i,j,fn,ft,step\n0,1,10,2,6\n").problems(), "the grains of step 7");
  EXPECT_TRUE(says(Files(cycle, "i,j,fn,ft\n0,1,10,2\n").read().notes, "The grains are of step 7"));
}

TEST(SampleCsv, WhatRoundingLeavesOfAForceOverAGapIsNoContact) {
  const std::string grains = "id,x,y,radius\n1,0,0,1\n2,1.9,0,1\n3,-2.1,0,1\n4,0,2.1,1\n";
  const Sample s = Files(grains, "i,j,fn,ft\n1,2,10,0\n1,3,1e-18,0\n1,4,0,-1e-20\n").read();
  EXPECT_EQ(s.packing.contacts.size(), 1u);
  EXPECT_TRUE(says(s.notes, "2 of 3 listed pairs have a gap"));
  EXPECT_EQ(Files(grains, "i,j,fn,ft\n1,2,10,0\n1,3,1e-7,0\n").read().packing.contacts.size(), 2u);  // cohesion, say
  EXPECT_EQ(Files(grains, "i,j,fn,ft\n1,2,1e-18,0\n1,3,1e-18,0\n").read().packing.contacts.size(), 2u);  // all small
}

TEST(SampleCsv, ThePlaneIsThatInWhichTheCentresLie) {
  const auto read = [](const std::string& rows) {
    return Files("id,x,y,z,radius\n" + rows, "i,j,fx,fy,fz\n1,2,5,3,4\n");
  };
  EXPECT_DOUBLE_EQ(read("1,0,0,7,1\n2,1.9,0,7,1\n").read().packing.contacts.fn[0], 5);               // one of z
  EXPECT_DOUBLE_EQ(read("1,0,0,0,1\n2,0,1e-9,1.9,1\n").read().packing.contacts.fn[0], 4);            // x-z
  EXPECT_DOUBLE_EQ(read("1,0,0,0,1\n2,0,1.9,1.9,2\n").read().packing.contacts.force_on_i(0).x, -3);  // y-z
  expect_part(read("1,0,0,0,1\n2,2,2,2,1\n").problems(),
              "the centres fill space: they differ by 2 mean radii even along z");
}

TEST(SampleCsv, RowsWithoutAForceTouchWhereTheyOverlap) {
  const std::string grains = "id,x,y,radius\n1,0,0,1\n2,1.9,0,1\n3,-2.1,0,1\n4,0,5,1\n";
  const Sample s = Files(grains, "i,j,fn,ft\n1,2,0,0\n1,3,0,0\n1,4,0,0\n").read();
  ASSERT_EQ(s.packing.contacts.size(), 1u);
  EXPECT_EQ(s.packing.contacts.j[0], 1);
  EXPECT_TRUE(std::ranges::any_of(s.notes,
                                  [](const auto& note) { return note.starts_with("2 of 3 listed pairs have a gap"); }));
  // What the file says of the overlap counts more than the centres; a force across a gap is a contact.
  EXPECT_EQ(Files(grains, "i,j,fn,ft,overlap\n1,2,0,0,-0.01\n1,3,0,0,0.01\n").read().packing.contacts.j,
            std::vector<std::int32_t>{2});
  EXPECT_EQ(Files(grains, "i,j,fn,ft\n1,3,-1,0\n").read().packing.contacts.size(), 1u);
}

TEST(SampleCsv, AContactPointElsewhereIsRefused) {
  expect_part(Files(two_grains, "i,j,fn,ft,x,y\n7,9,10,2,950,0\n").problems(),
              "the contact point (950, 0) m does not lie at the rims of grains 7 and 9");
}

TEST(SampleFormats, ContactsMayBeAnotherProgramsThanTheGrains) {
  const std::string grains = "id,x,y,radius\n1,1,1,0.5\n2,1.9,1,0.5\n";
  EXPECT_DOUBLE_EQ(Files(grains, lammps_pairs("c_p[1] c_p[2] c_f[1] c_f[2] c_f[3] c_f[4]", "1 2 -3 0 0 -1"))
                       .read()
                       .packing.contacts.fn.at(0),
                   3);
  EXPECT_DOUBLE_EQ(Files(lammps_atoms, "i,j,fn,ft\n1,2,3,1\n").read().packing.contacts.fn.at(0), 3);
  SampleOptions named;
  named.contact_columns = "-,i,j,-,-,-,-,-,fn,ft,-,-,-,-,-,-";  // of numbers that look like MercuryDPM's
  EXPECT_DOUBLE_EQ(Files(grains, "0 1 2 0 0 0 0 0 3 1 0 0 0 0 0 0\n").read(named).packing.contacts.fn.at(0), 3);
}

TEST(SampleFormats, FilesWithoutARowAreRefusedWhateverTheFormat) {
  const std::string pairs = lammps_pairs("patom1 patom2 fx fy p1 p2", "1 2 -3 0 0 0");
  for (const char* grains :
       {"id,x,y,radius\n", "ITEM: TIMESTEP\n0\nITEM: BOX BOUNDS pp pp pp\n0 1\n0 1\n0 1\nITEM: ATOMS id x y radius\n",
        "#format x_y_z_r\n", "0 0 0 0 1 1\n", "0 0 0 0 0 1 1 1\n"})
    for (const std::string& contacts :
         {pairs, std::string("i,j,fn,ft\n1,2,3,1\n"), mercury_fstat,
          std::string("# vtk DataFile Version 3.0\nPOINTS 2 double\n0 0 0 1 0 0\nVECTORS normalForce double\n1 0 0\n"
                      "VECTORS shearForce double\n0 0 0\n")})
      EXPECT_FALSE(Files(grains, contacts).problems().empty()) << grains << contacts;
}

TEST(SampleFormats, ContactsWithoutARowAreNone) {
  EXPECT_EQ(
      Files(lammps_atoms,
            "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ENTRIES\n0\nITEM: ENTRIES c_p[1] c_p[2] c_f[1] c_f[2] c_f[3] c_f[4]\n")
          .read()
          .packing.contacts.size(),
      0u);
  EXPECT_EQ(Files(mercury_data, "# 0.5 0\n").read().packing.contacts.size(), 0u);
  EXPECT_EQ(Files(two_grains, "i,j,fn,ft\n").read().packing.contacts.size(), 0u);
}

TEST(SampleOptionsGiven, PeriodicSidesNeedTheCell) {
  SampleOptions o;
  o.periodic[0] = true;
  expect_part(Files(two_grains, "i,j,fn,ft\n").problems(o), "periodic sides need the size of the cell");
}

}  // namespace
}  // namespace arenite::io
