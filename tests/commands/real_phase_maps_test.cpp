#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/program.hpp"

namespace {
using namespace arenite;
using test::arenite;
using test::TemporaryFolder;
using Json = nlohmann::json;
namespace fs = std::filesystem;

const std::string electrode = ARENITE_SOURCE_DIR
    "/examples/30-electrode/electrode.tiff --phases 0=void,85=particle,170=matrix --labels watershed";
const std::string sandstone =
    ARENITE_SOURCE_DIR "/examples/31-sandstone/OffshoreMiocene_20_1_mask.png --phases 0=void,1=particle,2=matrix";

/// The numbers of a load that must be solved; its page must be there.
Json loaded(const std::string& what, const fs::path& out) {
  const auto ran = arenite("load " + what + " --stiffness 'matrix=1 GPa' --out " + out.string());
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_TRUE(fs::exists(out / "report.html"));
  return Json::parse(arenite("show --json " + out.string()).out);
}

void expect_sound(const Json& j) {
  EXPECT_EQ(j["load"]["ending"], "solved");
  EXPECT_LT(std::abs(j["load"]["reaction_balance_error"].get<double>()), 1e-6);
  const Json& share = j["phases"];
  EXPECT_GT(j["modulus_Pa"].get<double>(), 0);
  EXPECT_LT(j["modulus_Pa"].get<double>(), 1e9 * share["matrix"].get<double>() + 4e9 * share["particle"].get<double>());
}

TEST(RealPhaseMaps, SlicesOfAnElectrode) {
  const TemporaryFolder folder;
  for (const char* slice : {"0", "64", "128"}) {
    const Json j = loaded(electrode + " --slice " + slice + " --tolerance 1e-10", folder / slice);
    expect_sound(j);
    // Shares of the whole volume: 40.05, 14.96 and 44.99 %; a slice scatters about them.
    EXPECT_NEAR(j["phases"]["particle"].get<double>(), 0.4005, 0.04) << slice;
    EXPECT_NEAR(j["phases"]["matrix"].get<double>(), 0.1496, 0.03) << slice;
    EXPECT_GT(j["grains"]["all"].get<int>(), 60) << slice;
    EXPECT_GT(j["load"]["nodes"]["floating"].get<int>(), 0) << slice;
  }
}

TEST(RealPhaseMaps, PartOfASandstone) {
  const TemporaryFolder folder;
  for (const char* loading : {"tension", "shear"}) {
    const Json j =
        loaded(sandstone + " --crop 1900,700,400,400 --tolerance 1e-9 --loading " + loading, folder / loading);
    expect_sound(j);
    EXPECT_EQ(j["load"]["loading"], loading);
  }
  // Outlines part the grains, so connected pixels are one grain each.
  const auto exported =
      arenite("export " + (folder / "tension").string() + " --to csv --out " + (folder / "csv").string());
  EXPECT_EQ(exported.status, 0) << exported.err;
}

TEST(RealPhaseMaps, TheSizeOfAPixelThatAPictureStatesIsTold) {
  const std::string load = "load " ARENITE_SOURCE_DIR
                           "/tests/data/phase_maps/pixels-of-half-a-micrometre.png --phases "
                           "0=void,85=matrix,170=particle",
                    told = "the file states pixels of 0.5 um";
  EXPECT_NE(arenite(load).err.find(told), std::string::npos);
  EXPECT_NE(arenite(load + " --dx '10 um'").err.find(told), std::string::npos);  // which is another size
  EXPECT_EQ(arenite(load + " --dx '0.5 um'").err.find(told), std::string::npos);
  const auto crack = arenite(load + " --failure");
  EXPECT_EQ(crack.status, 2);
  EXPECT_NE(crack.err.find("a crack needs a length; " + told), std::string::npos) << crack.err;
}

}  // namespace
