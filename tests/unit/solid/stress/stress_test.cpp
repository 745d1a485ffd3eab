#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/random.hpp"
#include "samples.hpp"
#include "solid/stress/grains.hpp"
#include "solid/stress/stress.hpp"
#include "support/numbers_of.hpp"

namespace arenite::stress {
namespace {

using test::error_of;
using test::list_of;
using test::value_of;

const Numbers& component(const Statistics& s) { return s.numbers["sigma_yy"]; }
const Numbers& set(const Statistics& s, const char* name) { return component(s)["sets"][name]; }

StressField noisy(const PhaseMap& map, std::uint64_t seed = 1) {
  RandomStream random(seed, Purpose::test);
  return pulled(map, [&](int x, int) { return 2 + 0.002 * x - 0.5 * std::log(1 - random.uniform()); });
}

/// The rules of the options, one node at a time.
bool counts(const PhaseMap& map, const StressOptions& options, int x, int y) {
  const std::size_t i = map.index(x, y);
  if (map.phase[i] == Phase::empty || y < options.clamp_rows || y >= map.height - options.clamp_rows) return false;
  if (!options.leave_out_surface) return true;
  for (int v = -1; v <= 1; ++v)
    for (int u = -1; u <= 1; ++u) {
      if (x + u < 0 || x + u >= map.width || y + v < 0 || y + v >= map.height) continue;
      const std::size_t j = map.index(x + u, y + v);
      if (map.phase[j] != map.phase[i] || map.grain[j] != map.grain[i]) return false;
    }
  return true;
}

TEST(NodeStress, OptionsLeaveOutWhatABruteSearchDoes) {
  const PhaseMap map = disks(96, 16);  // grains touch
  const StressField field = noisy(map);
  for (const int rows : {0, 4, 9})
    for (const bool surface : {false, true}) {
      StressOptions options;
      options.clamp_rows = rows;
      options.leave_out_surface = surface;
      const Statistics s = measure(map, field, options);
      double n[5] = {}, sum[5] = {};
      const char* names[5] = {"all", "particle", "large", "small", "matrix"};
      for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x) {
          if (!counts(map, options, x, y)) continue;
          const std::size_t i = map.index(x, y);
          const bool particle = map.phase[i] == Phase::particle;
          const bool large = particle && map.grain_class[static_cast<std::size_t>(map.grain[i])] == GrainClass::large;
          const bool in[5] = {true, particle, large, particle && !large, !particle};
          for (int k = 0; k < 5; ++k) n[k] += in[k], sum[k] += in[k] ? field.yy[i] : 0;
        }
      for (int k = 0; k < 5; ++k) {
        EXPECT_EQ(value_of(set(s, names[k]), "count"), n[k]) << names[k];
        EXPECT_NEAR(value_of(set(s, names[k]), "mean_Pa"), sum[k] / n[k], 1e-12) << names[k];
        EXPECT_NEAR(value_of(set(s, names[k]), "mean_over_sample_mean"), sum[k] / n[k] / (sum[0] / n[0]), 1e-12)
            << names[k];
      }
    }
}

TEST(NodeStress, MomentsAndQuantilesAreThoseOfTheLaw) {
  PhaseMap map = make_phase_map(240, 240, 1);
  for (auto& p : map.phase) p = Phase::matrix;
  RandomStream random(3, Purpose::test);
  const StressField field = pulled(map, [&](int, int) { return -7 * std::log(1 - random.uniform()); });
  const Statistics s = measure(map, field);
  const Numbers& d = set(s, "matrix");
  const double n = value_of(d, "count");
  EXPECT_NEAR(value_of(d, "mean_Pa"), 7, 4 * error_of(d, "mean_Pa"));
  EXPECT_NEAR(error_of(d, "mean_Pa"), 7 / std::sqrt(n), 0.35 * error_of(d, "mean_Pa"));
  EXPECT_NEAR(value_of(d, "variance"), 1, 4 * error_of(d, "variance"));
  EXPECT_NEAR(value_of(d, "skewness"), 2, 4 * error_of(d, "skewness"));
  EXPECT_NEAR(value_of(d, "excess_kurtosis"), 6, 4 * error_of(d, "excess_kurtosis"));
  EXPECT_NEAR(value_of(d, "fraction_above_own_mean"), std::exp(-1), 4 * error_of(d, "fraction_above_own_mean"));
  EXPECT_NEAR(value_of(d, "quantiles/50 %"), std::log(2), 4 * error_of(d, "quantiles/50 %"));
  EXPECT_NEAR(value_of(d, "quantiles/99.9 %"), std::log(1000), 4 * error_of(d, "quantiles/99.9 %"));
  EXPECT_NEAR(value_of(d, "tail/slope"), 1, 4 * error_of(d, "tail/slope"));
  EXPECT_LT(error_of(d, "tail/slope"), 0.1);
}

TEST(NodeStress, OneSpotTellsNoErrorOfTheQuantileThatItMakes) {
  PhaseMap map = make_phase_map(240, 240, 1);
  for (auto& p : map.phase) p = Phase::matrix;
  RandomStream random(3, Purpose::test);
  const Statistics s = measure(map, pulled(map, [&](int x, int y) {
                                 const double usual = -7 * std::log(1 - random.uniform());
                                 return x >= 100 && x < 108 && y >= 50 && y < 58 ? usual + 700 : usual;
                               }));
  const Numbers& d = set(s, "matrix");
  EXPECT_GT(value_of(d, "quantiles/99.9 %"), 50);
  EXPECT_FALSE(std::isfinite(error_of(d, "quantiles/99.9 %"))) << "another sample might have two spots, or none";
  EXPECT_TRUE(std::isfinite(error_of(d, "quantiles/99 %")));
  EXPECT_TRUE(std::isfinite(error_of(d, "quantiles/1 %")));
}

TEST(NodeStress, TwoHalvesOfOneStressEach) {
  PhaseMap map = make_phase_map(60, 60, 1);
  map.grain_class = {GrainClass::none};
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 60; ++x) {
      map.phase[map.index(x, y)] = x < 30 ? Phase::particle : Phase::matrix;
      map.grain[map.index(x, y)] = x < 30 ? 0 : -1;
    }
  const Statistics s = measure(map, pulled(map, [](int x, int) { return x < 30 ? 3.0 : 1.0; }));
  EXPECT_NEAR(value_of(set(s, "particle"), "mean_over_sample_mean"), 1.5, 1e-12);
  EXPECT_NEAR(value_of(set(s, "matrix"), "mean_over_sample_mean"), 0.5, 1e-12);
  EXPECT_NEAR(value_of(set(s, "all"), "variance"), 0.25, 1e-12);
  EXPECT_NEAR(value_of(set(s, "all"), "skewness"), 0, 1e-9);
  EXPECT_NEAR(value_of(set(s, "all"), "excess_kurtosis"), -2, 1e-9);
  EXPECT_EQ(value_of(set(s, "all"), "fraction_above_own_mean"), 0.5);
  EXPECT_EQ(value_of(set(s, "matrix"), "fraction_above_sample_mean"), 0);
  EXPECT_FALSE(component(s)["sets"].contains("large"));  // the map has no classes
  EXPECT_EQ(value_of(set(s, "matrix"), "variance"), 0);
  EXPECT_FALSE(std::isfinite(value_of(set(s, "matrix"), "skewness")));
}

TEST(NodeStress, UniformFieldHasAMeanAndNoDistribution) {
  const PhaseMap map = disks();
  const Statistics s = measure(map, pulled(map, [](int, int) { return 0.1; }));
  EXPECT_NEAR(value_of(set(s, "all"), "mean_Pa"), 0.1, 1e-15);
  EXPECT_EQ(value_of(set(s, "all"), "variance"), 0);
  EXPECT_EQ(value_of(set(s, "all"), "fraction_above_own_mean"), 0);
  EXPECT_FALSE(set(s, "all").contains("pdf"));
  EXPECT_NEAR(value_of(set(s, "large"), "quantiles/99.99 %"), 1, 1e-12);
  EXPECT_FALSE(s.notes.empty());
}

TEST(NodeStress, ScalingOrTurningTheStressChangesItsMeanOnly) {
  const PhaseMap map = disks();
  const StressField field = noisy(map);
  const nlohmann::json a = nlohmann::json::parse(to_json(numbers(measure(map, field), true)));
  for (const double factor : {4096.0, -2.0}) {  // powers of two, so that not a bit may differ
    StressField other = field;
    for (double& v : other.yy) v *= factor;
    const nlohmann::json b = nlohmann::json::parse(to_json(numbers(measure(map, other), true)));
    for (const char* name : {"all", "large", "small", "matrix"}) {
      nlohmann::json p = a["sigma_yy"]["sets"][name], q = b["sigma_yy"]["sets"][name];
      EXPECT_EQ(q["mean_Pa"]["value"], p["mean_Pa"]["value"].get<double>() * factor);
      p.erase("mean_Pa");
      q.erase("mean_Pa");
      EXPECT_EQ(p, q) << name << " times " << factor;
    }
  }
}

TEST(NodeStress, BothNormalisationsAreOneCurve) {
  const PhaseMap map = disks();
  const Statistics s = measure(map, noisy(map));
  const Numbers& d = set(s, "large");
  const auto x = list_of(d, "pdf/x"), y = list_of(d, "pdf/y"), own_x = list_of(d, "own_pdf/x"),
             own_y = list_of(d, "own_pdf/y");
  ASSERT_GT(x.size(), 5u);
  ASSERT_EQ(x.size(), own_x.size());
  for (std::size_t k = 0; k < x.size(); ++k) {
    EXPECT_NEAR(x[k], own_x[k] * value_of(d, "mean_over_sample_mean"), 1e-12);
    EXPECT_NEAR(y[k] * value_of(d, "mean_over_sample_mean"), own_y[k], 1e-12);
  }
}

TEST(NodeStress, MeanOverTheAreaCountsTheVoid) {
  const PhaseMap map = disks();
  const StressField field = noisy(map);
  StressOptions options;
  options.clamp_rows = 0;
  const Statistics s = measure(map, field, options);
  const double share = value_of(s.numbers, "nodes") / static_cast<double>(map.size());
  const Numbers& c = component(s);
  EXPECT_LT(share, 1);
  EXPECT_NEAR(value_of(c, "mean_over_area_Pa"), value_of(c, "mean_over_nodes_Pa") * share, 1e-12);
  EXPECT_EQ(value_of(c, "sample_mean_Pa"), value_of(c, "mean_over_nodes_Pa"));
  options.mean_over_area = true;
  const Statistics over_area = measure(map, field, options);
  EXPECT_NEAR(value_of(set(over_area, "large"), "mean_over_sample_mean") * share,
              value_of(set(s, "large"), "mean_over_sample_mean"), 1e-12);
  EXPECT_NEAR(value_of(set(over_area, "large"), "tail/slope"), value_of(set(s, "large"), "tail/slope"), 1e-12);
}

TEST(NodeStress, ErrorsAreTheScatterOfSamplesEvenWhereNeighboursAreAlike) {
  PhaseMap map = make_phase_map(96, 96, 1);
  for (auto& p : map.phase) p = Phase::matrix;
  double squares = 0, error = 0, naive = 0;
  const int trials = 60;
  for (int seed = 0; seed < trials; ++seed) {
    RandomStream random(static_cast<std::uint64_t>(seed), Purpose::test);
    std::vector<double> patch(144);  // of 8 x 8 nodes
    for (double& v : patch) v = 1 + 0.3 * random.normal();
    StressOptions options;
    options.clamp_rows = 0;
    const Statistics s = measure(
        map, pulled(map, [&](int x, int y) { return patch[static_cast<std::size_t>(x / 8 + 12 * (y / 8))]; }), options);
    const Numbers& d = set(s, "all");
    squares += (value_of(d, "mean_Pa") - 1) * (value_of(d, "mean_Pa") - 1) / trials;
    error += error_of(d, "mean_Pa") / trials;
    naive += std::sqrt(value_of(d, "own_variance") / value_of(d, "count")) / trials;
  }
  EXPECT_NEAR(error, std::sqrt(squares), 0.25 * error);
  EXPECT_GT(error, 6 * naive);
}

TEST(NodeStress, StressWithoutAMeanIsGivenOverItsRootMeanSquare) {
  const PhaseMap map = disks();
  StressField field = noisy(map);
  RandomStream random(5, Purpose::test);
  for (double& v : field.xy) v = random.normal();
  StressOptions options;
  options.components = {Component::xy, Component::hydrostatic};
  const Statistics s = measure(map, field, options);
  EXPECT_EQ(s.numbers["sigma_xy"]["normalised_by"], "root mean square");
  EXPECT_NEAR(value_of(s.numbers, "sigma_xy/sets/all/variance"), 1, 0.05);
  EXPECT_FALSE(s.numbers["sigma_xy"]["sets"]["all"].contains("tail"));
  EXPECT_EQ(s.numbers["sigma_hyd"]["normalised_by"], "mean");
  EXPECT_NEAR(value_of(s.numbers, "sigma_hyd/sample_mean_Pa"),
              0.5 * value_of(measure(map, field).numbers, "sigma_yy/sample_mean_Pa"), 1e-12);
  EXPECT_EQ(to_json(numbers(s, true)).find("nan"), std::string::npos);
}

TEST(NodeStress, UnloadedPartsAreCountedAndLeftOutOnDemand) {
  const PhaseMap map = disks();
  StressField field = noisy(map);
  std::size_t idle = 0;
  for (int y = 40; y < 50; ++y)
    for (int x = 40; x < 50; ++x) {
      idle += map.phase[map.index(x, y)] != Phase::empty;
      field.yy[map.index(x, y)] = 0;
    }
  StressOptions options;
  const Statistics with = measure(map, field, options);
  options.leave_out_unloaded = true;
  const Statistics without = measure(map, field, options);
  EXPECT_EQ(with.numbers["unloaded_nodes"], idle);
  EXPECT_EQ(value_of(with.numbers, "nodes"), value_of(without.numbers, "nodes") + static_cast<double>(idle));
}

std::string refusal(const PhaseMap& map, const StressField& field, const StressOptions& options = {}) {
  try {
    measure(map, field, options);
  } catch (const InputError& error) { return error.what(); }
  return "";
}

TEST(NodeStress, BadInputIsNamed) {
  const PhaseMap map = disks();
  const StressField field = noisy(map);
  EXPECT_NE(refusal(disks(72), field).find("96 x 96 nodes and the phase map 72 x 72"), std::string::npos);
  EXPECT_NE(refusal(map, no_stress(map)).find("sigma_yy is zero in every node"), std::string::npos);
  const PhaseMap empty = make_phase_map(20, 20, 1);
  EXPECT_NE(refusal(empty, no_stress(empty)).find("no node is left"), std::string::npos);
  StressField bad = field;
  bad.xy[17] = std::nan("");
  EXPECT_NE(refusal(map, bad).find("not a finite number"), std::string::npos);
  StressOptions options;
  options.blocks = 0;
  EXPECT_NE(refusal(map, field, options).find("blocks"), std::string::npos);
  options.blocks = 4;
  for (const int rows : {48, std::numeric_limits<int>::max()}) {
    options.clamp_rows = rows;
    EXPECT_NE(refusal(map, field, options).find(std::to_string(rows) + " rows"), std::string::npos);
  }
  for (const int rows : {-1, std::numeric_limits<int>::min()}) {
    options.clamp_rows = rows;
    EXPECT_NE(refusal(map, field, options).find("0 or more"), std::string::npos);
  }
}

TEST(NodeStress, JsonHoldsNoUnknownNumberAndTheTextNamesEverySet) {
  const PhaseMap map = disks();
  StressOptions options;
  options.components = {Component::yy, Component::xx, Component::xy, Component::hydrostatic};
  StressField field = noisy(map);
  field.xx = field.yy;
  field.xy = field.yy;
  const Statistics s = measure(map, field, options);
  const std::string json = to_json(numbers(s, true));
  EXPECT_EQ(json, to_json(numbers(measure(map, field, options), true)));
  const auto parsed = nlohmann::json::parse(json);
  EXPECT_TRUE(parsed["sigma_hyd"]["sets"]["matrix"].contains("own_pdf"));
  EXPECT_FALSE(nlohmann::json::parse(to_json(numbers(s)))["sigma_hyd"]["sets"]["matrix"].contains("own_pdf"));
  for (const char* name : {"large", "small", "matrix", "particle"}) EXPECT_NE(to_text(s).find(name), std::string::npos);
}

}  // namespace
}  // namespace arenite::stress
