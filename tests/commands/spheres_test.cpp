// Recipes of spheres, from the file to the numbers.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "support/program.hpp"
#include "support/small_spheres.hpp"
#include "support/temporary_folder.hpp"

namespace {
using namespace arenite;
using test::arenite;
using test::TemporaryFolder;
using Json = nlohmann::json;

std::string written(const TemporaryFolder& folder, const std::string& recipe) {
  const auto path = folder / "recipe.toml";
  std::ofstream(path) << recipe;
  return path.string();
}

Json numbers_shown(const std::filesystem::path& out) {
  const auto outcome = arenite("show " + out.string() + " --json");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return Json::parse(outcome.out);
}

/// O'Hern et al., PRE 68, 011306 (2003): 0.639 +- 0.010 as the size grows, and z = 6 without rattlers, both from above
/// at a pressure above 0. Bands are five times the scatter of so few.
TEST(Spheres, WithoutFrictionTheyJamWhereTheyAreKnownTo) {
  const TemporaryFolder folder;
  const auto out = folder / "out";
  const auto run = arenite("run " + written(folder, test::small_spheres) + " --quiet --out " + out.string());
  ASSERT_EQ(run.status, 0) << run.err;
  const Json j = numbers_shown(out);
  EXPECT_NEAR(j["solid_fraction"]["value"].get<double>(), 0.64, 0.02);
  EXPECT_NEAR(j["coordination"]["without_rattlers"]["value"].get<double>(), 6.2, 0.3);
  EXPECT_NEAR(j["stress_details"]["pressure_Pa"].get<double>() / 10e3, 1, 5e-3);
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(j["stress"]["value"][axis][axis].get<double>() / -10e3, 1, 5e-3) << axis;
  const auto told = arenite("show " + out.string());
  EXPECT_TRUE(test::contains(told.out, "in equilibrium")) << told.out;
}

/// Platens at the top and the bottom, and a pressure on the four sides: the stress along the axis is what the platen
/// bears, and the sides keep theirs.
TEST(Spheres, ATriaxialTestKeepsItsSidePressure) {
  const TemporaryFolder folder;
  const auto out = folder / "out";
  const auto run = arenite("run " + written(folder, test::small_triaxial) + " --quiet --out " + out.string());
  ASSERT_EQ(run.status, 0) << run.err;
  const Json j = numbers_shown(out);
  const Json& walls = j["stages"].back()["last_state"]["walls"];
  const auto side = [&](const char* of, const char* what) { return walls[of][what].get<double>(); };
  const double width = side("right", "position_m") - side("left", "position_m"),
               depth = side("front", "position_m") - side("back", "position_m"),
               height = side("top", "position_m") - side("bottom", "position_m");
  const Json& stress = j["stress"]["value"];
  EXPECT_NEAR(side("top", "force_N") / (width * depth) / -stress[1][1].get<double>(), 1, 0.05);
  EXPECT_NEAR(side("right", "force_N") / (height * depth) / 10e3, 1, 0.05);
  EXPECT_NEAR(side("front", "force_N") / (height * width) / 10e3, 1, 0.05);
  for (const char* of : {"left", "right", "back", "front"}) {
    const Json& load = j["loads"][of];
    EXPECT_EQ(load["asked_Pa"].get<double>(), 10e3) << of;
    EXPECT_NEAR(load["reached_Pa"]["value"].get<double>() / 10e3, 1, 0.02) << of;
    EXPECT_TRUE(load["held"].get<bool>()) << of;
  }
  const double ratio = j["peak"]["q_over_p"].get<double>();
  EXPECT_GT(ratio, 0.6);
  EXPECT_LT(ratio, 1.4);
  EXPECT_LT(j["peak"]["strain"].get<double>(), 0.06);
  EXPECT_GT(stress[1][1].get<double>() / stress[0][0].get<double>(), 1.5) << "the axis bears more";
  EXPECT_GT(std::abs(j["fabric"]["axis"][1].get<double>()), 0.8) << "contacts turn to it";
  EXPECT_EQ(j["fabric"]["load_direction"], Json({0.0, 1.0, 0.0})) << "the recipe closes y";
  EXPECT_TRUE(j["end"]["volumetric_strain"].is_number());
  const auto states = arenite("show --states " + out.string());
  ASSERT_EQ(states.status, 0) << states.err;
  const std::string head = states.out.substr(0, states.out.find('\n'));
  EXPECT_TRUE(head.starts_with("stage,label,time [s],strain_x,strain_y,strain_z,volumetric_strain,")) << head;
  EXPECT_TRUE(test::contains(head, ",z,z_error,") && test::contains(head, ",q [Pa]")) << head;
  EXPECT_GT(std::count(states.out.begin(), states.out.end(), '\n'), 2);
}

/// By VTK and ASE themselves, beside the stage file as h5py reads it.
const char* const compare = R"(
import glob, sys
import h5py, numpy as np
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.util.numpy_support import vtk_to_numpy
stored = h5py.File(sorted(glob.glob(sys.argv[1] + '/02-*.h5'))[0])['frames/0000']
def read(name):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(sys.argv[2] + '/' + name)
    reader.Update()
    return reader.GetOutput()
grains, contacts = read('grains_0001.vtp'), read('contacts_0001.vtp')
points = vtk_to_numpy(grains.GetPoints().GetData())
assert np.allclose(points, np.stack([stored['grains'][c] for c in 'xyz'], 1))
radius = vtk_to_numpy(grains.GetPointData().GetArray('radius'))
force = vtk_to_numpy(contacts.GetCellData().GetArray('force'))
normal = np.stack([stored['contacts']['n' + c] for c in 'xyz'], 1)
assert np.allclose((force * normal).sum(1), stored['contacts']['fn'])
ends = vtk_to_numpy(contacts.GetPoints().GetData()).reshape(-1, 2, 3)
arms = stored['contacts']['arm_i'][()] + stored['contacts']['arm_j']
assert np.allclose(np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1), arms)
# The forces on every sphere are in balance: what a program makes of the file is an equilibrium.
i, j = (vtk_to_numpy(contacts.GetCellData().GetArray(n)) for n in 'ij')
total = np.zeros((len(radius), 3))
np.add.at(total, i, force)
np.add.at(total, j, -force)
assert np.linalg.norm(total, axis=1).max() < 0.02 * np.linalg.norm(force, axis=1).mean()
lines = open(sys.argv[3] + '/grains.extxyz').read().splitlines()
last = lines[-len(radius):]
assert np.allclose(np.array([line.split()[1:5] for line in last], float), np.column_stack([points, radius]))
assert 'pbc="T T T"' in lines[1]
import xarray
with xarray.open_dataset(sys.argv[4] + '/loading.nc') as loading:
    assert loading.x.dims == ('time', 'grain') and len(loading.time) == 2
    now = loading.isel(time=1)
    for c in 'xyz':
        np.testing.assert_array_equal(now[c], stored['grains'][c])
        np.testing.assert_array_equal(now['v' + c], stored['grains']['v' + c])
    here = loading.contact_state == 1
    np.testing.assert_array_equal(loading.contact_fn[here], stored['contacts']['fn'])
    np.testing.assert_array_equal(loading.contact_ft_z[here], stored['contacts']['ft_z'])
    assert len(loading.side) == 6 and loading.attrs['periodic'] == 'xyz'
)";

/// LAMMPS reads its dump of grains and writes them again.
const char* const lammps_reads = R"(units si
atom_style sphere
region whole block 0 1 0 1 0 1
create_box 1 whole
read_dump grains.dump STEP x y z box yes add keep
write_dump all custom back.dump id x y z modify format float %.17g sort id
)";

TEST(Spheres, AreReadByTheProgramsThatTheirFilesAreFor) {
  const TemporaryFolder folder;
  const auto out = (folder / "out").string(), vtk = (folder / "vtk").string(), xyz = (folder / "xyz").string(),
             nc = (folder / "nc").string(), fields = (folder / "fields").string();
  ASSERT_EQ(arenite("run " + written(folder, test::small_spheres) + " --quiet --out " + out).status, 0);
  ASSERT_EQ(arenite("export " + out + " --to vtk --out " + vtk).status, 0);
  ASSERT_EQ(arenite("export " + out + " --to extxyz --out " + xyz).status, 0);
  ASSERT_EQ(arenite("export " + out + " --to netcdf --out " + nc).status, 0);
  ASSERT_EQ(arenite("export " + out + " --to fields --out " + fields).status, 0);
  std::ofstream(folder / "compare.py") << compare;
  const auto read = test::shell("/usr/bin/python3 " + (folder / "compare.py").string() + " " + out + " " + vtk + " " +
                                xyz + " " + nc);
  EXPECT_EQ(read.status, 0) << read.err;
  const auto of_fields = test::shell(
      "/usr/bin/python3 " ARENITE_SOURCE_DIR "/tests/commands/compare_fields_in_space.py " + out + " " + fields);
  EXPECT_EQ(of_fields.status, 0) << of_fields.err;
  const auto refused = arenite("export " + out + " --to npy --out " + nc);
  EXPECT_EQ(refused.status, 2);
  EXPECT_TRUE(test::contains(refused.err, "vtk")) << refused.err;
}

/// What the dump of a periodic cell gives by `arenite measure` is what the run tells, on a page as well.
TEST(Spheres, DumpsOfLammpsAreMeasuredAsTheRunWas) {
  const TemporaryFolder folder;
  const auto out = (folder / "out").string();
  const auto dump = folder / "dump";
  ASSERT_EQ(arenite("run " + written(folder, test::small_spheres) + " --quiet --out " + out).status, 0);
  ASSERT_EQ(arenite("export " + out + " --to lammps --last --out " + dump.string()).status, 0);
  const auto measured = arenite("measure " + (dump / "grains.dump").string() + " " + (dump / "contacts.dump").string() +
                                " --out " + (folder / "measured").string() + " --json");
  ASSERT_EQ(measured.status, 0) << measured.err;
  const Json run = numbers_shown(out), now = Json::parse(measured.out), shown = numbers_shown(folder / "measured");
  for (const char* name : {"/grains", "/contacts", "/coordination/all", "/coordination/rattlers", "/solid_fraction"}) {
    const Json::json_pointer at(name);
    EXPECT_EQ(now[at], run[at]) << name;
    EXPECT_EQ(shown[at], run[at]) << name;
  }
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(now["stress"]["value"][axis][axis].get<double>() / run["stress"]["value"][axis][axis].get<double>(), 1,
                1e-9);
  EXPECT_NEAR(now["fabric"]["a_n"]["value"].get<double>(), run["fabric"]["a_n"]["value"].get<double>(), 1e-9);
  EXPECT_TRUE(std::filesystem::exists(folder / "measured" / "report.html"));
  // Without forces, by overlap: the same contacts, and no number that forces would give.
  const auto alone = arenite("measure " + (dump / "grains.dump").string() + " --json");
  ASSERT_EQ(alone.status, 0) << alone.err;
  const Json bare = Json::parse(alone.out);
  EXPECT_EQ(bare["coordination"]["all"], run["coordination"]["all"]);
  EXPECT_FALSE(bare.contains("stress"));
  EXPECT_TRUE(test::contains(bare["notes"].dump(), "touch where they overlap"));
  if (test::shell("which lmp").status != 0) return;
  std::string script = lammps_reads;
  script.replace(script.find("STEP"), 4, std::to_string(run["stages"].back()["last_state"]["step"].get<long>()));
  std::ofstream(dump / "in.lmp") << script;
  const auto lmp = test::shell("cd " + dump.string() + " && lmp -in in.lmp -log none");
  ASSERT_EQ(lmp.status, 0) << lmp.out << lmp.err;
  const std::string back = test::slurp(dump / "back.dump");
  EXPECT_TRUE(test::contains(back, fmt::format("ITEM: NUMBER OF ATOMS\n{}\n", run["grains"].get<int>()))) << back;
}

/// The table of our own spheres is cemented, cut into voxels and loaded as anybody's.
TEST(Spheres, OurOwnAreCementedAndLoaded) {
  const TemporaryFolder folder;
  const auto out = (folder / "out").string();
  const auto csv = folder / "csv";
  ASSERT_EQ(arenite("run " + written(folder, test::small_triaxial) + " --quiet --out " + out).status, 0);
  ASSERT_EQ(arenite("export " + out + " --to csv --last --out " + csv.string()).status, 0);
  const auto loaded = arenite("load " + (csv / "grains_0000.csv").string() +
                              " --voxels 40 --cement kind=bridges,width=0.5 --method elements --json");
  ASSERT_EQ(loaded.status, 0) << loaded.err;
  const Json j = Json::parse(loaded.out);
  EXPECT_EQ(j["map"]["grains"].get<int>(), 150);
  EXPECT_GT(j["modulus_Pa"].get<double>(), 1e8);
  EXPECT_LT(j["modulus_Pa"].get<double>(), 4e9);
  const Json run = numbers_shown(out);
  const Json& walls = run["stages"].back()["last_state"]["walls"];
  const auto place = [&](const char* side) { return walls[side]["position_m"].get<double>(); };
  const auto measured = arenite(
      fmt::format("measure {0}/grains_0000.csv {0}/contacts_0000.csv --box {1:.17g}m,{2:.17g}m,{3:.17g}m --origin "
                  "{4:.17g}m,{5:.17g}m,{6:.17g}m --json",
                  csv.string(), place("right") - place("left"), place("top") - place("bottom"),
                  place("front") - place("back"), place("left"), place("bottom"), place("back")));
  ASSERT_EQ(measured.status, 0) << measured.err;
  const Json now = Json::parse(measured.out);
  EXPECT_EQ(now["coordination"], run["coordination"]);
  EXPECT_EQ(now["wall_contacts"], run["wall_contacts"]);
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(now["stress"]["value"][axis][1].get<double>(), run["stress"]["value"][axis][1].get<double>(), 1e-3);
}

TEST(Spheres, ARecipeIsCheckedWithoutDoubtsAndSwept) {
  const TemporaryFolder folder;
  const std::string recipe = written(folder, test::small_spheres);
  const auto checked = arenite("check " + recipe);
  EXPECT_EQ(checked.status, 0);
  EXPECT_TRUE(test::contains(checked.err, "on one free core") && test::contains(checked.err, "memory ")) << checked.err;
  EXPECT_FALSE(test::contains(checked.err, "stages.")) << checked.err;
  std::ofstream(folder / "study.toml") << "base = \"recipe.toml\"\n[sweep]\nreplicates = 2\n";
  const std::string study = (folder / "study.toml").string(), out = " --out " + (folder / "study").string();
  const auto planned = arenite("check " + study);
  EXPECT_EQ(planned.status, 0);
  EXPECT_FALSE(test::contains(planned.err + planned.out, "refuse")) << planned.err << planned.out;
  ASSERT_EQ(arenite("study run " + study + out + " --quiet").status, 0);
  ASSERT_EQ(arenite("study collect " + study + out).status, 0);
  const std::string table = test::slurp(folder / "study" / "numbers.csv");
  EXPECT_TRUE(test::contains(table.substr(0, table.find('\n')), "coordination.without_rattlers")) << table;
}

TEST(Spheres, WhatSpaceDoesNotHaveIsRefusedInASentence) {
  const TemporaryFolder folder;
  const std::string recipe = written(folder, test::small_spheres);
  for (const auto& [set, part] :
       {std::pair{"stages.compress.open.front=true", "no wall at the front"},
        {"contact.cohesion=capillary_disks' --set 'contact.surface_tension=\"72 mN/m\"' --set "
         "'contact.liquid_volume=\"0.1 mm^3\"",
         "capillary_spheres"},
        {"populations.0.shape=pentagon", "no clumps"},
        {"packing.solid_fraction=0.7", "0.62 or less"},
        {"stages.compress.until=\"tme > 1 s\"", "did you mean time?"},
        {"container.thickness=\"10 mm\"", "dimension = 2"}}) {
    const auto outcome = arenite("check " + recipe + " --set '" + set + "'");
    EXPECT_EQ(outcome.status, 2) << set;
    EXPECT_TRUE(test::contains(outcome.err, part)) << set << ": " << outcome.err;
  }
  const auto flat = arenite("check " + recipe + " --set dimension=2");
  EXPECT_EQ(flat.status, 2);
  EXPECT_TRUE(test::contains(flat.err, "dimension = 3")) << flat.err;
}

TEST(Spheres, ThreadsAndKernelsGiveTheSameBytes) {
  const TemporaryFolder folder;
  const std::string recipe = written(folder, test::small_spheres);
  const auto run = [&](const char* name, const std::string& more) {
    EXPECT_EQ(arenite("run " + recipe + " --quiet --out " + (folder / name).string() + " " + more).status, 0);
    return arenite("show " + (folder / name).string() + " --json").out;
  };
  const Json one = Json::parse(run("one", "--set integration.kernel=portable")),
             two = Json::parse(run("two", "--threads 2"));
  EXPECT_EQ(one["stress"], two["stress"]);
  EXPECT_EQ(one["fabric"], two["fabric"]);
}

}  // namespace
