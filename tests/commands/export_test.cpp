#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include <nlohmann/json.hpp>

#include "io/disk/file.hpp"
#include "io/results/results.hpp"
#include "model/shapes.hpp"
#include "support/program.hpp"
#include "support/sample_results.hpp"

namespace {
using namespace arenite;
using test::arenite;
using test::shell;
using test::TemporaryFolder;

std::string quoted(const std::filesystem::path& path) { return "'" + path.string() + "'"; }

/// The distribution's Python, which has h5py and VTK.
std::string python(const std::string& script) {
  return "/usr/bin/python3 " ARENITE_SOURCE_DIR "/tests/commands/" + script + " ";
}

class Export : public testing::Test {
 protected:
  Export() { io::write_stage(file, test::two_snapshots(6)); }
  TemporaryFolder folder;
  const std::filesystem::path file = folder / "01-compact.h5";
};

TEST_F(Export, VtkItselfReadsBackEveryValueAndTime) {
  const auto done = arenite("export " + file.string() + " --to vtk");
  ASSERT_EQ(done.status, 0) << done.err;
  const auto read = shell(python("compare_vtk.py") + file.string() + " " + (folder / "vtk").string());
  EXPECT_EQ(read.status, 0) << read.err;
  EXPECT_EQ(read.out, "checked 2 states\n");
}

TEST_F(Export, VtkReadsArraysOfMoreThanOneCompressedBlock) {
  io::write_stage(file, test::two_snapshots(6000));
  ASSERT_EQ(arenite("export " + file.string() + " --to vtk").status, 0);
  const auto read = shell(python("compare_vtk.py") + file.string() + " " + (folder / "vtk").string());
  EXPECT_EQ(read.status, 0) << read.err;
}

/// A square, a pair of disks and a disk by turns.
void give_shapes(Grains& grains) {
  const Shape kinds[] = {
      {{{0.006, 0.006}, {-0.006, 0.006}, {-0.006, -0.006}, {0.006, -0.006}}, {0.002, 0.002, 0.002, 0.002}, true},
      {{{-0.003, 0}, {0.003, 0}}, {0.005, 0.005}, false},
      {{{0, 0}}, {0.0101}, false}};
  for (std::size_t g = 0; g < grains.size(); ++g) add_shape(grains.shapes, kinds[g % 3], gyration_of(kinds[g % 3]));
}

TEST_F(Export, VtkReadsTheRimsOfGrainsThatAreNoDisks) {
  StageResult result = test::two_snapshots(6);
  for (Snapshot& snapshot : result.snapshots) give_shapes(snapshot.packing.grains);
  io::write_stage(file, result);
  ASSERT_EQ(arenite("export " + file.string() + " --to vtk").status, 0);
  const auto read = shell(python("compare_outlines.py") + file.string() + " " + (folder / "vtk").string());
  EXPECT_EQ(read.status, 0) << read.err;
  EXPECT_EQ(read.out, "checked 2 states\n");
}

TEST_F(Export, XarrayOpensALoadingAsArraysOverTimeAndGrain) {
  const auto done = arenite("export " + file.string() + " --to netcdf");
  ASSERT_EQ(done.status, 0) << done.err;
  const auto read = shell(python("compare_netcdf.py") + file.string() + " " + (folder / "netcdf/loading.nc").string());
  EXPECT_EQ(read.status, 0) << read.err;
  EXPECT_EQ(read.out, "checked 2 states\n");
}

TEST_F(Export, ALoadingWhoseGrainsChangeFitsInNoArray) {
  auto result = test::two_snapshots(6);
  result.snapshots[1].packing.grains.id[2] = 77;
  io::write_stage(file, result);
  const auto refused = arenite("export " + file.string() + " --to netcdf");
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("do not have the same grains"), std::string::npos) << refused.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "netcdf"));
}

TEST_F(Export, LammpsItselfReadsTheDumpAtItsStep) {
  ASSERT_EQ(arenite("export " + file.string() + " --to lammps").status, 0);
  std::ofstream(folder / "in")
      << "units si\ndimension 2\natom_style sphere\nboundary f f p\nregion b block 0 1 0 1 -0.1 0.1\ncreate_box 2 b\n"
         "read_dump lammps/grains.dump 2000 x y vx vy box yes add keep\n"
         "write_dump all custom out.dump id type x y vy modify sort id format float %.17g\n";
  const auto run = shell("cd " + folder.path().string() + " && lmp -in in -log none");
  ASSERT_EQ(run.status, 0) << run.out << run.err;
  const auto grains = test::two_snapshots(6).snapshots[1].packing.grains;
  std::istringstream dump(io::read_file(folder / "out.dump"));
  std::string line;
  while (std::getline(dump, line) && !line.starts_with("ITEM: ATOMS")) {}
  for (std::size_t i = 0; i < grains.size(); ++i) {
    int id = 0, type = 0;
    double x = 0, y = 0, vy = 0;
    dump >> id >> type >> x >> y >> vy;
    EXPECT_EQ(id, grains.id[i] + 1);
    EXPECT_EQ(type, grains.material[i] + 1);
    EXPECT_EQ(x, grains.position[i].x);
    EXPECT_EQ(y, grains.position[i].y);
    EXPECT_EQ(vy, grains.velocity[i].y);
  }
}

TEST_F(Export, AseReadsExtendedXyzWhateverMaterialsAreCalled) {
  auto result = test::two_snapshots(6);
  for (Snapshot& snapshot : result.snapshots) {
    snapshot.packing.materials[0].name = "glass \"soda\" [D\u00e9lrin]";
    snapshot.packing.domain.periodic[0] = true;
  }
  io::write_stage(file, result);
  ASSERT_EQ(arenite("export " + file.string() + " --to ase --out " + (folder / "ase").string()).status, 0);
  const auto read = shell(python("read_extxyz.py") + (folder / "ase/grains.extxyz").string());
  EXPECT_EQ(read.status, 0) << read.err;
  EXPECT_EQ(read.out, "read 2 states\n");
}

TEST_F(Export, FormatsAreAskedForByTheProgramsThatReadThem) {
  for (const auto& [program, format] : {std::pair{"ovito", "lammps"},
                                        {"xarray", "netcdf"},
                                        {"paraview", "vtk"},
                                        {"ase", "extxyz"},
                                        {"pandas", "csv"},
                                        {"xyz", "extxyz"}}) {
    const auto done = arenite("export " + file.string() + " --to " + program);
    EXPECT_EQ(done.status, 0) << done.err;
    const auto named = arenite("export " + file.string() + " --to " + format + " --out " + (folder / "named").string());
    EXPECT_EQ(shell("diff -r " + (folder / format).string() + " " + (folder / "named").string()).status, 0) << program;
    std::filesystem::remove_all(folder / "named");
  }
}

TEST_F(Export, TextFormatsHoldWhatTheStageFileHolds) {
  for (const std::string format : {"lammps", "extxyz", "csv"}) {
    const auto out = folder / ("as " + format);
    const auto done = arenite("export " + file.string() + " --to " + format + " --out " + quoted(out));
    ASSERT_EQ(done.status, 0) << done.err;
    const auto read = shell(python("compare_tables.py") + file.string() + " " + quoted(out) + " " + format);
    EXPECT_EQ(read.status, 0) << format << read.err;
  }
}

/// Every number of `a` that `b` has under the same name, too, is the same to rounding; returns how many there are.
std::size_t compare_numbers(const nlohmann::json& a, const nlohmann::json& b, const std::string& place) {
  if (a.is_number() && b.is_number()) {
    const double x = a, y = b;
    EXPECT_NEAR(x, y, 1e-9 * std::max(std::abs(x), std::abs(y)) + 1e-12) << place;
    return 1;
  }
  std::size_t count = 0;
  if (a.is_object() && b.is_object())
    for (const auto& [key, value] : a.items())
      if (b.contains(key)) count += compare_numbers(value, b[key], place + "/" + key);
  if (a.is_array() && b.is_array() && a.size() == b.size())
    for (std::size_t k = 0; k < a.size(); ++k) count += compare_numbers(a[k], b[k], place + "/" + std::to_string(k));
  return count;
}

TEST_F(Export, MeasureReadsTheTablesAndTheDumpsAndFindsTheTextureThatShowTells) {
  auto result = test::two_snapshots(6);
  result.texture = {};
  result.snapshots.pop_back();
  io::write_stage(file, result);
  const auto shown = nlohmann::json::parse(arenite("show --json " + file.string()).out);
  ASSERT_EQ(arenite("export --last --to csv " + file.string()).status, 0);
  const auto tables =
      arenite("measure --json --box 0.13,0.05 --origin=-0.01,0 --thickness 0.06 " +
              (folder / "csv/grains_0000.csv").string() + " " + (folder / "csv/contacts_0000.csv").string());
  ASSERT_EQ(tables.status, 0) << tables.err;
  EXPECT_GT(compare_numbers(shown, nlohmann::json::parse(tables.out), "tables"), 60u);
  ASSERT_EQ(arenite("export --last --to lammps " + file.string()).status, 0);
  const auto dumps = arenite("measure --json --thickness 0.06 " + (folder / "lammps/grains.dump").string() + " " +
                             (folder / "lammps/contacts.dump").string());
  ASSERT_EQ(dumps.status, 0) << dumps.err;
  const auto read = nlohmann::json::parse(dumps.out);  // a local dump has no walls, so what these decide differs
  using Pointer = nlohmann::json::json_pointer;
  for (const char* part : {"/solid_fraction", "/coordination/all", "/fabric/a_c", "/fabric/phi", "/force"})
    EXPECT_GT(compare_numbers(shown[Pointer(part)], read[Pointer(part)], part), 0u) << part;
}

TEST_F(Export, AFolderOfStagesIsOneLoadingAndASharedStateIsWrittenOnce) {
  auto next = test::two_snapshots(6);
  next.snapshots[0] = test::two_snapshots(6).snapshots[1];
  next.snapshots[1].time = 1.5;
  io::write_stage(folder / "02-shear.h5", next);
  const auto done = arenite("export " + folder.path().string() + " --to vtk");
  ASSERT_EQ(done.status, 0) << done.err;
  const std::string list = io::read_file(folder / "vtk/grains.pvd");
  for (const std::string time : {"0.125", "0.375", "1.5"})
    EXPECT_NE(list.find("timestep=\"" + time + "\""), std::string::npos) << list;
  EXPECT_TRUE(std::filesystem::exists(folder / "vtk/walls_0002.vtp"));
  EXPECT_FALSE(std::filesystem::exists(folder / "vtk/walls_0003.vtp"));
}

TEST_F(Export, TheCurvesOfATestAreATableWithUnits) {
  StageResult result = test::two_snapshots(6);
  result.history.columns = {{"time", "s", {0, 1, 2}}};
  for (const char* low : {"left", "bottom"})
    result.history.columns.push_back({std::string(low) + "_position", "m", {0, 0, 0}});
  result.history.columns.push_back({"right_position", "m", {1, 1, 1}});
  result.history.columns.push_back({"top_position", "m", {1, 0.95, 0.9}});
  for (const char* side : {"left", "right", "bottom", "top"})
    result.history.columns.push_back({std::string(side) + "_force", "N", {10, 20, 30}});
  io::write_stage(file, result);
  const auto done = arenite("export " + file.string() + " --to csv");
  ASSERT_EQ(done.status, 0) << done.err;
  std::istringstream table(io::read_file((folder / "csv" / (result.name + "_curves.csv")).string()));
  std::string heads, first, second, third;
  for (std::string* line : {&heads, &first, &second, &third}) std::getline(table, *line);
  EXPECT_TRUE(heads.starts_with("time [s],strain_x,strain_y,axial_strain,volumetric_strain,")) << heads;
  EXPECT_NE(heads.find(",sigma_yy [Pa],"), std::string::npos) << heads;
  EXPECT_EQ(std::ranges::count(heads, ','), std::ranges::count(third, ','));
  EXPECT_TRUE(third.starts_with("2,0,0.09")) << third;
  ASSERT_EQ(arenite("export --last " + file.string() + " --to csv --out " + (folder / "last").string()).status, 0);
  EXPECT_FALSE(std::filesystem::exists(folder / "last" / (result.name + "_curves.csv")));
}

TEST_F(Export, LastWritesOnlyTheLastState) {
  ASSERT_EQ(arenite("export " + file.string() + " --to csv --last").status, 0);
  EXPECT_EQ(folder.count(), 2);
  EXPECT_TRUE(std::filesystem::exists(folder / "csv/grains_0000.csv"));
  EXPECT_FALSE(std::filesystem::exists(folder / "csv/grains_0001.csv"));
}

TEST_F(Export, SameResultGivesTheSameBytes) {
  for (const std::string format : {"vtk", "lammps", "extxyz", "netcdf", "csv"}) {
    for (const std::string where : {"a", "b"})
      ASSERT_EQ(
          arenite("export " + file.string() + " --to " + format + " --out " + (folder / (where + format)).string())
              .status,
          0);
    EXPECT_EQ(shell("diff -r " + (folder / ("a" + format)).string() + " " + (folder / ("b" + format)).string()).status,
              0);
  }
}

TEST_F(Export, BadInputIsOneSentenceAndLeavesNothing) {
  io::write_atomically(folder / "cut.h5", io::read_file(file).substr(0, 2000));
  const auto cut = arenite("export " + (folder / "cut.h5").string() + " --to vtk --out " + (folder / "new").string());
  EXPECT_EQ(cut.status, 2);
  EXPECT_NE(cut.err.find("truncated"), std::string::npos) << cut.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "new"));
  EXPECT_EQ(arenite("export " + file.string() + " --to povray").status, 2);
  const auto nowhere = arenite("export " + file.string() + " --to vtk --out " + (folder / "cut.h5/such").string());
  EXPECT_EQ(nowhere.status, 2);
  EXPECT_NE(nowhere.err.find("give another --out"), std::string::npos) << nowhere.err;
}

TEST_F(Export, AFullDiskIsSaidAndNoFileIsCut) {
  const auto full = shell("ulimit -f 1; " ARENITE_BINARY " export " + file.string() + " --to lammps");
  EXPECT_EQ(full.status, 2) << full.err;
  EXPECT_NE(full.err.find("size limit"), std::string::npos) << full.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "lammps"));
}

}  // namespace
