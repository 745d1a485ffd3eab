#include "io/sample/sample.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "core/error.hpp"
#include "support/temporary_folder.hpp"

namespace arenite::io {
namespace {

/// Two files in a folder of their own, and what reading them says.
class Files {
 public:
  Files(const std::string& grains, const std::string& contacts) {
    std::ofstream(grains_) << grains;
    std::ofstream(contacts_) << contacts;
  }
  Sample read(const SampleOptions& options = {}) const { return read_sample(grains_, contacts_, options); }
  /// All problems as "name:line: message", one a line; empty if there are none.
  std::string problems(const SampleOptions& options = {}) const {
    try {
      read(options);
    } catch (const InputError& error) {
      std::string text;
      for (Problem p : error.problems()) {
        p.file = std::filesystem::path(p.file).filename().string();
        text += to_string(p) + "\n";
      }
      return text;
    }
    return {};
  }
  std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }

 private:
  test::TemporaryFolder folder_;
  std::filesystem::path grains_ = folder_ / "grains.csv", contacts_ = folder_ / "contacts.csv";
};

const std::string two_grains = "id,x,y,radius\n7,0,0,1\n9,1.9,0,1\n";

void expect_part(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "\"" << part << "\" is not in:\n" << text;
}

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
  o.box = Vec2{10, 10};
  o.tilt = 2;
  o.periodic[0] = o.periodic[1] = true;
  // Grain 2 is above the cell's middle; its image below is shifted by -tilt: (3.4 - 2, 9.6 - 10) = (1.4, -0.4).
  const Sample s = Files("id,x,y,radius\n1,1,0.2,0.5\n2,3.4,9.6,0.5\n", "i,j,fn,ft\n1,2,1,0\n").read(o);
  EXPECT_NEAR(s.packing.contacts.normal[0].x, -0.4 / std::hypot(0.4, 0.6), 1e-12);
  EXPECT_NEAR(s.packing.contacts.normal[0].y, 0.6 / std::hypot(0.4, 0.6), 1e-12);
  EXPECT_NEAR(s.packing.contacts.arm_i[0] + s.packing.contacts.arm_j[0], std::hypot(0.4, 0.6), 1e-12);
}

TEST(SampleCsv, RefusesAGrainOutsideTheBoxAndAContactOfFarGrains) {
  SampleOptions o;
  o.box = Vec2{2, 2};
  o.origin = Vec2{0, 0};
  expect_part(Files("id,x,y,radius\n1,1,1,0.5\n2,5,1,0.5\n", "i,j,fn,ft\n").problems(o),
              "grains.csv:3: grain 2 lies outside the box");
  expect_part(Files("id,x,y,radius\n1,1,1,0.5\n2,5,1,0.5\n", "i,j,fn,ft\n1,2,1,0\n").problems(),
              "4 times the sum of their radii apart");
}

TEST(SampleCsv, NamesWallsByTheirSide) {
  SampleOptions o;
  o.box = Vec2{4, 4};
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

const std::string mercury_data =
    "1 0 0 0 4 2\n9 9 0 0 9 0 0 0\n"  // an earlier time step
    "3 0.5 0 0 4 2\n1 1 0 0 1 0 0 0\n2.9 1 0 0 1 0 0 0\n1 1.8 0 0 0.1 0 0 1\n";
const std::string mercury_fstat =
    "# 0.5 0\n# 0 0 0 4 2 0\n# 1 1 0 0 0 0\n"
    "0.5 0 1 1.95 1 0 0.1 0 10 3 -1 0 0 0 1 0\n"  // force on 0: (-10, 3)
    "0.5 1 0 1.95 1 0 0.1 0 10 3 1 0 0 0 -1 0\n"  // the same contact, for grain 1
    "0.5 0 -1 0 1 0 0 0 7 1 -1 0 0 0 -1 0\n";     // left wall: MercuryDPM turns n and t round, force on 0: (7, 1)

TEST(SampleMercury, ReadsTheLastStepContactsOnceAndWalls) {
  const Sample s = Files(mercury_data, mercury_fstat).read();
  const Packing& p = s.packing;
  ASSERT_EQ(p.grains.size(), 3u);
  ASSERT_EQ(p.contacts.size(), 2u);
  EXPECT_EQ(s.doubled_rows, 0u);  // the format lists both ways
  EXPECT_NEAR(p.contacts.force_on_i(0).x, -10, 1e-12);
  EXPECT_NEAR(p.contacts.force_on_i(0).y, 3, 1e-12);
  EXPECT_EQ(p.contacts.wall_side(1), left);
  EXPECT_NEAR(p.contacts.force_on_i(1).x, 7, 1e-12);
  EXPECT_NEAR(p.contacts.force_on_i(1).y, 1, 1e-12);
  EXPECT_EQ(p.domain.width(), 4);
  EXPECT_EQ(p.materials.size(), 2u);
}

TEST(SampleMercury, SaysWhereAFileIsCutOff) {
  expect_part(Files("3 0.5 0 0 4 2\n1 1 0 0 1 0 0 0\n", mercury_fstat).problems(),
              "grains.csv:1: 3 grains are announced, but 1 follow");
}

TEST(SampleLammps, SaysWhereAFileIsCutOffOrLacksAColumn) {
  const std::string start = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp pp\n0 4\n0 4\n-1 1\n";
  const std::string pairs =
      "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ENTRIES\n0\nITEM: ENTRIES index c_p[1] c_p[2] c_f[1] c_f[2] c_f[3] c_f[4]\n";
  expect_part(Files(start + "ITEM: ATOMS id type x y radius\n1 1 0 0 1\n", pairs).problems(),
              "grains.csv:9: the dump announces 2 rows, but 1 follow");
  expect_part(Files(start + "ITEM: ATOMS id type x y\n1 1 0 0\n2 1 1 1\n", pairs).problems(),
              "there is no column \"radius\"; dump id type x y radius");
}

const std::string lammps_atoms =
    "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff ff pp\n0 4\n0 4\n-1 1\nITEM: ATOMS id type x y "
    "radius\n1 1 1 1 0.5\n2 1 1.9 1 0.5\n";
std::string lammps_pairs(const std::string& columns, const std::string& row) {
  return "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ENTRIES\n1\nITEM: ENTRIES " + columns + "\n" + row + "\n";
}

TEST(SampleLammps, FindsColumnsByWhatTheyHold) {
  const auto forces = [](const std::string& columns, const std::string& row) {
    const Contacts contacts = Files(lammps_atoms, lammps_pairs(columns, row)).read().packing.contacts;
    return std::pair(contacts.fn.at(0), contacts.ft.at(0));
  };
  const std::pair expected(3.0, 1.0);
  EXPECT_EQ(forces("index c_pl[1] c_pl[2] c_ff[1] c_ff[2] c_ff[3] c_ff[4] c_ff[5]", "1 1 2 -3 0 0 -1 0.9"),
            expected);  // one more at the end
  EXPECT_EQ(forces("c_pl[1] c_pl[2] c_ff[1] c_ff[2] c_ff[3] c_ff[4] c_ff[5] c_ff[6]", "1 2 0.9 3 -3 0 0 -1"),
            expected);  // dist force fx fy p1 p2
  EXPECT_EQ(forces("c_pl[1] c_pl[2] c_f[1] c_f[2] c_f[3] c_f[4] c_f[5] c_f[6] c_f[7]", "1 2 -0.9 0 -3 0 0 0 -1"),
            expected);  // dx dy fx fy fz p1 p2
  EXPECT_EQ(forces("c_f[1] c_f[2] c_f[3] c_f[4] c_pl[1] c_pl[2] c_f[5] c_f[6] c_f[7]", "0.9 3 -3 0 1 2 0 -1 0"),
            expected);  // grains behind
}

TEST(SampleLammps, ColumnsThatNobodyCanTellApartAreOneProblemWithWhatToWrite) {
  const Files files(lammps_atoms, lammps_pairs("index c_pl[1] c_pl[2] c_ff[1] c_ff[2] c_ff[3] c_ff[4] c_ff[5]",
                                               "1 1 2 -3 -3 0 -1 0.9"));
  const std::string text = files.problems();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
  expect_part(text,
              "contacts.csv:5: it is not known which of the columns (index c_pl[1] c_pl[2] c_ff[1] c_ff[2] c_ff[3] "
              "c_ff[4] c_ff[5])");
  expect_part(text, "--columns \"-,patom1,patom2,fx,fy,p1,p2,-\"");
  SampleOptions named;
  named.contact_columns = "-,patom1,patom2,fx,fy,p1,p2,-";
  EXPECT_DOUBLE_EQ(files.read(named).packing.contacts.fn.at(0), 3);
  EXPECT_DOUBLE_EQ(files.read(named).packing.contacts.ft.at(0), 4);
}

TEST(SampleLammps, TakesTheWholeForceWhereTheUserNamesItAlone) {
  const Files files(lammps_atoms, lammps_pairs("c_1[1] c_1[2] c_2[1] c_2[2]", "1 2 -3 -1"));
  expect_part(files.problems(), "name them in their order with --columns");
  SampleOptions named;
  named.contact_columns = "i,j,fx,fy";
  EXPECT_DOUBLE_EQ(files.read(named).packing.contacts.fn.at(0), 3);
  EXPECT_DOUBLE_EQ(files.read(named).packing.contacts.ft.at(0), 1);
}

std::string atoms_of(const std::string& box, const std::string& columns, const std::string& rows,
                     const std::string& before = "") {
  return before + "ITEM: TIMESTEP\n0\nITEM: BOX BOUNDS " + box + "\nITEM: ATOMS " + columns + "\n" + rows;
}

TEST(SampleLammps, BoundsOfATiltedBoxEncloseItAlongYToo) {
  // xy = 1, xz = -0.5, yz = 0.25: bounds along x from -0.5 to 11, along y from 0 to 8.25.
  const Packing p = Files(atoms_of("xy xz yz pp pp pp\n-0.5 11 1\n0 8.25 -0.5\n-1 1 0.25", "id x y z radius",
                                   "1 1 1 0 0.5\n2 5 5 0 0.5\n"),
                          "i,j,fn,ft\n")
                        .read()
                        .packing;
  EXPECT_DOUBLE_EQ(p.domain.width(), 10);
  EXPECT_DOUBLE_EQ(p.domain.height(), 8);
  EXPECT_DOUBLE_EQ(p.domain.tilt, 1);
}

TEST(SampleLammps, FractionsOfTheBoxAreCountedAlongItsEdges) {
  const Packing p =
      Files(atoms_of("abc origin pp pp pp\n10 0 0 1\n2 8 0 -1\n0 0 2 0", "id xs ys zs radius", "1 0.5 0.25 0.5 0.5\n"),
            "i,j,fn,ft\n")
          .read()
          .packing;
  EXPECT_DOUBLE_EQ(p.grains.position[0].x, 1 + 5 + 0.5);
  EXPECT_DOUBLE_EQ(p.grains.position[0].y, -1 + 2);
  EXPECT_DOUBLE_EQ(p.domain.tilt, 2);
}

TEST(SampleLammps, ACellThatIsTurnedIsRefused) {
  expect_part(Files(atoms_of("abc origin pp pp pp\n8 6 0 0\n-6 8 0 0\n0 0 2 0", "id x y z radius", "1 1 1 0 0.5\n"), "")
                  .problems(),
              "the vectors of the cell, (8 6 0) and (-6 8 0) m, do not lie along x");
}

TEST(SampleLammps, ForcesOfALayerInXzAreThoseAlongXAndZ) {
  const std::string atoms =
      atoms_of("ff ff ff\n0 4\n0 4\n0 4", "id type x y z radius", "1 1 1 1 1 0.5\n2 1 1.9 1 1 0.5\n3 1 1 1 1.9 0.5\n");
  for (const char* columns :
       {"patom1 patom2 fx fy fz p1 p2 p3", "c_p[1] c_p[2] c_f[1] c_f[2] c_f[3] c_f[4] c_f[5] c_f[6]"}) {
    const std::string rows = "1 2 -3 0 0 0 0 -1\n1 3 0 0 -5 2 0 0";
    const Contacts c = Files(atoms, "ITEM: TIMESTEP\n0\nITEM: ENTRIES " + std::string(columns) + "\n" + rows + "\n")
                           .read()
                           .packing.contacts;
    ASSERT_EQ(c.size(), 2u);
    EXPECT_DOUBLE_EQ(c.fn[0], 3);
    EXPECT_DOUBLE_EQ(c.fn[1], 5);
    EXPECT_NEAR(norm(c.force_on_i(0) - Vec2{-3, -1}), 0, 1e-12);
    EXPECT_NEAR(norm(c.force_on_i(1) - Vec2{2, -5}), 0, 1e-12);
  }
}

TEST(SampleLammps, UnitsOfTheTwoDumpsAreTheSameAndKnown) {
  const std::string box = "ff ff ff\n0 4\n0 4\n-1 1", columns = "id x y radius", rows = "1 1 1 0.5\n2 1.9 1 0.5\n";
  const auto pairs = [](const std::string& units) {
    return "ITEM: UNITS\n" + units + "\n" + lammps_pairs("patom1 patom2 fx fy p1 p2", "1 2 -3 0 0 0");
  };
  const Files micro(atoms_of(box, columns, rows, "ITEM: UNITS\nmicro\nITEM: TIME\n0.5\n"), pairs("micro"));
  EXPECT_DOUBLE_EQ(micro.read().packing.grains.radius[0], 0.5e-6);
  EXPECT_DOUBLE_EQ(micro.read().packing.contacts.fn[0], 3e-9);  // pg um / us^2
  expect_part(Files(atoms_of(box, columns, rows, "ITEM: UNITS\nmicro\n"), pairs("si")).problems(),
              "the contacts are in units si, the grains in units micro");
  expect_part(Files(atoms_of(box, columns, rows, "ITEM: UNITS\nfurlong\n"), pairs("si")).problems(),
              "units \"furlong\", which are not known");
}

TEST(SampleLammps, AnotherBoxOfTheContactsIsTold) {
  const std::string pairs =
      "ITEM: TIMESTEP\n0\nITEM: BOX BOUNDS pp pp pp\n0 5\n0 4\n-1 1\nITEM: ENTRIES patom1 patom2 fx fy p1 p2\n1 2 -3 0 "
      "0 0\n";
  const auto notes = Files(lammps_atoms, pairs).read().notes;
  EXPECT_TRUE(
      std::ranges::any_of(notes, [](const auto& note) { return note.find("another box (5 x 4") != note.npos; }));
}

TEST(SampleMercury, GrainsAndContactsAreOfTheLastCommonTime) {
  const Sample s =
      Files(mercury_data + "3 0.75 0 0 4 2\n1 1 0 0 1 0 0 0\n3.5 1 0 0 1 0 0 0\n1 1.8 0 0 0.1 0 0 1\n", mercury_fstat)
          .read();
  EXPECT_DOUBLE_EQ(s.packing.grains.position[1].x, 2.9);
  expect_part(s.notes.at(0), "3 snapshots, of which that of time 0.5 was taken");
  expect_part(Files("1 7 0 0 4 2\n1 1 0 0 1 0 0 0\n", mercury_fstat).problems(),
              "the contacts are of time 0.5, the grains of time 7");
}

TEST(SampleMercury, ForcesWithoutAHeaderAreCutWhereTheirTimeChanges) {
  const std::string rows = "0.25 0 1 1.95 1 0 0.1 0 99 0 -1 0 0 0 1 0\n0.5 0 1 1.95 1 0 0.1 0 10 3 -1 0 0 0 1 0\n";
  const Contacts c = Files(mercury_data, rows).read().packing.contacts;
  ASSERT_EQ(c.size(), 1u);
  EXPECT_DOUBLE_EQ(c.fn[0], 10);
}

TEST(SampleMercury, ALayerInSpaceIsReadAndABedIsRefused) {
  const auto data = [](const std::string& z) {
    return "2 0.5 0 0 0 4 2 9\n1 1 3 0 0 0 1 0 0 0 0 0 0 0\n2.8 1.5 " + z + " 0 0 0 1 0 0 0 0 0 0 1\n";
  };
  const Sample s = Files(data("3.4"), mercury_fstat.substr(0, mercury_fstat.rfind("0.5 0 -1"))).read();
  EXPECT_EQ(s.packing.contacts.size(), 1u);
  EXPECT_EQ(s.packing.materials.size(), 2u);
  EXPECT_TRUE(std::ranges::any_of(
      s.notes, [](const auto& note) { return note.find("differ by 0.4 mean radii along z") != note.npos; }));
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
