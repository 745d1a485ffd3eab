#include "io/results/results.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "core/error.hpp"
#include "io/disk/file.hpp"
#include "io/disk/store_file.hpp"
#include "support/field_results.hpp"
#include "support/program.hpp"

namespace {
using namespace arenite;
using test::small_field;
using test::TemporaryFolder;

bool operator==(const Bridge& a, const Bridge& b) {
  return a.i == b.i && a.j == b.j && a.half_i == b.half_i && a.half_j == b.half_j;
}

void expect_same(const History& a, const History& b) {
  ASSERT_EQ(a.columns.size(), b.columns.size());
  for (std::size_t c = 0; c < a.columns.size(); ++c) {
    EXPECT_EQ(a.columns[c].name, b.columns[c].name);
    EXPECT_EQ(a.columns[c].unit, b.columns[c].unit);
    EXPECT_EQ(a.columns[c].values, b.columns[c].values);
  }
}

TEST(FieldFile, ReadsBackWhatWasWritten) {
  const TemporaryFolder folder;
  const FieldResult r = small_field();
  io::write_field(folder / "f.h5", r);
  const FieldResult back = io::read_field(folder / "f.h5");
  EXPECT_EQ(back.name, r.name);
  EXPECT_EQ(back.outcome, r.outcome);
  EXPECT_TRUE(back.converged);
  EXPECT_EQ(back.provenance.input_hash, r.provenance.input_hash);
  EXPECT_EQ(back.provenance.options, r.provenance.options);
  EXPECT_EQ(back.packing.grains.position, r.packing.grains.position);
  EXPECT_EQ(back.packing.grains.radius, r.packing.grains.radius);
  EXPECT_EQ(back.packing.contacts.fn, r.packing.contacts.fn);
  EXPECT_EQ(back.packing.domain.wall[top].force, r.packing.domain.wall[top].force);
  EXPECT_EQ(back.cement.coating, r.cement.coating);
  ASSERT_EQ(back.cement.bridges.size(), 1u);
  EXPECT_TRUE(back.cement.bridges[0] == r.cement.bridges[0]);
  ASSERT_EQ(back.cement.menisci.size(), 1u);
  EXPECT_EQ(back.cement.menisci[0].radius, r.cement.menisci[0].radius);
  EXPECT_EQ(back.map.width, 12);
  EXPECT_EQ(back.map.height, 9);
  EXPECT_EQ(back.map.dx, r.map.dx);
  EXPECT_EQ(back.map.phase, r.map.phase);
  EXPECT_EQ(back.map.grain, r.map.grain);
  EXPECT_EQ(back.map.grain_class, r.map.grain_class);
  EXPECT_EQ(back.field.width, 12);
  for (auto component : {&StressField::ux, &StressField::uy, &StressField::xx, &StressField::yy, &StressField::xy})
    EXPECT_EQ(back.field.*component, r.field.*component);
  expect_same(back.convergence, r.convergence);
  expect_same(back.curve, r.curve);
  ASSERT_EQ(back.cracks.size(), 2u);
  EXPECT_EQ(back.cracks[0].x, r.cracks[0].x);
  EXPECT_EQ(back.cracks[1].type, 1);
  EXPECT_EQ(back.cracks[1].strain, 2e-4);
  EXPECT_EQ(back.numbers, r.numbers);
}

TEST(FieldFile, SampleWithoutGrainsOrStressesReadsBack) {
  const TemporaryFolder folder;
  FieldResult r = small_field();
  r.packing = {};
  r.cement = {};
  r.field = {};
  r.cracks.clear();
  io::write_field(folder / "f.h5", r);
  const FieldResult back = io::read_field(folder / "f.h5");
  EXPECT_EQ(back.packing.grains.size(), 0u);
  EXPECT_EQ(back.field.size(), 0u);
  EXPECT_TRUE(back.cracks.empty());
}

TEST(FieldFile, SameResultGivesSameBytes) {
  const TemporaryFolder folder;
  io::write_field(folder / "a.h5", small_field(300, 200));
  io::write_field(folder / "b.h5", small_field(300, 200));
  EXPECT_EQ(io::read_file(folder / "a.h5"), io::read_file(folder / "b.h5"));
}

TEST(FieldFile, KindsAreToldApart) {
  const TemporaryFolder folder;
  io::write_field(folder / "f.h5", small_field());
  io::write_stage(folder / "s.h5", test::two_snapshots(3));
  EXPECT_EQ(io::stored_kind(folder / "f.h5"), "field");
  EXPECT_EQ(io::stored_kind(folder / "s.h5"), "result");
  EXPECT_EQ(io::stored_kind(folder / "none.h5"), "");
  EXPECT_THROW(io::read_field(folder / "s.h5"), InputError);
  EXPECT_THROW(io::read_stage(folder / "f.h5"), InputError);
}

TEST(FieldFile, CutShortOrChangedIsDamaged) {
  const TemporaryFolder folder;
  io::write_field(folder / "f.h5", small_field());
  const std::string whole = io::read_file(folder / "f.h5");
  for (std::size_t k = 0; k < whole.size(); k += whole.size() / 97) {
    std::ofstream(folder / "cut.h5", std::ios::binary) << whole.substr(0, k);
    EXPECT_THROW(io::read_field(folder / "cut.h5"), InputError) << k;
    if (k < io::header_size) continue;
    std::string changed = whole;
    changed[k] = static_cast<char>(changed[k] ^ 1);
    std::ofstream(folder / "changed.h5", std::ios::binary) << changed;
    EXPECT_THROW(io::read_field(folder / "changed.h5"), io::DamagedFile) << k;
  }
}

TEST(FieldFile, LabelsThatPointNowhereAreRefused) {
  const TemporaryFolder folder;
  FieldResult r = small_field();
  r.map.grain[0] = 7;
  io::write_field(folder / "f.h5", r);
  EXPECT_THROW(io::read_field(folder / "f.h5"), InputError);
  r = small_field();
  r.cement.bridges[0].j = 9;
  io::write_field(folder / "f.h5", r);
  EXPECT_THROW(io::read_field(folder / "f.h5"), InputError);
}

TEST(FieldFile, OpenToOtherProgramsWithUnits) {
  const TemporaryFolder folder;
  io::write_field(folder / "f.h5", small_field());
  const auto seen = test::shell("/usr/bin/python3 -c \"import h5py; f = h5py.File('" + (folder / "f.h5").string() +
                                "'); s = f['field/sigma_yy']; print(s.shape, s.dtype, s.attrs['unit'].decode(), "
                                "f['map/phase'][0, 6], f['map'].attrs['dx [m]'])\"");
  ASSERT_EQ(seen.status, 0) << seen.err;
  EXPECT_EQ(seen.out, "(9, 12) float32 Pa 0 2.5e-05\n");
}

}  // namespace
