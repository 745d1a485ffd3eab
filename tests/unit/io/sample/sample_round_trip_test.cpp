#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "grains/texture/stress.hpp"
#include "grains/texture/texture.hpp"
#include "io/export/export.hpp"
#include "io/sample/sample.hpp"
#include "model/shapes.hpp"
#include "support/temporary_folder.hpp"

// What is exported and measured again is the sample that it was.
namespace arenite::io {
namespace {

/// Four dumbbells in a box: two of them meet in two contacts, one stands on the bottom, one leans on a boundary.
Packing dumbbells() {
  Packing p;
  p.materials = {{"=1+1", 1000, 1e6, 0}};
  p.domain.thickness = 0.01;
  p.domain.wall[left].position = -0.001;
  p.domain.wall[right].position = 0.05;
  p.domain.wall[bottom].position = 0;
  p.domain.wall[top].position = 0.04;
  Boundary funnel;
  funnel.name = "funnel";
  funnel.points = {{0.04, 0}, {0.05, 0.01}};
  p.domain.boundaries = {funnel};
  p.grains.resize(3);
  p.grains.position = {{0.01, 0.005}, {0.012, 0.0148}, {0.03, 0.01}};
  p.grains.radius = {0.006, 0.006, 0.007};
  const arenite::Shape dumbbell{{{-0.004, 0}, {0.004, 0}}, {0.005, 0.005}, false};
  for (int g = 0; g < 3; ++g) add_shape(p.grains.shapes, dumbbell, gyration_of(dumbbell));
  Contacts& c = p.contacts;
  const auto add = [&](std::int32_t i, std::int32_t j, Vec2 n, double fn, double ft, double arm_j, Vec2 off_i,
                       Vec2 off_j) {
    c.add(i, j, n, fn, ft, 0.0049, arm_j);
    c.off_i.push_back(off_i);
    c.off_j.push_back(off_j);
    c.overlap.back() = 2e-4;
  };
  add(0, 1, {0, -1}, 10, 2, 0.0049, {-0.004, 0}, {-0.006, 0});
  add(0, 1, {0, -1}, 30, -5, 0.0049, {0.004, 0}, {0.002, 0});
  add(0, wall_partner(bottom), {0, 1}, 25, 1, 0, {-0.004, 0}, {});
  add(2, boundary_partner(0), {-0.6, 0.8}, 7, 3, 0, {0.004, 0}, {});
  return p;
}

Sample measured_again(const Packing& packing, const ExportFormat& format, const SampleOptions& options) {
  const test::TemporaryFolder folder;
  Snapshot snapshot;
  snapshot.packing = packing;
  const auto files = format.of_snapshot({0, "rest", &snapshot, {}});
  for (const NamedBytes& file : files) std::ofstream(folder / file.name) << file.bytes;
  return read_sample(folder / files[0].name, folder / files[1].name, options);
}

void expect_the_same(const Packing& a, const Packing& b) {
  ASSERT_EQ(a.contacts.size(), b.contacts.size());
  for (std::size_t c = 0; c < a.contacts.size(); ++c) {
    EXPECT_EQ(a.contacts.is_wall(c), b.contacts.is_wall(c));
    EXPECT_NEAR(norm(a.contacts.force_on_i(c) - b.contacts.force_on_i(c)), 0, 1e-12);
    EXPECT_NEAR(norm(a.contacts.normal[c] - b.contacts.normal[c]), 0, 1e-12);
    EXPECT_NEAR(a.contacts.fn[c], b.contacts.fn[c], 1e-12);
    EXPECT_NEAR(norm(a.contacts.lever_i(c) - b.contacts.lever_i(c)), 0, 1e-15);
    if (!a.contacts.is_wall(c)) { EXPECT_NEAR(norm(a.contacts.lever_j(c) - b.contacts.lever_j(c)), 0, 1e-15); }
  }
  const auto x = texture::grain_stresses(a), y = texture::grain_stresses(b);
  for (std::size_t g = 0; g < x.size(); ++g)
    for (const auto part : {&Tensor2::xx, &Tensor2::xy, &Tensor2::yx, &Tensor2::yy})
      EXPECT_NEAR(x[g].*part, y[g].*part, 1e-7) << g;
}

SampleOptions box_of(const Packing& p) {
  SampleOptions o;
  const Vec2 size = p.domain.size(), corner = p.domain.corner();
  o.box = {size.x, size.y, p.domain.tilt};
  o.origin = {corner.x, corner.y};
  o.periodic = {p.domain.periodic[0], p.domain.periodic[1]};
  o.thickness = p.domain.thickness;
  return o;
}

TEST(SampleRoundTrip, TablesOfGrainsThatAreNoDisksGiveTheirStress) {
  const Packing before = dumbbells();
  const Sample after = measured_again(before, exports::csv, box_of(before));
  expect_the_same(before, after.packing);
  EXPECT_EQ(after.packing.materials.at(0).name, "=1+1");
  EXPECT_EQ(after.packing.domain.boundaries.at(0).name, "funnel");
}

TEST(SampleRoundTrip, DumpsOfGrainsThatAreNoDisksGiveTheirStress) {
  Packing before = dumbbells();
  before.domain.boundaries.clear();
  before.domain.periodic = {true, true};
  for (auto* numbers : {&before.contacts.fn, &before.contacts.ft, &before.contacts.arm_i, &before.contacts.arm_j,
                        &before.contacts.overlap, &before.contacts.sliding_velocity})
    numbers->resize(2);  // of grains
  before.contacts.i.resize(2);
  before.contacts.j.resize(2);
  for (auto* vectors : {&before.contacts.normal, &before.contacts.off_i, &before.contacts.off_j}) vectors->resize(2);
  before.contacts.glued.resize(2);
  SampleOptions o;
  o.thickness = before.domain.thickness;
  expect_the_same(before, measured_again(before, exports::lammps, o).packing);
}

TEST(SampleRoundTrip, ForcesOfBondsThatNoTableHoldsAreTold) {
  Packing p = dumbbells();
  Bond bond;
  bond.i = 0, bond.j = 2;
  p.bonds = {bond};
  for (const ExportFormat* format : {&exports::csv, &exports::lammps}) {
    const auto notes = measured_again(p, *format, box_of(p)).notes;
    EXPECT_TRUE(std::ranges::any_of(notes, [](const auto& note) {
      return note.find("joined by bonds or pulls") != note.npos;
    })) << format->name;
  }
  p.bonds[0].broken = BondBreak::shear;
  for (const auto& note : measured_again(p, exports::csv, box_of(p)).notes)
    EXPECT_EQ(note.find("bonds"), std::string::npos) << note;
}

}  // namespace
}  // namespace arenite::io
