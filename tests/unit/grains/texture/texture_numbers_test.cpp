#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "grains/texture/texture.hpp"
#include "unit/grains/texture/packings.hpp"

namespace arenite::texture {
namespace {

using Json = nlohmann::json;

TEST(TextureJson, GivesEveryPromisedStatisticAsValueAndError) {
  const Json j = Json::parse(to_json(numbers(measure(test::random_network(3, 400)))));
  for (const Json& statistic :
       {j["solid_fraction"], j["coordination"]["all"], j["coordination"]["A-B"], j["coordination"]["A-ANY"],
        j["fabric"]["a_c"], j["fabric"]["theta_c_deg"], j["fabric"]["phi"], j["force"]["mean_N"],
        j["force"]["strong_share"], j["force"]["beta"], j["sigma_norm"]["P0"], j["sigma_norm"]["beta"],
        j["sigma_norm"]["by_material"]["A"]["P0"], j["sigma_norm"]["by_material"]["B"]["beta"]}) {
    EXPECT_FALSE(statistic["value"].is_null()) << statistic;
    EXPECT_FALSE(statistic["error"].is_null()) << statistic;
  }
  EXPECT_EQ(j["force"]["beta_error"], j["force"]["beta"]["error"]);
  EXPECT_TRUE(j["stress"]["error"].is_null());  // unknown from one sample
  EXPECT_EQ(j["stress"]["value"].size(), 2u);
  EXPECT_EQ(j["stress"]["value"][0].size(), 2u);
  EXPECT_FALSE(j.contains("by_grain"));
}

TEST(TextureJson, LeavesOutWhatIsNotKnownAndSaysWhy) {
  Packing p = test::random_network(3);
  p.domain = {};
  p.domain.thickness = 0;
  const Json j = Json::parse(to_json(numbers(measure(p))));
  EXPECT_FALSE(j.contains("stress"));
  EXPECT_FALSE(j.contains("solid_fraction"));
  EXPECT_FALSE(j.contains("rev"));
  EXPECT_EQ(j["notes"].size(), 3u + (j["quality"]["median_imbalance"] > 0.1 ? 1 : 0));
}

TEST(TextureJson, TellsOfABoxWithoutAllOfItsWalls) {
  Packing p = test::random_network(3);
  const auto told = [&] {
    const auto notes = measure(p).notes;
    return std::ranges::count(notes,
                              "No wall stands on the side top: solid fraction, stress of the assembly and strains are "
                              "of a box up to its last place.");
  };
  EXPECT_EQ(told(), 0);
  p.domain.wall[top].present = false;
  EXPECT_EQ(told(), 1);
}

TEST(TextureJson, HasRowsForDrawingsWhenAsked) {
  const Packing p = test::random_network(3);
  const Json j = Json::parse(to_json(numbers(measure(p), true)));
  EXPECT_EQ(j["by_grain"]["sigma_Pa"].size(), p.grains.size());
  EXPECT_EQ(j["fabric"]["sectors"].size(), 18u);
  EXPECT_EQ(j["fabric"]["threshold"]["force"].size(), 41u);
  EXPECT_FALSE(j["force"]["cumulative"]["x"].empty());
}

TEST(TextureJson, SaysOfEveryNumberWhatItIs) {
  const Numbers all = numbers(measure(test::random_network(3, 400)));
  for (const auto& [name, number, meaning] : named_numbers(all)) {
    ASSERT_TRUE(meaning) << name;
    EXPECT_FALSE(meaning->sentence.empty()) << name;
    for (const char* unit : {"deg", "Pa", "N", "m"})
      EXPECT_TRUE(!name.ends_with("_" + std::string(unit)) || meaning->unit == unit) << name;
  }
}

TEST(TextureJson, OfAnEmptyPackingIsValid) {
  EXPECT_EQ(Json::parse(to_json(numbers(measure(Packing{}))))["grains"], 0);
}

}  // namespace
}  // namespace arenite::texture
