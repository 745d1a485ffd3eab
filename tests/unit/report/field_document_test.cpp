#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "report/page_document.hpp"
#include "support/field_page_sample.hpp"

using namespace arenite;
using Json = nlohmann::json;

namespace {

const test::FieldPageSample& sample() {
  static const test::FieldPageSample made({96, 2, 1.6, 0.5, 0.075, 0.86, 3}, 6);
  return made;
}

}  // namespace

TEST(FieldDocument, HoldsAMapOnceForAllResultsOnIt) {
  const Json document = Json::parse(report::page_document(sample().data).json);
  EXPECT_EQ(document["maps"].size(), 1u);
  ASSERT_EQ(document["fields"].size(), 3u);
  for (const Json& field : document["fields"]) EXPECT_EQ(field["map"], 0);
}

TEST(FieldDocument, HoldsStressesOnlyWhereTheSampleWasLoaded) {
  const Json document = Json::parse(report::page_document(sample().data).json);
  EXPECT_TRUE(document["fields"][0]["components"].empty());
  for (const char* name : {"xx", "yy", "xy", "ux", "uy"}) EXPECT_EQ(document["fields"][1]["components"][name]["residual"]["n"], 96 * 96) << name;
}

TEST(FieldDocument, GivesTheMeanOverWhatIsNotVoid) {
  const Json document = Json::parse(report::page_document(sample().data).json);
  const auto& load = sample().load;
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t k = 0; k < load.map.size(); ++k)
    if (load.map.phase[k] != Phase::empty) sum += load.field.yy[k], ++count;
  EXPECT_NEAR(document["fields"][1]["components"]["yy"]["mean"], sum / static_cast<double>(count), 1e-9 * sum);
}

TEST(FieldDocument, MeasuresTheDensitiesUnlessTheyAreGiven) {
  const Json document = Json::parse(report::page_document(sample().data).json);
  EXPECT_TRUE(document["fields"][0]["statistics"].empty());
  EXPECT_TRUE(document["fields"][1]["statistics"]["sigma_yy"]["sets"]["all"].contains("pdf"));
  report::PageData given = sample().data;
  given.fields = {{&sample().load, R"({"sigma_yy": 3})"}};
  EXPECT_EQ(Json::parse(report::page_document(given).json)["fields"][0]["statistics"]["sigma_yy"], 3);
}

TEST(FieldDocument, OfASampleWithoutAnyStressSaysWhyNothingWasMeasured) {
  FieldResult severed = sample().load;
  for (auto* values : {&severed.field.xx, &severed.field.yy, &severed.field.xy}) values->assign(values->size(), 0);
  const Json document = Json::parse(report::page_document({"severed", {}, {}, {{&severed, {}}}}).json);
  EXPECT_EQ(document["fields"][0]["statistics"]["notes"].size(), 1u);
}

TEST(FieldDocument, HoldsVoidsAndPoresOfTheMap) {
  const Json document = Json::parse(report::page_document(sample().data).json);
  for (const char* kind : {"voids", "pores"}) {
    const Json& cavities = document["maps"][0]["cavities"][kind];
    EXPECT_EQ(cavities["label"]["n"], 96 * 96);
    EXPECT_GT(cavities["nodes"]["n"], 0);
    EXPECT_GT(cavities["volumes"]["mean"]["value"], 0);
  }
}

TEST(FieldDocument, HoldsCracksAndTheCurveOfAPull) {
  const Json document = Json::parse(report::page_document(sample().data).json);
  const Json& pull = document["fields"][2];
  EXPECT_EQ(pull["cracks"]["count"], sample().pull.cracks.size());
  EXPECT_EQ(pull["curve"].size(), 6u);
  EXPECT_FALSE(document["fields"][1].contains("cracks"));
}

TEST(FieldDocument, StandsBesideAPackingOrWithoutOne) {
  const Json document = Json::parse(report::page_document(sample().data).json);
  EXPECT_TRUE(document["frames"].empty());
  EXPECT_FALSE(Json::parse(report::page_document({"nothing", {}, {}}).json).contains("fields"));
}
