#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "report/page_document.hpp"
#include "support/field_page_sample.hpp"
#include "workflow/field_stages.hpp"

using namespace arenite;
using Json = nlohmann::json;

namespace {

const test::FieldPageSample& field_sample() {
  static const test::FieldPageSample made({96, 2, 1.6, 0.5, 0.075, 0.86, 3}, 6);
  return made;
}

}  // namespace

TEST(FieldDocument, HoldsAMapOnceForAllResultsOnIt) {
  const Json document = Json::parse(report::page_document(field_sample().data).json);
  EXPECT_EQ(document["maps"].size(), 1u);
  ASSERT_EQ(document["fields"].size(), 3u);
  for (const Json& field : document["fields"]) EXPECT_EQ(field["map"], 0);
}

TEST(FieldDocument, HoldsStressesOnlyWhereTheSampleWasLoaded) {
  const Json document = Json::parse(report::page_document(field_sample().data).json);
  EXPECT_TRUE(document["fields"][0]["components"].empty());
  for (const char* name : {"sigma_xx", "sigma_yy", "sigma_xy", "ux", "uy"})
    EXPECT_EQ(document["fields"][1]["components"][name]["residual"]["n"], 96 * 96) << name;
}

TEST(FieldDocument, GivesTheMeanOverWhatIsNotVoid) {
  const Json document = Json::parse(report::page_document(field_sample().data).json);
  const auto& load = field_sample().load;
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t k = 0; k < load.map.size(); ++k)
    if (load.map.phase[k] != Phase::empty) sum += load.field.yy[k], ++count;
  EXPECT_NEAR(document["fields"][1]["components"]["sigma_yy"]["mean"], sum / static_cast<double>(count), 1e-9 * sum);
}

TEST(FieldDocument, MeasuresDensitiesAsTheLoadsStatisticsAsk) {
  const Json document = Json::parse(report::page_document(field_sample().data).json);
  EXPECT_TRUE(document["fields"][0]["statistics"].empty());
  FieldResult asked = field_sample().load;
  asked.numbers["stress"]["options"] = {{"clamp_rows", 8}, {"leave_out_surface", true}};
  const Json statistics =
      Json::parse(report::page_document({.title = "asked", .fields = {&asked, 1}}).json)["fields"][0]["statistics"];
  EXPECT_EQ(statistics["options"]["clamp_rows"], 8);
  EXPECT_LT(statistics["sigma_yy"]["sets"]["all"]["count"],
            document["fields"][1]["statistics"]["sigma_yy"]["sets"]["all"]["count"]);
  for (const char* component : {"sigma_yy", "sigma_xx", "sigma_xy", "sigma_hyd"})
    EXPECT_TRUE(statistics[component]["sets"]["all"].contains("pdf")) << component;
}

/// The numbers of `some` are all in `whole`, and equal there.
void expect_holds(const Json& whole, const Json& some, const std::string& path = "") {
  for (const auto& [name, value] : some.items()) {
    const std::string at = path + "/" + name;
    if (name == "notes") continue;
    ASSERT_TRUE(whole.contains(name)) << at;
    if (value.is_object()) expect_holds(whole[name], value, at);
    else EXPECT_EQ(whole[name], value) << at;
  }
}

TEST(FieldDocument, AgreesWithTheNumbersThatALoadIsStoredWith) {
  recipe::Load load;
  load.name = "tension";
  load.statistics.clamp_rows = 8;
  auto result = workflow::apply_load(load, field_sample().cement, {});
  ASSERT_TRUE(result);
  const auto field_now = [&] {
    return Json::parse(report::page_document({.title = "one", .fields = {&*result, 1}}).json)["fields"][0];
  };
  const Json field = field_now();
  Json numbers = field["numbers"]["stress"];
  ASSERT_GT(numbers["sigma_yy"]["sets"]["all"]["count"], 1000);
  numbers.erase("grains");  // the page has its own
  expect_holds(field["statistics"], numbers);
  result->numbers["stress"].erase("options");
  EXPECT_NE(field_now()["statistics"]["sigma_yy"]["sets"]["all"]["count"], numbers["sigma_yy"]["sets"]["all"]["count"]);
}

TEST(FieldDocument, OfASampleWithoutAnyStressSaysWhyNothingWasMeasured) {
  FieldResult severed = field_sample().load;
  for (auto* values : {&severed.field.xx, &severed.field.yy, &severed.field.xy}) values->assign(values->size(), 0);
  const Json document = Json::parse(report::page_document({.title = "severed", .fields = {&severed, 1}}).json);
  EXPECT_EQ(document["fields"][0]["statistics"]["notes"].size(), 1u);
}

TEST(FieldDocument, HoldsVoidsAndPoresOfTheMap) {
  const Json document = Json::parse(report::page_document(field_sample().data).json);
  for (const char* kind : {"voids", "pores"}) {
    const Json& cavities = document["maps"][0]["cavities"][kind];
    EXPECT_EQ(cavities["label"]["n"], 96 * 96);
    EXPECT_GT(cavities["nodes"]["n"], 0);
    EXPECT_GT(document["fields"][0]["numbers"][kind]["mean"]["value"], 0);
  }
}

TEST(FieldDocument, HoldsCracksAndTheCurveOfAPull) {
  const Json document = Json::parse(report::page_document(field_sample().data).json);
  const Json& pull = document["fields"][2];
  EXPECT_EQ(pull["cracks"]["count"], field_sample().pull.cracks.size());
  EXPECT_EQ(pull["curve"].size(), 6u);
  EXPECT_FALSE(document["fields"][1].contains("cracks"));
}

TEST(FieldDocument, SaysUnitsAndMeaningsAsTheyAreDeclared) {
  const Json load = Json::parse(report::page_document(field_sample().data).json)["fields"][1];
  EXPECT_EQ(load["components"]["sigma_yy"]["unit"], "Pa");
  EXPECT_EQ(load["components"]["ux"]["unit"], "m");
  EXPECT_EQ(load["meanings"]["modulus_Pa"], Json({"Pa", "Apparent modulus, mean stress over strain"}));
  EXPECT_EQ(load["meanings"]["stress.sigma_yy.sample_mean_Pa"][0], "Pa");
  EXPECT_FALSE(load["convergence"]["residual"].contains("unit"));
}

TEST(FieldDocument, StandsBesideAPackingOrWithoutOne) {
  const Json document = Json::parse(report::page_document(field_sample().data).json);
  EXPECT_TRUE(document["snapshots"].empty());
  EXPECT_FALSE(Json::parse(report::page_document({.title = "nothing"}).json).contains("fields"));
}

TEST(FieldDocument, TakesOverWhatTheRunMeasured) {
  recipe::Load load;
  load.name = "tension";
  workflow::KnownStatistics known;
  auto result = workflow::apply_load(load, field_sample().cement, {}, {}, &known.fields.emplace_back());
  ASSERT_TRUE(result && known.fields[0]);
  const auto statistics = [&](const workflow::KnownStatistics* measured) {
    return Json::parse(report::page_document({.title = "one", .fields = {&*result, 1}, .measured = measured})
                           .json)["fields"][0]["statistics"];
  };
  EXPECT_EQ(statistics(&known), statistics(nullptr));
  for (const char* component : {"sigma_xx", "sigma_xy", "sigma_hyd"}) {
    EXPECT_TRUE(statistics(&known).contains(component));
    EXPECT_FALSE(result->numbers["stress"].contains(component));
  }
  known.fields[0]->numbers["nodes"] = 1;  // which nobody would measure
  EXPECT_EQ(statistics(&known)["nodes"], 1);
}
