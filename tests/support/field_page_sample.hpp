#pragma once
#include <array>
#include <string>
#include <utility>

#include "model/result.hpp"
#include "report/page.hpp"
#include "solid/grid/map_numbers.hpp"
#include "solid/peridynamics/damage.hpp"
#include "solid/peridynamics/load.hpp"
#include "solid/stress/grains.hpp"
#include "solid/stress/stress.hpp"
#include "support/cemented_sample.hpp"
#include "workflow/field_numbers.hpp"

namespace arenite::test {

/// A cemented sample, its stresses under tension, and its test to failure, as they might come from the store.
struct FieldPageSample {
  std::array<FieldResult, 3> results;
  FieldResult &cement = results[0], &load = results[1], &pull = results[2];
  report::PageData data;

  explicit FieldPageSample(const CementedSample& sample = {192, 2.5, 1.6, 0.5, 0.075, 0.86, 3}, int events = 40) {
    cement.name = "cement";
    cement.outcome = "Cemented by bridges.";
    cement.map = cemented_sample(sample);
    cement.provenance = {"0.1.0", "cement", "00112233445566aa", "title = \"<cemented> sample\"\n", 3,
                         "",      {},       "<cemented> sample"};
    cement.numbers = grid::map_numbers(cement.map, {}, 0.1 * cement.map.width * cement.map.dx);
    load = pull = cement;
    stretch();
    break_apart(events);
    data.title = "Cemented <packing> in tension";
    data.fields = results;
  }

  FieldPageSample(const FieldPageSample&) = delete;
  FieldPageSample& operator=(const FieldPageSample&) = delete;

 private:
  void stretch() {
    peridynamics::LoadOptions options;
    options.stiffness = {1e9, 1e9, 4e9};
    auto [report, field] = peridynamics::load(load.map, options);
    load.name = "tension";
    load.outcome = report.sentence;
    load.provenance.stage = "tension";
    load.provenance.input_hash = "00112233445566bb";
    load.field = std::move(field);
    load.convergence.columns = {{"iteration", "1", {}}, {"residual", "1", report.history}};
    for (std::size_t k = 0; k < report.history.size(); ++k)
      load.convergence.columns[0].values.push_back(static_cast<double>(k));
    workflow::add_load(load.numbers, {}, report, {});
    load.numbers["stress"] = stress::numbers(stress::measure(load.map, load.field, {}));
  }

  void break_apart(int events) {
    peridynamics::DamageOptions options;
    options.stiffness = {1e9, 1e9, 4e9};
    options.toughness = {2e4, 2e4, 7e4};
    options.max_events = events;
    const auto result = peridynamics::load_to_failure(pull.map, options);
    workflow::add_failure<2>(pull.numbers, workflow::as_asked({}), {}, result, pull.map.dx);
    pull.name = "failure";
    pull.outcome = result.sentence;
    pull.provenance.stage = "failure";
    pull.provenance.input_hash = "00112233445566cc";
    pull.field = load.field;
    pull.curve.columns = {{"strain", "1", {}},    {"stress", "Pa", {}},    {"work", "J/m", {}},
                          {"elastic", "J/m", {}}, {"released", "J/m", {}}, {"broken", "1", {}}};
    for (const auto& state : result.curve) {
      const double row[6] = {state.strain,  state.stress,   state.work,
                             state.elastic, state.released, static_cast<double>(state.broken)};
      for (std::size_t c = 0; c < 6; ++c) pull.curve.columns[c].values.push_back(row[c]);
    }
    const double dx = pull.map.dx;
    for (const auto& bond : result.broken) {
      const auto& step = peridynamics::half_bonds[bond.direction];
      pull.cracks.push_back({static_cast<float>((bond.x + 0.5 * (1 + step.x)) * dx),
                             static_cast<float>((bond.y + 0.5 * (1 + step.y)) * dx), bond.type, bond.strain});
    }
  }
};

}  // namespace arenite::test
