#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

#include "support/document_of_page.hpp"
#include "support/program.hpp"

namespace {
using namespace arenite;
using test::arenite;
using test::TemporaryFolder;
using Json = nlohmann::json;
namespace fs = std::filesystem;

/// A volume of 12^3 voxels made by an expression of Python over x, y and z, saved by NumPy.
std::string volume(const fs::path& file, const std::string& value) {
  const auto made =
      test::shell("/usr/bin/python3 -c \"import numpy as np; z, y, x = np.mgrid[0:12, 0:12, 0:12]; np.save('" +
                  file.string() + "', np.where(" + value + ").astype(np.uint8))\"");
  EXPECT_EQ(made.status, 0) << made.err;
  return file.string();
}

const std::string by_elements = " --method elements --poisson matrix=0 --dx '10 um' --json ";

TEST(LoadVoxels, LayersInSpaceHaveTheirExactModuli) {
  const TemporaryFolder folder;
  const std::string map = volume(folder / "map.npy", "x % 6 < 3, 1, 2");
  const auto loaded =
      arenite("load " + map + by_elements +
              "--phases 1=particle,2=matrix --effective-stiffness --tolerance 1e-8 --out " + (folder / "out").string());
  ASSERT_EQ(loaded.status, 0) << loaded.err;
  const Json j = Json::parse(loaded.out);
  EXPECT_NEAR(j["modulus_Pa"].get<double>() / 2.5e9, 1, 1e-6);  // 1 and 4 GPa, along the layers
  const Json& young = j["effective_stiffness"]["young_Pa"];
  EXPECT_NEAR(young[0].get<double>() / 1.6e9, 1, 1e-6);  // across them
  EXPECT_NEAR(young[1].get<double>() / 2.5e9, 1, 1e-6);
  EXPECT_NEAR(young[2].get<double>() / 2.5e9, 1, 1e-6);
  EXPECT_NEAR(j["stress"]["sigma_zz"]["sets"]["particle"]["mean_over_sample_mean"]["value"].get<double>(), 1.6, 1e-4);
  EXPECT_EQ(j["map"]["voxels"], (Json{12, 12, 12}));
  const auto shown = arenite("show --json " + (folder / "out").string());
  ASSERT_EQ(shown.status, 0) << shown.err;
  EXPECT_EQ(Json::parse(shown.out)["effective_stiffness"], j["effective_stiffness"]);
  const auto exported = arenite("export " + (folder / "out").string() + " --to vtk --out " + (folder / "vtk").string());
  ASSERT_EQ(exported.status, 0) << exported.err;
  const auto read = test::shell(
      "/usr/bin/python3 -c \"import vtk; r = vtk.vtkXMLImageDataReader(); r.SetFileName('" +
      (folder / "vtk" / "tension.vti").string() +
      "'); r.Update(); o = r.GetOutput(); a = o.GetPointData().GetArray('stress'); print(o.GetDimensions(), "
      "o.GetSpacing()[2], a.GetNumberOfComponents(), round(a.GetTuple(0)[2] / 1e4))\"");
  EXPECT_EQ(read.out, "(12, 12, 12) 1e-05 6 40\n") << read.err;
  const auto arrays = arenite("export " + (folder / "out").string() + " --to numpy --out " + (folder / "npy").string());
  ASSERT_EQ(arrays.status, 0) << arrays.err;
  const auto loads = test::shell(
      "/usr/bin/python3 -c \"import numpy as np; a = lambda n: np.load('" + (folder / "npy" / "tension_").string() +
      "' + n + '.npy'); s = a('sigma_zz'); print(s.shape, s.dtype, a('phase')[0, 0].tolist(), "
      "a('grain')[5, 7, 4], round(float(s[0, 0, 0]) / 1e4), a('uz')[-1, 0, 0] > "
      "a('uz')[0, 0, 0])\"");
  EXPECT_EQ(loads.out, "(12, 12, 12) float32 [2, 2, 2, 1, 1, 1, 2, 2, 2, 1, 1, 1] -1 40 True\n") << loads.err;
  const auto csv = arenite("export " + (folder / "out").string() + " --to csv");
  EXPECT_EQ(csv.status, 2);
  EXPECT_NE(csv.err.find("choose vtk or npy"), std::string::npos) << csv.err;
}

TEST(LoadVoxels, TheResultIsStoredOnceAndDrawn) {
  const TemporaryFolder folder;
  const std::string out = " --out " + (folder / "out").string();
  const std::string map = volume(folder / "map.npy", "x % 6 < 3, 1, 2") + " --phases 1=particle,2=matrix";
  const auto first = arenite("load " + map + by_elements + out);
  ASSERT_EQ(first.status, 0) << first.err;
  fs::path file;
  for (const auto& entry : fs::directory_iterator(folder / "out"))
    if (entry.path().extension() == ".h5") file = entry.path();
  const std::string bytes = test::slurp(file);
  ASSERT_FALSE(bytes.empty());
  const auto again = arenite("load " + map + by_elements + out);
  EXPECT_EQ(again.out, first.out);
  EXPECT_EQ(test::slurp(file), bytes);
  const auto read = test::shell("/usr/bin/python3 -c \"import h5py; f = h5py.File('" + file.string() +
                                "'); print(f['field/sigma_zz'].shape, f['field/sigma_zz'].attrs['unit'].decode(), "
                                "f['map/phase'][0, 0, :4].tolist())\"");
  EXPECT_EQ(read.out, "(12, 12, 12) Pa [2, 2, 2, 1]\n") << read.err;
  const Json document = test::document_of_page(folder / "out" / "report.html");
  ASSERT_EQ(document["volumes"].size(), 1u);
  const Json& volume = document["volumes"][0];
  EXPECT_EQ(volume["size"], (Json{12, 12, 12}));
  EXPECT_EQ(volume["quantities"]["zz"]["code"]["n"], 1728);
  EXPECT_NEAR(volume["quantities"]["zz"]["mean"].get<double>(), 2.5e5, 1);  // 2.5 GPa at 1e-4
  // A damaged file is computed again.
  fs::resize_file(file, 2000);
  const auto mended = arenite("load " + map + by_elements + out);
  EXPECT_EQ(mended.status, 0) << mended.err;
  EXPECT_EQ(test::slurp(file), bytes);
}

TEST(LoadVoxels, AStackOfPicturesIsASampleInSpaceWhereItIsSaid) {
  const TemporaryFolder folder;
  const auto made = test::shell("/usr/bin/python3 -c \"import h5py, numpy as np; h5py.File('" +
                                (folder / "s.h5").string() + "', 'w')['map'] = np.ones((9, 8, 7), np.uint8)\"");
  ASSERT_EQ(made.status, 0) << made.err;
  const auto loaded = arenite("load " + (folder / "s.h5").string() + by_elements +
                              "--dimension 3 --phases 0=void,1=matrix --lower sliding");
  ASSERT_EQ(loaded.status, 0) << loaded.err;
  const Json j = Json::parse(loaded.out);
  EXPECT_EQ(j["map"]["voxels"], (Json{7, 8, 9}));
  EXPECT_NEAR(j["modulus_Pa"].get<double>() / 1e9, 1, 1e-6);
}

TEST(LoadVoxels, WhatLiesBesideTheFileIsPartOfTheSample) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "slices");
  const auto fill = [&](const std::string& value) {  // 6 x 6 x 6 voxels beside a header, and as slices
    const auto made = test::shell("cd " + folder.path().string() + " && /usr/bin/python3 -c \"import numpy as np; " +
                                  "v = np.ones((6, 6, 6), np.uint8); v[:, :, 0] = " + value + "; v.tofile('v.raw'); " +
                                  "[np.save(f'slices/{k}.npy', v[k:k + 1]) for k in range(6)]\"");
    EXPECT_EQ(made.status, 0) << made.err;
  };
  std::ofstream(folder / "v.mhd") << "ObjectType = Image\nNDims = 3\nDimSize = 6 6 6\nElementType = MET_UCHAR\n"
                                     "ElementDataFile = v.raw\n";
  for (const auto& [value, share] : {std::pair{"1", 1.0}, {"0", 5.0 / 6}}) {
    fill(value);
    for (const std::string name : {"v.mhd", "slices"}) {
      const auto loaded =
          arenite("load " + (folder / name).string() + by_elements + "--dimension 3 --phases 0=void,1=matrix --out " +
                  (folder / ("out-" + name)).string());
      ASSERT_EQ(loaded.status, 0) << loaded.err;
      EXPECT_NEAR(Json::parse(loaded.out)["modulus_Pa"].get<double>() / 1e9, share, 1e-5) << name;
    }
  }
}

TEST(LoadVoxels, AFolderOfSlicesIsTheMapOfARecipe) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "slices");
  const auto made = test::shell("cd " + folder.path().string() + " && /usr/bin/python3 -c \"import numpy as np; " +
                                "[np.save(f'slices/{k}.npy', np.ones((1, 6, 6), np.uint8)) for k in range(6)]\"");
  ASSERT_EQ(made.status, 0) << made.err;
  std::ofstream(folder / "r.toml") << "[map]\nfile = \"slices\"\nphases = \"1=matrix,2=particle\"\ndimension = 3\n"
                                      "[[loads]]\nname = \"pull\"\nmethod = \"elements\"\n";
  const auto run = arenite("run " + (folder / "r.toml").string() + " --out " + (folder / "out").string());
  EXPECT_EQ(run.status, 0) << run.err;
}

TEST(LoadVoxels, ATableOfSpheresIsCementedAndLoaded) {
  const TemporaryFolder folder;
  const fs::path table = folder / "spheres.csv";
  {
    std::ofstream file(table);
    file << "x [mm],y [mm],z [mm],radius [mm]\n";
    for (int k = 0; k < 27; ++k)  // a crystal that is not quite one: its necks grow at different widths
      file << k % 3 + 0.011 * (k % 5) << ',' << k / 3 % 3 + 0.007 * (k % 7) << ',' << k / 9 << ",0.5\n";
  }
  const auto loaded = arenite("load " + table.string() +
                              " --method elements --voxels 36 --cement kind=bridges,saturation=0.1 --json --out " +
                              (folder / "out").string());
  ASSERT_EQ(loaded.status, 0) << loaded.err;
  const Json j = Json::parse(loaded.out);
  EXPECT_EQ(j["map"]["grains"], 27);
  EXPECT_NEAR(j["map"]["dx_m"].get<double>(), 3.044e-3 / 36, 1e-9);
  const double grains = j["map"]["phases"]["particle"], matrix = j["map"]["phases"]["matrix"];
  EXPECT_NEAR(grains, 3.14159265 / 6, 0.02);
  EXPECT_NEAR(matrix / (1 - grains), 0.1, 0.01);
  EXPECT_GT(j["modulus_Pa"].get<double>(), 1e7);
  EXPECT_NE(loaded.err.find("27 spheres"), std::string::npos) << loaded.err;
}

TEST(LoadVoxels, ABoxOfMenisciIsCutOutOfATable) {
  const TemporaryFolder folder;
  const fs::path table = folder / "spheres.csv";
  {
    std::ofstream file(table);
    file << "x [mm],y [mm],z [mm],radius [mm]\n";
    for (int k = 0; k < 125; ++k) file << k % 5 << ',' << k / 5 % 5 << ',' << k / 25 << ",0.5\n";
  }
  const std::string load = "load " + table.string() + " --method elements --voxels 32 --json --cement ";
  const auto loaded = arenite(load + "kind=menisci,width=0.5,contact_angle=20deg --box 1mm,1mm,1mm,3mm,3mm,3mm");
  ASSERT_EQ(loaded.status, 0) << loaded.err;
  const Json j = Json::parse(loaded.out);
  EXPECT_EQ(j["map"]["voxels"], (Json{32, 32, 32}));
  EXPECT_EQ(j["map"]["grains"], 27);
  EXPECT_NEAR(j["map"]["dx_m"].get<double>(), 2e-3 / 32, 1e-12);
  EXPECT_NEAR(j["map"]["phases"]["particle"].get<double>(), 3.14159265 / 6, 0.01);
  EXPECT_GT(j["map"]["phases"]["matrix"].get<double>(), 0.005);
  const auto refused = [&](const std::string& box) { return arenite(load + "kind=none --box " + box); };
  EXPECT_NE(refused("1mm,1mm,1mm").err.find("six lengths"), std::string::npos);
  EXPECT_NE(refused("3mm,1mm,1mm,1mm,3mm,3mm").err.find("lowest corner first"), std::string::npos);
  const auto beside = refused("13mm,1mm,1mm,14mm,3mm,3mm");
  EXPECT_EQ(beside.status, 2);
  EXPECT_NE(beside.err.find("no sphere reaches"), std::string::npos) << beside.err;
}

TEST(LoadVoxels, GrainsArePartedByWatershedAndALackingLengthIsAFact) {
  const TemporaryFolder folder;
  const std::string load = "load " +
                           volume(folder / "map.npy",
                                  "((x - 2)**2 + (y - 5.5)**2 + (z - 5.5)**2 < 14) | ((x - 9)**2 + (y - 5.5)**2 + "
                                  "(z - 5.5)**2 < 14), 2, 1") +
                           " --method elements --phases 1=matrix,2=particle --json ";
  const auto together = arenite(load), apart = arenite(load + "--labels watershed --out " + (folder / "out").string());
  ASSERT_EQ(together.status, 0) << together.err;
  ASSERT_EQ(apart.status, 0) << apart.err;
  EXPECT_EQ(Json::parse(together.out)["map"]["grains"], 1);
  const Json map = Json::parse(apart.out)["map"];
  EXPECT_EQ(map["grains"], 2);
  EXPECT_FALSE(map.contains("dx_m"));
  EXPECT_EQ(map["lengths"], "in voxels, since dx was not given");
  EXPECT_NE(arenite("show " + (folder / "out").string()).out.find("in voxels, since dx was not given"),
            std::string::npos);
  EXPECT_EQ(test::document_of_page(folder / "out" / "report.html")["volumes"][0]["in_voxels"], true);
  const auto box = arenite(load + "--box 0m,0m,0m,1m,1m,1m");
  EXPECT_EQ(box.status, 2);
  EXPECT_NE(box.err.find("leave it out"), std::string::npos) << box.err;
}

TEST(LoadVoxels, WhatIsOfThePlaneIsRefused) {
  constexpr auto npos = std::string::npos;
  const TemporaryFolder folder;
  const std::string map = volume(folder / "map.npy", "x < 6, 1, 2") + " --phases 1=particle,2=matrix ";
  const auto refused = [&](const std::string& options) {
    const auto r = arenite("load " + map + options);
    EXPECT_EQ(r.status, 2) << options;
    return r.err;
  };
  EXPECT_NE(refused("--method relaxation").find("dynamic solvers are of the plane"), std::string::npos);
  EXPECT_NE(refused("--stop-at-voids").find("leave exact_stretch"), std::string::npos);
  EXPECT_NE(refused("--failure").find("a crack needs a length"), std::string::npos);
  EXPECT_NE(refused("--failure --dx '1 um' --axis x").find("leave axis out"), std::string::npos);
  EXPECT_NE(refused("--method elements --axis x").find("leave axis out"), std::string::npos);
  EXPECT_NE(refused("--method elements --slice 3").find("store the slice that is meant as a picture"), npos);
}

}  // namespace
