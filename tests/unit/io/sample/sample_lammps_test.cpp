#include "io/sample/sample.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/error.hpp"
#include "unit/io/sample/sample_files.hpp"

namespace arenite::io {
namespace {

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
              "there is no column \"radius\"; dump id type x y z radius");
}

TEST(SampleLammps, MoreRowsThanAreAnnouncedAreNotCutOff) {
  std::string atoms = lammps_atoms;
  atoms.replace(atoms.find("ATOMS\n2"), 7, "ATOMS\n1");
  const std::string told = Files(atoms, "i,j,fn,ft\n").problems();
  expect_part(told, "the dump announces 1 rows, but 2 follow; its number is not that of its rows, so write it again");
  EXPECT_EQ(told.find("cut off"), std::string::npos);
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
  std::string moved = pairs;
  moved.replace(moved.find("0 5\n"), 4, "1 5\n");  // as large as that of the grains, and elsewhere
  EXPECT_TRUE(says(Files(lammps_atoms, moved).read().notes,
                   "another box (4 x 4 x 2 m from (1, 0, -1)) than the grains' (4 x 4 x 2 m from (0, 0, -1))"));
}

TEST(SampleLammps, ReducedUnitsAreStatedAndHaveNoSize) {
  const std::string lj = "ITEM: UNITS\nlj\n", pairs = lammps_pairs("patom1 patom2 fx fy p1 p2", "1 2 -3 0 0 0");
  const Sample s = Files(lj + lammps_atoms, lj + pairs).read();
  EXPECT_TRUE(says(s.notes, "reduced units (lj), which have no size: m was taken for that of length; --length-unit"));
  EXPECT_TRUE(says(s.notes, "N was taken for that of force; --force-unit"));
  EXPECT_FALSE(says(s.notes, "states no unit"));
}

TEST(SampleLammps, UnitsThatOneOfTwoDumpsStatesAreThoseOfBoth) {
  const std::string cgs = "ITEM: UNITS\ncgs\n", pairs = lammps_pairs("patom1 patom2 fx fy p1 p2", "1 2 -3 0 0 0");
  for (const bool by_grains : {false, true}) {
    const Sample s = Files((by_grains ? cgs : "") + lammps_atoms, (by_grains ? "" : cgs) + pairs).read();
    EXPECT_DOUBLE_EQ(s.packing.grains.radius.at(0), 0.5e-2);
    EXPECT_DOUBLE_EQ(s.packing.domain.width(), 4e-2);
    EXPECT_DOUBLE_EQ(s.packing.contacts.fn.at(0), 3e-5);
    EXPECT_EQ(says(s.notes, "states no units; those of the contacts, cgs, are taken"), !by_grains);
    EXPECT_FALSE(says(s.notes, "--length-unit"));
  }
  expect_part(Files("ITEM: UNITS\nsi\n" + lammps_atoms, cgs + pairs).problems(),
              "the contacts are in units cgs, the grains in units si");
  SampleOptions metres;
  metres.length_unit = 1;
  expect_part(Files(lammps_atoms, cgs + pairs).problems(metres), "the units given are others");
}

TEST(SampleLammps, ColumnsTakenByWhatTheyHoldAreToldAndMayHaveTheTangentialForceFirst) {
  const std::string atoms =
      atoms_of("ff ff pp\n0 4\n0 4\n-1 1", "id x y radius", "1 1 1 0.5\n2 1.9 1 0.5\n3 1 1.9 0.5\n");
  const Sample s = Files(atoms,
                         "ITEM: TIMESTEP\n0\nITEM: ENTRIES c_1[1] c_1[2] c_2[1] c_2[2] c_2[3] c_2[4] c_2[5] c_2[6]\n"
                         "1 2 0 -1 0 -3 0 0\n1 3 1 0 0 0 -3 0\n")
                       .read();
  EXPECT_DOUBLE_EQ(s.packing.contacts.fn.at(0), 3);
  EXPECT_DOUBLE_EQ(s.packing.contacts.ft.at(0), 1);
  EXPECT_TRUE(
      says(s.notes, "c_1[1] as patom1, c_1[2] as patom2, c_2[4] as fx, c_2[5] as fy, c_2[1] as p1, c_2[2] as p2"));
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

TEST(SampleLammps, TheLastStepIsTheLargestWhereverItStands) {
  const auto at = [](int step, const std::string& x) {
    return atoms_of("ff ff pp\n0 4\n0 4\n-1 1", "id x y radius", "1 " + x + " 1 0.5\n")
        .replace(15, 1, std::to_string(step));
  };
  const Sample s = Files(at(300, "3") + at(100, "1") + at(200, "2"), "i,j,fn,ft\n").read();
  EXPECT_DOUBLE_EQ(s.packing.grains.position.at(0).x, 3);
  EXPECT_TRUE(says(s.notes, "3 snapshots, of which that of step 300 was taken"));
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

}  // namespace
}  // namespace arenite::io
