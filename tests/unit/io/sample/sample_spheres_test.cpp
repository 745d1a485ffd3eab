#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include "io/export/export.hpp"
#include "model/packing.hpp"
#include "sample_files.hpp"

// Spheres of other programs, and our own read back.
namespace arenite::io {
namespace {

const std::string three = "id,x [mm],y [mm],z [mm],radius [mm]\n1,0,0,0,1\n2,1.9,0,0,1\n3,0,0,1.95,1\n4,0,0,-2.2,1\n";

TEST(SampleOfSpheres, ATableGivesForcesAsVectors) {
  const auto s =
      Files(three, "i,j,fx,fy,fz,overlap\n1,2,5,1,-2,0.0001\n3,left,-2,0,0.5,0\n3,1,0,0,0,5e-5\n1,4,0,0,0,-2e-4\n")
          .spheres();
  const ContactsIn<3>& c = s.packing.contacts;
  ASSERT_EQ(c.size(), 3u);  // one of zero force overlaps, the other is only listed
  EXPECT_TRUE(says(s.notes, "1 of 4 listed pairs have a gap"));
  EXPECT_NEAR(norm(c.normal[0] - Vec3{-1, 0, 0}), 0, 1e-12);
  EXPECT_DOUBLE_EQ(c.fn[0], 5);
  EXPECT_NEAR(norm(c.force_on_i(0) - Vec3{-5, -1, 2}), 0, 1e-12);
  EXPECT_DOUBLE_EQ(c.arm_i[0], 0.95e-3);
  EXPECT_EQ(c.j[1], wall_partner(left));
  EXPECT_DOUBLE_EQ(c.fn[1], 2);
  EXPECT_FALSE(s.packing.domain.is_cell());
  EXPECT_DOUBLE_EQ(s.packing.domain.extent(2), 6.15e-3) << "the smallest box where none is known";
}

TEST(SampleOfSpheres, CentresSayWhetherTheyAreSpheres) {
  EXPECT_TRUE(std::holds_alternative<SampleIn<3>>(Files(three, "i,j,fx,fy,fz\n1,2,1,0,0\n").any()) == false)
      << "four in a plane are disks";
  const std::string in_space = three + "5,0,1.9,0,1\n";
  EXPECT_TRUE(std::holds_alternative<SampleIn<3>>(Files(in_space, "i,j,fx,fy,fz\n1,2,1,0,0\n").any()));
  expect_part(Files(in_space, "i,j,fx,fy,fz\n1,2,1,0,0\n").problems(), "fill space");
}

TEST(SampleOfSpheres, WhatDoesNotSayEnoughIsRefused) {
  const auto refused = [](const std::string& contacts, const SampleOptions& options = {}) {
    return Files(three, contacts).problems_of_spheres(options);
  };
  expect_part(refused("i,j,fn,ft\n1,2,5,1\n"), "contacts.csv:2: ft says how large");
  EXPECT_EQ(refused("i,j,fn,ft\n1,2,5,0\n"), "");
  expect_part(refused("i,j,fx,fy\n1,2,5,1\n"), "no column \"fn\"");
  expect_part(refused("i,j,fn,nx,ny\n1,2,5,1,0\n"), "a column nx but no ny, nz");
  SampleOptions o;
  o.thickness = 1;
  expect_part(refused("i,j,fn\n1,2,5\n", o), "no thickness");
  o = {};
  o.box = {1, 1};
  expect_part(refused("i,j,fn\n1,2,5\n", o), "--box LX,LY,LZ");
  o.box = {4e-3, 4e-3, 4e-3};
  expect_part(refused("i,j,fn\n1,2,5\n", o), "more than the box's");
  expect_part(Files("id,x,y,radius\n1,0,0,1\n", "i,j,fn\n").problems_of_spheres(), "no column \"z\"");
}

const std::string atoms =
    "ITEM: UNITS\ncgs\nITEM: TIMESTEP\n7\nITEM: NUMBER OF ATOMS\n3\nITEM: BOX BOUNDS xy xz yz pp pp ff\n0 5 1\n0 4 "
    "0\n0 4 "
    "0\nITEM: ATOMS id type x y z radius\n1 1 0.2 0.5 1 0.5\n2 2 3.3 0.5 1 0.5\n3 1 1.2 3.6 1 0.5\n";

TEST(SampleOfSpheres, DumpsOfLammpsKeepTheirCellAndUnits) {
  const auto with = [&](const std::string& columns, const std::string& first, const std::string& second) {
    return Files(atoms, "ITEM: TIMESTEP\n7\nITEM: NUMBER OF ENTRIES\n2\nITEM: ENTRIES " + columns + "\n" + first +
                            "\n" + second + "\n")
        .spheres();
  };
  for (const char* columns :
       {"patom1 patom2 fx fy fz p1 p2 p3", "c_1[1] c_1[2] c_2[1] c_2[2] c_2[3] c_2[4] c_2[5] c_2[6]"}) {
    // The second atom is across x, the third across y, where the cell is shifted by 1 cm.
    const auto s = with(columns, "1 2 10 0 0 0 2 1", "1 3 0 22.8 0 1 0 0");
    EXPECT_EQ(s.packing.domain.periodic, (std::array{true, true, false}));
    EXPECT_DOUBLE_EQ(s.packing.domain.tilt, 0.01);
    EXPECT_DOUBLE_EQ(s.packing.domain.extent(0), 0.04);
    ASSERT_EQ(s.packing.contacts.size(), 2u);
    EXPECT_NEAR(norm(s.packing.contacts.force_on_i(0) - Vec3{1e-4, 2e-5, 1e-5}), 0, 1e-18);
    EXPECT_NEAR(s.packing.contacts.fn[0], 1e-4, 1e-18);
    EXPECT_NEAR(norm(s.packing.contacts.force_on_i(1) - Vec3{1e-5, 22.8e-5, 0}), 0, 1e-18);
    EXPECT_TRUE(says(s.notes, "no contacts with walls"));
  }
  std::string tilted = atoms;
  tilted.replace(tilted.find("0 4 0\n"), 6, "0 4 1\n");
  expect_part(Files(tilted, "i,j,fn\n").problems_of_spheres(), "do not lie along x, in the plane x-y and along z");
}

TEST(SampleOfSpheres, OfMercuryBothRowsAreOneContactAndSlopingWallsKeepTheirNormal) {
  const auto s = Files("2 0.5 0 0 0 4 4 4\n1 1 1 0 0 0 0.5 1 0 0 0 0 0 0\n1.9 1 1.1 0 0 0 0.5 1 0 0 0 0 0 1\n",
                       "# 0.5 0\n# 0 0 0 4 4 4\n# 0.5 0.5 0 0 0 0\n"
                       "0.5 0 1 1.45 1 1 0.1 0 10 3 -1 0 0 0 0.6 0.8\n0.5 1 0 1.45 1 1 0.1 0 10 3 1 0 0 0 -0.6 -0.8\n"
                       "0.5 0 -1 0.5 1 1 0.01 0 7 0 -1 0 0 0 0 0\n0.5 0 -2 0.5 1 1 0.01 0 2 0 -0.6 0.8 0 0 0 0\n")
                     .spheres();
  const ContactsIn<3>& c = s.packing.contacts;
  ASSERT_EQ(c.size(), 3u);
  EXPECT_NEAR(norm(c.force_on_i(0) - Vec3{-10, 1.8, 2.4}), 0, 1e-12);
  EXPECT_EQ(c.j[1], wall_partner(left));
  EXPECT_EQ(c.j[2], wall_partner(top));
  EXPECT_NEAR(norm(c.normal[2] - Vec3{0.6, -0.8, 0}), 0, 1e-12);
  EXPECT_NEAR(norm(c.force_on_i(2) - Vec3{1.2, -1.6, 0}), 0, 1e-12);
  EXPECT_TRUE(says(s.notes, "no side of the box"));
}

/// What a file of YADE says of its columns holds up to where it says otherwise.
TEST(SampleOfSpheres, OfYadeInteractionsEndAtImagesToo) {
  const Files files(
      "#format id_x_y_z_r_matId\n0 1 1 1 1 0\n1 9.2 1 1 1 0\n#format id_x_y_z_r\n2 1 1 2.9 1\n",
      "# vtk DataFile Version 3.0.\ncomment\nASCII\n\nDATASET POLYDATA\nPOINTS 4 double\n1 1 1\n-0.8 1 1\n"
      "1 1 1\n1 1 2.9\nLINES 2 6\n2 0 1\n2 2 3\nCELL_DATA 2\nVECTORS normalForce double\n-5 0 0\n0 0 3\n"
      "VECTORS shearForce double\n0 1 0\n0 0 0\n");
  SampleOptions o;
  o.box = {10, 10, 10};
  o.periodic = {true, true, true};
  const auto s = files.spheres(o);
  ASSERT_EQ(s.packing.contacts.size(), 2u);
  EXPECT_EQ(s.packing.contacts.j[0], 1);
  EXPECT_NEAR(norm(s.packing.contacts.force_on_i(0) - Vec3{5, -1, 0}), 0, 1e-12);
}

/// The same two spheres, of radius 0.5 and centres (1, 1, 1) and (1.9, 1, 1.5), as each program writes them.
TEST(SampleOfSpheres, EveryProgramsFileGivesTheSameSpheres) {
  const std::string xml =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt32\">\n"
      "<UnstructuredGrid><Piece NumberOfPoints=\"2\" NumberOfCells=\"0\"><PointData>\n"
      "<DataArray type=\"Float64\" Name=\"radii\" format=\"ascii\">0.5 0.5</DataArray>\n"
      "<DataArray type=\"Int32\" Name=\"id\" format=\"binary\">CAAAAAcAAAAIAAAA</DataArray></PointData>\n<Points>"
      "<DataArray type=\"Float32\" Name=\"Points\" NumberOfComponents=\"3\" format=\"ascii\">\n1 1 1\n1.9 "
      "1 1.5\n</DataArray>"
      "</Points></Piece></UnstructuredGrid></VTKFile>\n";
  const std::pair<std::string, bool> files[] = {
      {"Number of Spheres: 2\nDomain Length (x,y,z):  4, 4, 4\n1 1 1 0.5\n1.9 1 1.5 0.5\n", true},
      {"2\nLattice=\"4 0 0 0 4 0 0 0 4\" pbc=\"T T T\" Properties=species:S:1:pos:R:3:velo:R:3:radius:R:1\nX 1 1 1 0 0 "
       "0 "
       "0.5\nX 1.9 1 1.5 0 0 0 0.5\n",
       true},
      {"LAMMPS data file via write_data, timestep = 7, units = si\n\n2 atoms\n0 4 xlo xhi\n0 4 ylo yhi\n0 4 zlo zhi\n\n"
       "Atoms # sphere\n\n1 1 1 2500 1 1 1 0 0 0\n2 1 1 2500 1.9 1 1.5 0 0 0\n\nVelocities\n\n1 0 0 0 0 0 0\n",
       false},
      {xml, false}};
  for (const auto& [text, periodic] : files) {
    const auto s = Files(text, "").spheres();
    ASSERT_EQ(s.packing.grains.size(), 2u) << text;
    EXPECT_NEAR(norm(s.packing.grains.position[1] - Vec3{1.9, 1, 1.5}), 0, 1e-7) << text;
    EXPECT_DOUBLE_EQ(s.packing.grains.radius[1], 0.5) << text;
    EXPECT_EQ(s.packing.domain.periodic[2], periodic) << text;
    if (&text != &files[3].first) { EXPECT_DOUBLE_EQ(s.packing.domain.extent(2), 4) << text; }
  }
}

TEST(SampleOfSpheres, RowsBeyondTheAnnouncedOnesAreNotPassedOver) {
  const std::string head = "1\nProperties=pos:R:3:radius:R:1\n", row = "1 1 1 0.5\n";
  EXPECT_EQ(Files(head + row + "\n" + head + row, "").problems_of_spheres(), "");
  expect_part(Files(head + row + row, "").problems_of_spheres(),
              "grains.csv:4: 1 grains are announced, but more rows follow; correct the number");
}

TEST(SampleOfSpheres, ImagesThatLbpmListsAreNoSpheresOfTheirOwn) {
  const auto s =
      Files(
          "Number of Spheres: 3\nDomain Length (x,y,z): 1, 1, 1\n0.05 0.5 0.5 0.1\n1.05 0.5 0.5 0.1\n-0.1 0.2 "
          "0.5 0.05\n",
          "")
          .spheres();
  ASSERT_EQ(s.packing.grains.size(), 2u);
  EXPECT_NEAR(s.packing.grains.position[1].x, 0.9, 1e-12);
  EXPECT_TRUE(says(s.notes, "1 spheres are periodic images"));
}

PackingIn<3> pressed() {
  PackingIn<3> p;
  p.materials = {{"glass", 2500, 1e5, 0}, {"steel", 7800, 1e6, 0}};
  p.domain.wall[left].position = -0.002, p.domain.wall[right].position = 0.03;
  p.domain.wall[bottom].position = 0, p.domain.wall[top].position = 0.02;
  p.domain.wall[back].position = 0.001, p.domain.wall[front].position = 0.021;
  p.domain.periodic = {true, true, true};
  p.domain.tilt = 0.004;
  for (auto& wall : p.domain.wall) wall.present = false;
  p.grains.resize(3);
  p.grains.id = {4, 9, 2};
  p.grains.material = {0, 1, 0};
  p.grains.position = {{0.001, 0.01, 0.01}, {0.029, 0.01, 0.01}, {0.001, 0.01, 0.0139}};
  p.grains.radius = {0.002, 0.0021, 0.002};
  p.contacts.add(0, 1, {1, 0, 0}, 12, {0, 3, -1}, 0.00195, 0.00205);
  p.contacts.add(2, 0, {0, 0, 1}, 7, {0.5, 2, 0}, 0.00195, 0.00195);
  return p;
}

TEST(SampleOfSpheres, OurExportsReadBackAreThePackingThatTheyWere) {
  const PackingIn<3> before = pressed();
  SnapshotIn<3> snapshot;
  snapshot.packing = before;
  for (const ExportFormat* format : {&exports::lammps, &exports::csv, &exports::extxyz, &exports::vtk}) {
    const auto files = format->of_spheres({0, "rest", &snapshot, {}});
    const bool has_contacts = format == &exports::lammps || format == &exports::csv;
    const test::TemporaryFolder folder;
    for (const NamedBytes& file : files) std::ofstream(folder / file.name, std::ios::binary) << file.bytes;
    SampleOptions o;
    o.dimension = 3;
    if (format == &exports::csv || format == &exports::vtk) {
      o.box = {0.032, 0.02, 0.02, 0.004};
      o.origin = {-0.002, 0, 0.001};
      o.periodic = {true, true, true};
    }
    const auto after = std::get<SampleIn<3>>(
        read_any_sample(folder / files[0].name, has_contacts ? folder / files[1].name : std::filesystem::path(), o));
    const PackingIn<3>& p = after.packing;
    EXPECT_EQ(p.grains.position, before.grains.position) << format->name;
    EXPECT_EQ(p.grains.radius, before.grains.radius) << format->name;
    auto id = before.grains.id;
    if (format == &exports::lammps) std::ranges::for_each(id, [](auto& each) { ++each; });  // LAMMPS has no atom 0
    EXPECT_EQ(p.grains.id, id) << format->name;
    EXPECT_EQ(p.grains.material, before.grains.material) << format->name;
    if (format == &exports::csv || format == &exports::extxyz) {  // the others have numbers alone
      ASSERT_EQ(p.materials.size(), 2u) << format->name;
      EXPECT_EQ(p.materials[1].name, "steel") << format->name;
    }
    EXPECT_EQ(p.domain.periodic, before.domain.periodic) << format->name;
    EXPECT_DOUBLE_EQ(p.domain.tilt, before.domain.tilt) << format->name;
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(p.domain.corner()[axis], before.domain.corner()[axis], 1e-17) << format->name;
      EXPECT_NEAR(p.domain.extent(axis), before.domain.extent(axis), 1e-17) << format->name;
    }
    ASSERT_EQ(p.contacts.size(), has_contacts ? 2u : 0u) << format->name;
    for (std::size_t c = 0; c < p.contacts.size(); ++c) {
      EXPECT_EQ(p.contacts.i[c], before.contacts.i[c]);
      EXPECT_NEAR(norm(p.contacts.force_on_i(c) - before.contacts.force_on_i(c)), 0, 1e-13) << format->name;
    }
  }
}

}  // namespace
}  // namespace arenite::io
