#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/formula.hpp"
#include "report/field_document.hpp"
#include "report/page_document.hpp"
#include "support/field_page_sample.hpp"
#include "workflow/apply_load.hpp"

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

TEST(FieldDocument, HasTheMeanThatTheStatisticsState) {
  const Json load = Json::parse(report::page_document(field_sample().data).json)["fields"][1];
  const double stored = field_sample().load.numbers["stress"]["sigma_yy"]["sample_mean_Pa"]["value"].get<double>();
  EXPECT_EQ(load["components"]["sigma_yy"]["mean"], stored);
  EXPECT_EQ(load["quantities"]["yy"]["mean"], stored);
}

TEST(FieldDocument, HasFractionsOfAllNodesHoweverFewThePageHas) {
  FieldResult fine;
  fine.map = make_phase_map(1200, 1201, 1e-5);
  for (int x = 0; x < 1200; ++x) fine.map.phase[fine.map.index(x, 0)] = Phase::matrix;  // which a page leaves out
  const Json map = Json::parse(report::page_document({.title = "fine", .fields = {&fine, 1}}).json)["maps"][0];
  EXPECT_GT(map["stride"], 1);
  EXPECT_DOUBLE_EQ(map["fractions"][1].get<double>(), 1.0 / 1201);
  EXPECT_EQ(map["fractions"].size(), 5u);
}

TEST(FieldDocument, SaysHowAStressIsToldAgainstTheMean) {
  const Json document = Json::parse(report::page_document(field_sample().data).json);
  const Json& load = document["fields"][1];
  const auto given = [](std::string_view name) { return std::vector<double>{name == "mean" ? 2.0 : 3.0}; };
  EXPECT_EQ(evaluated(load["relative"]["formula"].get<std::string>(), 1, given), std::vector<double>{1.5});
  // Pulled along y, the sample carries most along y; one that is not loaded carries nothing.
  EXPECT_EQ(load["scale"], load["components"]["sigma_yy"]["mean"]);
  EXPECT_EQ(document["fields"][0]["scale"], 1);
}

TEST(FieldDocument, BeginsWithTheComponentByWhichTheLoadActs) {
  recipe::Load load;
  load.name = "shear";
  load.loading = statics::Loading::shear;
  const auto sheared = workflow::apply_load(load, field_sample().cement, {});
  ASSERT_TRUE(sheared);
  const FieldResult both[] = {field_sample().load, *sheared};
  const Json fields = Json::parse(report::page_document({.title = "two", .fields = both}).json)["fields"];
  EXPECT_EQ(fields[0]["acts_by"], "yy");
  EXPECT_EQ(fields[1]["acts_by"], "xy");
}

TEST(FieldDocument, MeasuresDensitiesAsTheLoadsStatisticsAsk) {
  const Json document = Json::parse(report::page_document(field_sample().data).json);
  EXPECT_FALSE(document["fields"][0]["figures"].contains("stress-pdf"));
  std::vector<Json> components;
  for (const Json& drawing : document["fields"][1]["figures"]["stress-pdf"])
    if (drawing["for"]["norm"] == "sample") components.push_back(drawing["for"]["component"]);
  EXPECT_EQ(components, (std::vector<Json>{"yy", "xx", "xy", "hydrostatic"}));
  FieldResult asked = field_sample().load;
  const Numbers usual = report::densities_of(asked);
  asked.numbers["stress"]["options"] = {{"clamp_rows", 8}, {"leave_out_surface", true}};
  const Numbers statistics = report::densities_of(asked);
  EXPECT_EQ(statistics["options"]["clamp_rows"], 8);
  EXPECT_LT(statistics["sigma_yy"]["sets"]["all"]["count"].get<double>(),
            usual["sigma_yy"]["sets"]["all"]["count"].get<double>());
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
  const auto densities = [&] { return Json::parse(to_json(report::shortened(report::densities_of(*result)))); };
  Json numbers = Json::parse(
      report::page_document({.title = "one", .fields = {&*result, 1}}).json)["fields"][0]["numbers"]["stress"];
  ASSERT_GT(numbers["sigma_yy"]["sets"]["all"]["count"], 1000);
  numbers.erase("grains");  // the page has its own
  expect_holds(densities(), numbers);
  result->numbers["stress"].erase("options");
  EXPECT_NE(densities()["sigma_yy"]["sets"]["all"]["count"], numbers["sigma_yy"]["sets"]["all"]["count"]);
}

TEST(FieldDocument, OfASampleWithoutAnyStressSaysWhyNothingWasMeasured) {
  FieldResult severed = field_sample().load;
  for (auto* values : {&severed.field.xx, &severed.field.yy, &severed.field.xy}) values->assign(values->size(), 0);
  EXPECT_EQ(report::densities_of(severed)["notes"].size(), 1u);
  const Json document = Json::parse(report::page_document({.title = "severed", .fields = {&severed, 1}}).json);
  EXPECT_FALSE(document["fields"][0]["figures"].contains("stress-pdf"));
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
  EXPECT_FALSE(load["figures"]["convergence"][0]["panels"][0]["y"].contains("unit"));
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
  const auto figure = [&](const workflow::KnownStatistics* measured) {
    return Json::parse(report::page_document({.title = "one", .fields = {&*result, 1}, .measured = measured})
                           .json)["fields"][0]["figures"]["stress-pdf"];
  };
  const Json shown = figure(&known);
  EXPECT_EQ(shown, figure(nullptr));
  for (const auto& [component, name] :
       {std::pair{"xx", "sigma_xx"}, {"xy", "sigma_xy"}, {"hydrostatic", "sigma_hyd"}}) {
    EXPECT_TRUE(std::ranges::any_of(
        shown, [&, component = component](const Json& one) { return one["for"]["component"] == component; }));
    EXPECT_FALSE(result->numbers["stress"].contains(name));
  }
  known.fields[0]->numbers["sigma_yy"]["sets"]["all"]["variance"] = 123.0;  // which nobody would measure
  EXPECT_EQ(figure(&known)[0]["key"][0]["numbers"][0], Json({"var", "123.0", ""}));
}

TEST(FieldDocument, ExtremesOfAGrainAreThoseOfAllItsNodesWhicheverThePageShows) {
  PhaseMap map;
  map.width = map.height = 4;
  map.phase.assign(16, Phase::particle);
  map.grain.assign(16, 0);
  map.grain[15] = 1;
  map.grain_class.assign(3, GrainClass::none);
  StressField field{4, 4, 1, {}, {}, {}, std::vector<double>(16, -2.0), {}};
  field.xx = field.xy = field.yy;
  const report::Thinning shown(map, 4);
  ASSERT_EQ(shown.stride, 2);
  field.yy[0] = -9, field.yy[1] = 5, field.yy[15] = 3;
  for (const double value : shown.of(field.yy)) EXPECT_GT(value, -9);
  const stress::GrainExtremes extremes = stress::extremes_of(map, field);
  EXPECT_EQ(extremes.least[0], -9);
  EXPECT_EQ(extremes.most[0], 5);
  EXPECT_EQ(extremes.most[1], 3);
  EXPECT_TRUE(std::isnan(extremes.most[2]));
}

TEST(FieldDocument, GrainsHaveRadiiOfTheirAreaAndExtremesWhereTheyAreLoaded) {
  const Json document = Json::parse(report::page_document(field_sample().data).json);
  const Json &bare = document["fields"][0]["grains"], &loaded = document["fields"][1]["grains"];
  for (const char* name : {"radius", "yy_least", "yy_most"}) EXPECT_EQ(loaded[name]["n"], loaded["nodes"]["n"]) << name;
  EXPECT_TRUE(bare.contains("radius"));
  EXPECT_FALSE(bare.contains("yy_most"));
}
