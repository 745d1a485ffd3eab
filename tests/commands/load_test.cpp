#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <set>

#include "support/document_of_page.hpp"
#include "support/program.hpp"

namespace {
using namespace arenite;
using test::arenite;
using test::TemporaryFolder;
using Json = nlohmann::json;
namespace fs = std::filesystem;

/// A picture made by an expression of Python over x and y (y down), read back as PNG by anybody.
std::string picture(const fs::path& file, int width, int height, const std::string& value) {
  const auto made =
      test::shell("/usr/bin/python3 -c \"import h5py, numpy as np; y, x = np.mgrid[0:" + std::to_string(height) +
                  ", 0:" + std::to_string(width) + "]; h5py.File('" + file.string() + "', 'w')['map'] = np.where(" +
                  value + ").astype(np.uint8)\"");
  EXPECT_EQ(made.status, 0) << made.err;
  return file.string();
}

std::string layers(const fs::path& file) { return picture(file, 60, 60, "(x // 10) % 2 == 0, 1, 2"); }

TEST(Load, LayersInParallelHaveTheMeanModulus) {
  const TemporaryFolder folder;
  const std::string map = layers(folder / "map.h5");
  const auto loaded = arenite(
      "load " + map + " --phases 1=particle,2=matrix --stiffness 'matrix=1 GPa,particle=4 GPa,interface=1 GPa' --json");
  ASSERT_EQ(loaded.status, 0) << loaded.err;
  const Json j = Json::parse(loaded.out);
  EXPECT_NEAR(j["modulus_Pa"].get<double>(), 2.5e9, 0.25e9);
  EXPECT_EQ(j["grains"]["all"], 3);
  EXPECT_EQ(j["load"]["ending"], "solved");
  const auto across = arenite("load " + map + " --phases 1=particle,2=matrix --axis x --json");
  ASSERT_EQ(across.status, 0) << across.err;
  EXPECT_LT(Json::parse(across.out)["modulus_Pa"].get<double>(), 0.9 * j["modulus_Pa"].get<double>());
}

TEST(Load, TellsTheIterationsOfWhatIsNotStored) {
  const TemporaryFolder folder;
  const std::string map = layers(folder / "map.h5");
  const auto solved = arenite("load " + map + " --phases 1=particle,2=matrix");
  EXPECT_NE(solved.err.find("iteration"), std::string::npos) << solved.err;
  EXPECT_NE(solved.err.find("residual"), std::string::npos) << solved.err;
  const auto apart = arenite("load " + map + " --phases 1=particle,2=void");
  EXPECT_EQ(apart.err.find("taken from an earlier run"), std::string::npos) << apart.err;
}

TEST(Load, ElementsGiveLayersTheirExactModulusAndSayWhatTheyAreMadeOf) {
  const TemporaryFolder folder;
  const std::string map = layers(folder / "map.h5") + " --phases 1=particle,2=matrix --method elements --json ";
  const auto loaded = arenite("load " + map + "--poisson 'matrix=0' --effective-stiffness");
  ASSERT_EQ(loaded.status, 0) << loaded.err;
  const Json j = Json::parse(loaded.out);
  EXPECT_NEAR(j["modulus_Pa"].get<double>() / 2.5e9, 1, 1e-5);  // interfaces lie in the matrix
  EXPECT_NEAR(j["load"]["reaction_balance_error"].get<double>(), 0, 1e-6);
  EXPECT_EQ(j["load"]["method"], "elements");
  EXPECT_EQ(j["load"]["element"], "wilson");
  EXPECT_EQ(j["load"]["plane"], "stress");
  EXPECT_EQ(j["load"]["poisson_ratio"]["particle"], 0);
  EXPECT_FALSE(j["load"].contains("bonds_across_voids"));
  EXPECT_NEAR(j["effective_stiffness"]["young_Pa"][0].get<double>() / 1.6e9, 1, 1e-5);  // across layers of 1 and 4 GPa
  EXPECT_NEAR(j["effective_stiffness"]["young_Pa"][1].get<double>() / 2.5e9, 1, 1e-5);
  const auto strained = arenite("load " + map + "--poisson 'matrix=0.3,particle=0.2' --plane strain");
  ASSERT_EQ(strained.status, 0) << strained.err;
  EXPECT_FALSE(Json::parse(strained.out).contains("modulus_bounds_Pa"));
  EXPECT_GT(Json::parse(strained.out)["modulus_Pa"].get<double>(), j["modulus_Pa"].get<double>());
  const auto wrong = arenite("load " + map + "--poisson 'matrix=0.5'");
  EXPECT_EQ(wrong.status, 2);
  EXPECT_NE(wrong.err.find("0.499"), std::string::npos) << wrong.err;
}

TEST(Load, StoresFieldAndPageAndMeasuresThemAgain) {
  const TemporaryFolder folder;
  const auto loaded = arenite("load " + layers(folder / "map.h5") + " --phases 1=particle,2=matrix --moduli --out " +
                              (folder / "out").string());
  ASSERT_EQ(loaded.status, 0) << loaded.err;
  EXPECT_NE(loaded.out.find("Apparent modulus"), std::string::npos);
  EXPECT_NE(loaded.out.find("in nodes, since dx was not given"), std::string::npos) << loaded.out;
  EXPECT_EQ(loaded.out.find("Node spacing"), std::string::npos) << "1 m was not said by anybody";
  EXPECT_TRUE(fs::exists(folder / "out/report.html"));
  const auto shown = arenite("show --json " + (folder / "out").string());
  ASSERT_EQ(shown.status, 0) << shown.err;
  EXPECT_EQ(Json::parse(shown.out)["provenance"]["options"]["map"], "map.h5");
  fs::path file;
  for (const auto& entry : fs::directory_iterator(folder / "out"))
    if (entry.path().extension() == ".h5") file = entry.path();
  const auto measured = arenite("measure " + file.string() + " --json --clamp-rows 10 --leave-out-surface");
  ASSERT_EQ(measured.status, 0) << measured.err;
  EXPECT_EQ(Json::parse(measured.out)["options"]["clamp_rows"], 10);
  const auto shear = arenite("load " + file.string() + " --loading shear"),
             quiet = arenite("load " + file.string() + " --loading shear --quiet");
  EXPECT_EQ(shear.status, 0);
  EXPECT_NE(shear.err.find("shear"), std::string::npos) << shear.err;
  EXPECT_EQ(quiet.status, 0);
  EXPECT_EQ(quiet.err, "");
  EXPECT_EQ(quiet.out, shear.out);
}

TEST(Load, ThePageTellsTheOptionsOfAPictureAndNoEmptyOnes) {
  const TemporaryFolder folder;
  const std::string map = layers(folder / "map.h5") + " --phases 1=particle,2=matrix --out ";
  ASSERT_EQ(arenite("load " + map + (folder / "a").string()).status, 0);
  ASSERT_EQ(arenite("load " + map + (folder / "b").string() + " --dx '25 um'").status, 0);
  const auto told = [&](const char* name) {
    const Json page = test::document_of_page(folder / name / "report.html");
    return page["fields"][0]["provenance"]["options"]["options"].get<std::string>();
  };
  EXPECT_EQ(told("a"), "phases = \"1=particle,2=matrix\"");
  EXPECT_EQ(told("b"), "phases = \"1=particle,2=matrix\", dx = \"25 um\"");
}

TEST(Load, IsTakenFromItsFolderTheSecondTime) {
  const TemporaryFolder folder;
  const std::string map = layers(folder / "map.h5"),
                    labels = picture(folder / "labels.h5", 60, 60, "(x // 10) % 2 == 0, 1 + x // 20, 0");
  const std::string command =
      "load " + map + " --phases 1=particle,2=matrix --labels " + labels + " --out " + (folder / "out").string();
  const auto files = [&] { return std::distance(fs::directory_iterator(folder / "out"), fs::directory_iterator()); };
  const auto first = arenite(command), second = arenite(command);
  ASSERT_EQ(second.status, 0) << second.err;
  EXPECT_EQ(first.err.find("taken from an earlier run"), std::string::npos) << first.err;
  EXPECT_NE(second.err.find("taken from an earlier run"), std::string::npos) << second.err;
  EXPECT_EQ(second.out, first.out);
  EXPECT_EQ(files(), 2) << "the field and its page";
  picture(labels, 60, 60, "(x // 10) % 2 == 0, 1 + x // 40, 0");
  EXPECT_EQ(arenite(command).err.find("taken from an earlier run"), std::string::npos)
      << "other labels are another sample";
  EXPECT_EQ(files(), 3);
}

TEST(Load, PageMeasuresStressesAsTheNumbersDo) {
  const TemporaryFolder folder;
  const std::string line = "load " + layers(folder / "map.h5") + " --phases 1=particle,2=matrix ";
  ASSERT_EQ(arenite(line + "--out " + (folder / "otherwise").string()).status, 0);
  const auto loaded = arenite(line + "--clamp-rows 8 --leave-out-surface --out " + (folder / "out").string());
  ASSERT_EQ(loaded.status, 0) << loaded.err;
  const Json page = test::document_of_page(folder / "out/report.html")["fields"][0];
  const Json otherwise = test::document_of_page(folder / "otherwise/report.html")["fields"][0];
  const Json& numbers = page["numbers"]["stress"];
  EXPECT_EQ(numbers["options"]["clamp_rows"], 8);
  for (const char* set : {"all", "matrix"}) {
    const std::string variance = test::number_in_key(page, set, "var");
    ASSERT_FALSE(variance.empty()) << set;
    EXPECT_NEAR(std::stod(variance), numbers["sigma_yy"]["sets"][set]["variance"]["value"].get<double>(),
                1.01 * test::half_digit(variance))
        << set;
    EXPECT_NE(variance, test::number_in_key(otherwise, set, "var")) << set;
  }
}

TEST(Load, SeveredAndEmptySamplesEndWithStatus3AndAName) {
  const TemporaryFolder folder;
  const auto cut = arenite("load " + picture(folder / "cut.h5", 40, 60, "(y > 25) & (y < 35), 0, 1") +
                           " --phases 0=void,1=particle --json");
  EXPECT_EQ(cut.status, 3) << cut.err;
  const Json j = Json::parse(cut.out);
  EXPECT_EQ(j["load"]["ending"], "severed");
  EXPECT_FALSE(j.contains("modulus_Pa"));
  for (const char* number : {": nan", ": null", " inf"}) EXPECT_EQ(cut.out.find(number), std::string::npos) << number;
}

const std::string hairlines = ARENITE_SOURCE_DIR "/tests/data/phase_maps/";

TEST(Load, HairlineCrackIsToldAndStopsBondsWhereAsked) {
  for (const std::string crack : {"cut1", "cut2", "cut3", "diag1"}) {
    const std::string line = "load " + hairlines + crack + ".png --phases 0=void,1=matrix --json";
    const auto across = arenite(line), stopped = arenite(line + " --stop-at-voids");
    EXPECT_EQ(stopped.status, 3) << crack;
    EXPECT_EQ(Json::parse(stopped.out)["load"]["ending"], "severed") << crack;
    const Json j = Json::parse(across.out);
    if (crack == "cut3") continue;  // as wide as the horizon: no bond reaches across
    EXPECT_EQ(across.status, 0) << across.err;
    EXPECT_GE(j["load"]["bonds_across_voids"], 100) << crack;
    ASSERT_TRUE(j.contains("notes")) << crack;
    EXPECT_NE(j["notes"][0].get<std::string>().find("--stop-at-voids"), std::string::npos) << crack;
  }
}

TEST(Load, TellsWhatTheStrengthHangsOn) {
  const TemporaryFolder folder;
  const std::string map =
      picture(folder / "plate.h5", 24, 24, "x < 12, 1, 2") + " --phases 1=matrix,2=particle --dx '1 mm'";
  const std::string line = "load " + map + " --failure --json --max-strain 1e-2 ";
  const Json hangs = Json::parse(arenite(line).out),
             own = Json::parse(arenite(line + "--strength 'matrix=0.5 MPa'").out);
  EXPECT_EQ(hangs["failure"]["governed_by"]["matrix"], "toughness");
  ASSERT_TRUE(hangs.contains("notes"));
  EXPECT_NE(hangs["notes"][0].get<std::string>().find("spacing to the power -1/2"), std::string::npos);
  EXPECT_EQ(own["failure"]["governed_by"]["matrix"], "strength");
  EXPECT_NEAR(own["failure"]["critical_stretch"]["matrix"].get<double>(), 0.5e6 / 1e9, 1e-12);
  EXPECT_NE(own["notes"][0].get<std::string>().find("where stress concentrates"), std::string::npos);
}

TEST(Load, MapOfARecipeIsRunSweptAndNamedByItsKeys) {
  const TemporaryFolder folder;
  layers(folder / "map.h5");
  const auto write = [&](const std::string& name, const std::string& map, const std::string& end = {}) {
    std::ofstream(folder / name) << "[map]\nfile = \"map.h5\"\nphases = \"1=particle,2=matrix\"\n"
                                 << map << "[[loads]]\nname = \"tension\"\n"
                                 << end;
    return (folder / name).string();
  };
  const std::string out = " --quiet --out " + (folder / "out").string();
  const auto files = [&] {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder / "out"))
      if (entry.path().extension() == ".h5") names.insert(entry.path().filename().string());
    return names;
  };
  ASSERT_EQ(arenite("run " + write("a.toml", "dx = \"25 um\"\n") + out).status, 0);
  const auto first = files();
  EXPECT_EQ(first.size(), 2u) << "the sample of the map and its load";
  EXPECT_EQ(arenite("run " + write("b.toml", "dx = \"0.025 mm\"\nsmoothing = 1\n") + out).status, 0);
  EXPECT_EQ(files(), first) << "the same length, and a default";
  const auto shown = arenite("show --json " + (folder / "out").string());
  const auto loaded =
      arenite("load " + (folder / "map.h5").string() + " --phases 1=particle,2=matrix --dx 25um --json");
  EXPECT_EQ(Json::parse(shown.out)["modulus_Pa"], Json::parse(loaded.out)["modulus_Pa"]);
  const std::string study = write("s.toml", "", "[sweep.grid]\n\"map.crop\" = [\"0,0,40,40\", \"0,0,60,60\"]\n");
  const auto swept = arenite("study run " + study + " --quiet --out " + (folder / "study").string());
  EXPECT_EQ(swept.status, 0) << swept.err;
  EXPECT_TRUE(test::contains(swept.out, "2 runs: 2 done")) << swept.out;
  const auto mixed = arenite("check " + write("c.toml", "", "[container]\nwidth = \"1 mm\"\n"));
  EXPECT_EQ(mixed.status, 2);
  EXPECT_TRUE(test::contains(mixed.err, "only valid with no [map]")) << mixed.err;
}

TEST(Load, OfGrainsThatTouchTellsTheOptionThatPartsThemAndPrintsTheNumbersOfTheSample) {
  const TemporaryFolder folder;
  const std::string disks =
      picture(folder / "disks.h5", 120, 60, "((x % 20) - 9.5)**2 + ((y % 20) - 9.5)**2 < 104, 1, 2");
  const std::string line = "load " + disks + " --phases 1=particle,2=matrix";
  const auto as_one = arenite(line);
  ASSERT_EQ(as_one.status, 0) << as_one.err;
  EXPECT_TRUE(test::contains(as_one.err, "1 grains, 18 where they are cut at their necks by `--labels watershed`"))
      << as_one.err;
  EXPECT_LT(std::ranges::count(as_one.out, '\n'), 40) << as_one.out;
  const auto parted = arenite(line + " --labels watershed");
  EXPECT_FALSE(test::contains(parted.err, "watershed")) << parted.err;
  const auto apart = picture(folder / "apart.h5", 120, 60, "((x % 20) - 9.5)**2 + ((y % 20) - 9.5)**2 < 64, 1, 2");
  EXPECT_FALSE(test::contains(arenite("load " + apart + " --phases 1=particle,2=matrix").err, "watershed"));
}

TEST(Load, OptionWithoutEffectIsTold) {
  const TemporaryFolder folder;
  const auto loaded = arenite("load " + layers(folder / "map.h5") + " --phases 1=particle,2=matrix --max-strain 0.01");
  EXPECT_EQ(loaded.status, 0);
  EXPECT_TRUE(test::contains(loaded.err, "--max-strain: only has an effect with failure = true")) << loaded.err;
}

TEST(Load, SlipsAreOneSentenceEach) {
  const TemporaryFolder folder;
  const std::string map = layers(folder / "map.h5"), thin = picture(folder / "thin.h5", 4, 4, "x < 2, 1, 2");
  const std::string three = picture(folder / "three.h5", 40, 40, "x < 20, y // 20, 2");
  const std::string of_one = picture(folder / "one.h5", 40, 40, "x < 90, 0, 1");
  for (const auto& [arguments, words] : std::vector<std::pair<std::string, std::string>>{
           {three, "--phases"},
           {map + " --phases 1=particle", "2"},
           {map + " --phases 1=particle,2=glue", "glue"},
           {of_one + " --phases 0=void", "one"},
           {thin + " --phases 1=particle,2=matrix", "7"},
           {map + " --phases 1=particle,2=matrix --stiffness 'matrix=-1 GPa'", "above 0"},
           {map + " --phases 1=particle,2=matrix --stiffness 'matrix=1 kN'", "a pressure"},
           {map + " --phases 1=particle,2=matrix --stiffness soft", "not of the form"},
           {map + " --phases 1=particle,2=matrix --failure", "--dx"},
           {map + " --phases 1=particle,2=matrix --loading shear --lower sliding", "carries no shear"},
           {map + " --phases 1=particle,2=matrix --strain -1", "strain"},
           {map + " --phases 1=particle,2=matrix --crop 50,50,20,20", "crop"},
           {map + " --phases 1=particle,2=matrix --dx '0 um'", "above 0"},
           {map + " --phases 1=particle,2=matrix --clamp-rows -1", "--clamp-rows"},
           {map + " --phases 1=particle,2=matrix --clamp-rows 2147483647", "--clamp-rows"},
           {map + " --phases 1=particle,2=matrix --clamp-rows 30", "30 rows"},
           {map + " --phases 1=particle,2=matrix --strain nan", "--strain"},
           {map + " --phases 1=particle,2=matrix --dx '1 mm' --failure --strength 'matrix=0 MPa'", "above 0"},
           {(folder / "none.png").string(), "none.png"}}) {
    const auto refused = arenite("load " + arguments + " --out " + (folder / "out").string());
    EXPECT_EQ(refused.status, 2) << arguments << refused.out;
    EXPECT_NE(refused.err.find(words), std::string::npos) << arguments << "\n" << refused.err;
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
    EXPECT_FALSE(fs::exists(folder / "out")) << arguments;
  }
}

}  // namespace
