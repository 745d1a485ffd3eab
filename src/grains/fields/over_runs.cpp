#include "grains/fields/over_runs.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "grains/fields/laboratory/curves_in_space.hpp"
#include "grains/fields/laboratory/test_numbers.hpp"
#include "grains/fields/silo.hpp"
#include "grains/fields/steady_state.hpp"
#include "statistics/numbers_text.hpp"

namespace arenite::fields {
namespace {

using statistics::Columns;
using statistics::Estimate;
using Values = std::vector<double>;

constexpr double all_but_nothing = 0.01;  // of the largest normal stress
constexpr std::size_t blocks_of_late = 10;

/// A column and what it is of a row.
struct ColumnOf {
  const char *name, *unit, *sentence;
  bool has_error = false;
};

/// Rows of estimates, in the order of the first.
Columns table_of(std::vector<std::vector<Estimate>> rows, std::initializer_list<ColumnOf> kinds) {
  std::ranges::stable_sort(rows, {}, [](const auto& row) { return row.front().value; });
  Columns table;
  std::size_t k = 0;
  for (const ColumnOf& kind : kinds) {
    Values error;
    if (kind.has_error) error = mapped(rows, [k](const auto& row) { return row[k].error; });
    table.put(kind.name, kind.unit, kind.sentence, mapped(rows, [k](const auto& row) { return row[k].value; }),
              std::move(error));
    table.list.back().tells_errors = kind.has_error;
    ++k;
  }
  return table;
}

/// Of numbers that may be unknown in some rows, which are left out.
SteadyState steady(const Values& values) {
  Values known;
  for (const double v : values)
    if (std::isfinite(v)) known.push_back(v);
  if (!known.empty()) return find_steady_state(known);
  SteadyState nothing;
  nothing.mean = {};
  return nothing;
}

Estimate as_estimate(const statistics::Measured& m) { return {m.value, m.error}; }

/// Rows of a test whose sides bear a ratio of stresses: shear and normal stress, or q and p, Pa.
struct StressedRows {
  Values shear, normal, solid_fraction, inertial_number;
};

std::optional<StressedRows> stressed(const Test& test) {
  auto of = loading_of(test);
  if (!of || of->normal.empty()) return {};
  return StressedRows{std::move(of->shear), std::move(of->normal), of->curves["solid_fraction"],
                      of->curves["inertial_number"]};
}

std::optional<StressedRows> stressed(const SphereResult* stage) {
  const auto of = curves_in_space(*stage, stage->asked.closes);
  const bool is_sheared = of && of->find("tau");
  if (!of || !of->find("inertial_number")) return {};
  return StressedRows{(*of)[is_sheared ? "tau" : "q"], (*of)[is_sheared ? "normal_stress" : "p"],
                      (*of)["solid_fraction"], (*of)["inertial_number"]};
}

Numbers found_of(const Test& test) { return test_of(test); }
Numbers found_of(const SphereResult* stage) { return test_of(*stage); }

const StageResult& stage_of(const Test& test) { return test.stage; }
const SphereResult& stage_of(const SphereResult* stage) { return *stage; }

const Asked& asked_of(const AnyTest& any) {
  return std::visit([](const auto& test) -> const Asked& { return stage_of(test).asked; }, any);
}
const Numbers& numbers_of(const AnyTest& any) {
  return std::visit([](const auto& test) -> const Numbers& { return stage_of(test).texture; }, any);
}
const std::string& name_of(const AnyTest& any) {
  return std::visit([](const auto& test) -> const std::string& { return stage_of(test).name; }, any);
}

StressedRows stressed_rows(const AnyTest& any) {
  auto of = std::visit([](const auto& test) { return stressed(test); }, any);
  if (!of)
    throw refusal("the stage {} has no stresses on its sides; give one that is sheared or compressed", name_of(any));
  return std::move(*of);
}

/// Shear and normal stress of rows that are loaded.
std::pair<Values, Values> loaded_rows(const Values& shear, const Values& normal) {
  const double least = normal.empty() ? 0 : all_but_nothing * *std::ranges::max_element(normal);
  std::pair<Values, Values> rows;
  for (std::size_t k = 0; k < normal.size(); ++k)
    if (normal[k] > least) rows.first.push_back(shear[k]), rows.second.push_back(normal[k]);
  return rows;
}

Values sizes_of_ratio(const Values& shear, const Values& normal) {
  Values ratio;
  for (std::size_t k = 0; k < shear.size(); ++k) ratio.push_back(std::abs(shear[k]) / normal[k]);
  return ratio;
}

double number_at(const Numbers& numbers, const std::string& path) {
  const Numbers* node = numbers.at_path(path);
  return node && node->is_number() ? node->get<double>() : statistics::unknown;
}

/// "value" and "error" of a stored number, or the number.
Estimate stored(const Numbers& numbers, const std::string& path) {
  const Numbers* node = numbers.at_path(path);
  if (node && node->is_tree()) return {number_at(*node, "/value"), number_at(*node, "/error")};
  return {number_at(numbers, path)};
}

/// What was found of a test in its critical state; nothing where it reached none.
struct Plateau {
  Estimate ratio, solid_fraction, inertial_number;
};
std::optional<Plateau> plateau_of(const AnyTest& any) {
  const Numbers numbers = std::visit([](const auto& test) { return found_of(test); }, any);
  for (const char* ratio : {"/critical_state/mu", "/critical_state/q_over_p"})
    if (numbers.at_path(ratio))
      return Plateau{stored(numbers, ratio), stored(numbers, "/critical_state/solid_fraction"),
                     stored(numbers, "/critical_state/inertial_number")};
  return {};
}

/// The critical state or, where none is reached, the second half.
std::vector<Estimate> critical_row(const AnyTest& test) {
  const StressedRows of = stressed_rows(test);
  const double friction = asked_of(test).friction;
  if (const auto plateau = plateau_of(test)) return {{friction}, plateau->ratio, plateau->solid_fraction, {1}};
  const auto [shear, normal] = loaded_rows(of.shear, of.normal);
  if (shear.size() < blocks_of_late)
    throw refusal("the stage {} has too few rows under load for a plateau; run it for longer", name_of(test));
  return {{friction},
          as_estimate(mean_of_blocks(about_ratio_of_means(shear, normal, shear.size() / 2), blocks_of_late)),
          as_estimate(late_mean(of.solid_fraction)),
          {0}};
}

std::vector<Estimate> rheology_row(const AnyTest& test) {
  const StressedRows of = stressed_rows(test);
  if (const auto plateau = plateau_of(test)) return {plateau->inertial_number, plateau->ratio, plateau->solid_fraction};
  return {as_estimate(steady(of.inertial_number).mean), steady_ratio(of.shear, of.normal),
          as_estimate(steady(of.solid_fraction).mean)};
}

/// The rows of stages that have stored the first of these numbers.
std::vector<std::vector<Estimate>> rows_of(const std::vector<AnyTest>& tests, const std::string& first,
                                           std::initializer_list<const char*> numbers) {
  std::vector<std::vector<Estimate>> rows;
  for (const AnyTest& test : tests)
    if (numbers_of(test).at_path(first))
      rows.push_back(mapped(numbers, [&](const char* path) { return stored(numbers_of(test), path); }));
  return rows;
}

}  // namespace

Estimate steady_ratio(const Values& all_shear, const Values& all_normal) {
  if (all_shear.size() != all_normal.size())
    throw refusal("there are {} shear and {} normal stresses; give as many", all_shear.size(), all_normal.size());
  const auto [shear, normal] = loaded_rows(all_shear, all_normal);
  if (shear.empty()) return {};
  const std::size_t first = find_steady_state(sizes_of_ratio(shear, normal)).first;
  const Values about = about_ratio_of_means(shear, normal, first);
  return {statistics::mean_of(about).value, steady(about).mean.error};
}

Columns rheology(const std::vector<AnyTest>& tests) {
  return table_of(mapped(tests, rheology_row),
                  {{"inertial_number", "", "Mean inertial number"},
                   {"mu", "", "Ratio of the mean shear and normal stress, or of q and p", true},
                   {"solid_fraction", "", "Mean solid fraction of the whole box", true}});
}

Columns critical_states(const std::vector<AnyTest>& tests) {
  return table_of(
      mapped(tests, critical_row),
      {{"friction", "", "Friction coefficient between grains"},
       {"mu", "", "Ratio of the mean shear and normal stress, or of q and p, on the plateau", true},
       {"solid_fraction", "", "Mean solid fraction of the whole box on its plateau", true},
       {"reached", "", "1 in a critical state, 0 where none is reached and the means are those of the second half"}});
}

Columns discharges(const std::vector<AnyTest>& tests) {
  return table_of(rows_of(tests, "/discharge/opening_m", {"/discharge/opening_m", "/discharge/rate_kg_s"}),
                  {{"opening", "m", "Narrowest opening between boundaries"},
                   {"rate", "kg/s", "Rate of discharge over its steady part", true}});
}

Columns runouts(const std::vector<AnyTest>& tests) {
  return table_of(rows_of(tests, "/surface/runout_over_width",
                          {"/surface/aspect_ratio_before", "/surface/runout_over_width", "/surface/height_over_width",
                           "/surface/angle_deg"}),
                  {{"aspect_ratio", "", "Height over width before the collapse"},
                   {"runout", "", "Displacement of the front that has moved farther over the width before", true},
                   {"height", "", "Height of the deposit over the width before"},
                   {"angle", "deg", "Angle of the deposit's free surface", true}});
}

Columns silos(const std::vector<AnyTest>& tests) {
  std::vector<std::vector<Estimate>> rows;
  for (const AnyTest& test : tests) {
    const auto* of_disks = std::get_if<Test>(&test);
    const auto silo = of_disks ? silo_state(of_disks->stage) : std::nullopt;
    if (!silo)
      throw refusal("the stage {} is no silo of disks: gravity pulls down, and its floor and both walls bear grains",
                    name_of(test));
    const double area = silo->area();
    rows.push_back({{silo->height},
                    {silo->force.value / area, silo->force.error / area},
                    {silo->weight / area},
                    {silo->wall_friction},
                    {silo->stress_ratio},
                    {silo->width}});
  }
  return table_of(std::move(rows), {{"height", "m", "Mean height of the filling"},
                                    {"pressure", "Pa", "Pressure on the floor", true},
                                    {"hydrostatic", "Pa", "Weight of the filling over the floor's area"},
                                    {"wall_friction", "", "Weight carried by the walls over their normal force"},
                                    {"ratio", "", "Horizontal over vertical normal stress of the contacts"},
                                    {"width", "m", "Width of the silo"}});
}

}  // namespace arenite::fields
