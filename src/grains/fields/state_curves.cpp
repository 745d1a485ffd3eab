#include "grains/fields/state_curves.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "grains/fields/laboratory/curves_in_space.hpp"
#include "grains/fields/stage_numbers.hpp"
#include "grains/texture/spheres/spheres.hpp"
#include "statistics/measured.hpp"

namespace arenite::fields {
namespace {

using statistics::Columns;
using Values = std::vector<double>;

/// Names of curves, and the numbers of the texture that stand below them.
constexpr std::pair<const char*, const char*> names_of_numbers[] = {
    {"solid_fraction", "/solid_fraction"},
    {"z", "/coordination/all"},
    {"z_without_rattlers", "/coordination/without_rattlers"},
    {"rattlers", "/coordination/rattlers"},
    {"a_c", "/fabric/a_c"},
    {"a_c_signed", "/fabric/a_c_signed"},
    {"a_c_strong", "/fabric/sets/strong/a_c_signed"},
    {"a_c_weak", "/fabric/sets/weak/a_c_signed"},
    {"a_n", "/fabric/a_n"},
    {"a_t", "/fabric/a_t"},
    {"theta_c", "/fabric/theta_c_deg"},
    {"mean_force", "/force/mean_N"},
    {"strong_share", "/force/strong_share"},
    {"q_on_strong", "/stress_details/strong_share_of_deviator"},
    {"p", "/stress_details/pressure_Pa"},
    {"q", "/stress_details/deviator_Pa"}};

double number_in(const Numbers* node) { return node && node->is_number() ? node->get<double>() : statistics::unknown; }

bool is_any_known(const Values& values) {
  return std::ranges::any_of(values, [](double v) { return std::isfinite(v); });
}

/// One number of all states, with its errors and what it means; left out where no state has it.
void put_number(Columns& to, const char* name, const std::string& path, const std::vector<Numbers>& states) {
  statistics::Column column{name, {}, {}, {}};
  for (const Numbers& one : states) {
    const Numbers* node = one.at_path(path);
    const bool measured = node && node->is_tree();
    column.values.push_back(number_in(measured ? node->at_path("/value") : node));
    column.error.push_back(number_in(measured ? node->at_path("/error") : nullptr));
    if (node && node->meaning()) column.meaning = *node->meaning();
  }
  column.tells_errors = is_any_known(column.error);
  if (!column.tells_errors) column.error.clear();
  if (is_any_known(column.values)) to.list.push_back(std::move(column));
}

std::vector<Numbers> textures_of(const StageResult& stage) {
  texture::Options options = texture_options(stage);
  options.rev.sizes = 0;
  return mapped(stage.snapshots, [&](const Snapshot& state) {
    return state.packing.contacts.size() == 0 ? Numbers::tree()
                                              : texture::numbers(texture::measure(state.packing, options));
  });
}

std::vector<Numbers> textures_of(const SphereResult& stage) {
  texture::SphereOptions options = texture::sphere_options(stage.asked);
  options.rev.sizes = 0;
  return mapped(stage.snapshots, [&](const auto& state) { return texture::measure_spheres(state.packing, options); });
}

/// Time of the first row, and of the ends of all cycles.
Values ends_of(const StageResult& stage, const Values& time) {
  Values ends{time.front()};
  for (const auto& [number, places] : whole_cycles(stage)) ends.push_back(stage.snapshots[places.second].time);
  return ends;
}

void put_dissipation(Columns& to, const StageResult& stage) {
  const Columns energies = energies_of(stage.history);
  const Values* time = stage.history.find("time");
  if (!energies.has("dissipated_energy") || !time) return;
  const Values spent =
      mapped(ends_of(stage, *time), [&](double t) { return at_time(*time, energies["dissipated_energy"], t); });
  Values in_cycles;
  for (std::size_t k = 1; k < spent.size(); ++k) in_cycles.push_back(spent[k] - spent[k - 1]);
  to.put("dissipated_energy", "J", "Energy dissipated in the cycle", std::move(in_cycles));
}

void put_accumulated(Columns& to) {
  Values low = to["axial_strain_minimum"];
  for (const double first = low.front(); double& v : low) v -= first;
  to.put("accumulated_strain", "", "Axial strain at the smallest load since the end of the first cycle",
         std::move(low));
}

Values every_second(const Values& values, std::size_t first, std::size_t count) {
  Values some;
  for (std::size_t k = 0; k < count; ++k) some.push_back(values[2 * k + first]);
  return some;
}

/// The strains of states with the numbers of their textures.
Columns with_numbers(Columns found, const std::vector<Numbers>& states) {
  for (const auto& [name, path] : names_of_numbers) put_number(found, name, path, states);
  if (!found.has("p") || !found.has("q")) return found;
  Values ratio = found["q"];
  for (std::size_t k = 0; k < ratio.size(); ++k)
    ratio[k] = found["p"][k] != 0 ? ratio[k] / found["p"][k] : statistics::unknown;
  found.put("q_over_p", "", "q over p of the contacts: the sine of the mobilised angle of friction", std::move(ratio));
  return found;
}

}  // namespace

template <int D> Columns numbers_of_states(const StageResultIn<D>& stage) {
  return with_numbers({}, textures_of(stage));
}
template Columns numbers_of_states<2>(const StageResult&);
template Columns numbers_of_states<3>(const SphereResult&);

Columns curves_of_states(const Test& test) { return with_numbers(strains_of_states(test), textures_of(test.stage)); }

Columns states_in_space(const SphereResult& stage) {
  const Columns rows = curves_in_space(stage);
  const double begin = stage.history.find("time")->front();
  Columns found;
  for (const char* name : {"time", "axial_strain", "shear_strain", "volumetric_strain"})
    if (const statistics::Column* of = rows.find(name))
      found.list.push_back(
          {name,
           of->meaning,
           mapped(stage.snapshots,
                  [&](const auto& state) { return at_time(rows["time"], of->values, state.time - begin); }),
           {}});
  return with_numbers(std::move(found), textures_of(stage));
}

std::map<std::int64_t, std::pair<std::size_t, std::size_t>> whole_cycles(const StageResult& stage) {
  std::map<std::int64_t, std::pair<std::size_t, std::size_t>> whole;
  const History& table = stage.cycles;  // a row at each end, with the time of the state there, if that is stored
  const Values *cycle = table.find("cycle"), *at_maximum = table.find("at_maximum"), *time = table.find("time");
  if (!cycle || !at_maximum || !time) return whole;
  std::map<double, std::size_t> state_at;
  for (std::size_t k = 0; k < stage.snapshots.size(); ++k) state_at[stage.snapshots[k].time] = k;
  std::map<std::int64_t, std::size_t> high;
  for (std::size_t row = 0; row < cycle->size(); ++row) {
    const auto state = state_at.find((*time)[row]);
    if (state == state_at.end()) continue;
    const auto number = static_cast<std::int64_t>((*cycle)[row]);
    if ((*at_maximum)[row] != 0) high[number] = state->second;
    else if (high.contains(number)) whole[number] = {high[number], state->second};
  }
  return whole;
}

Columns curves_of_cycles(const Test& test) {
  const auto cycles = whole_cycles(test.stage);
  if (cycles.empty()) throw refusal("the stage {} has no complete load cycle", test.stage.name);
  Columns found;
  found.put("cycle", "", "Number of the cycle, from 1",
            mapped(cycles, [](const auto& cycle) { return static_cast<double>(cycle.first); }));
  const Columns states = curves_of_states(test);
  const auto chosen = [&](const Values& values, bool high) {
    if (values.empty()) return values;
    return mapped(cycles, [&](const auto& cycle) { return values[high ? cycle.second.first : cycle.second.second]; });
  };
  for (const statistics::Column& one : states.list)
    for (const bool high : {true, false})
      found.list.push_back({one.name + (high ? "_maximum" : "_minimum"), one.meaning, chosen(one.values, high),
                            chosen(one.error, high)});
  Values amplitude = found["axial_strain_maximum"];
  for (std::size_t k = 0; k < amplitude.size(); ++k) amplitude[k] -= found["axial_strain_minimum"][k];
  found.put("strain_amplitude", "", "Axial strain between the largest and the smallest load", std::move(amplitude));
  put_accumulated(found);
  put_dissipation(found, test.stage);
  return found;
}

Columns every_cycle(const Test& test) {
  const History& table = test.stage.cycles;
  const Values* cycle = table.find("cycle");
  const std::size_t whole = cycle ? cycle->size() / 2 : 0;
  const auto sides_then = side_stresses(test.stage.history);
  if (whole == 0 || !sides_then) throw refusal("the stage {} has no complete cycle", test.stage.name);
  Packing first;  // the first row of the history stands in for the state before
  first.domain.wall[right].position = sides_then->width.front();
  first.domain.wall[top].position = sides_then->height.front();
  const auto of = loading_in(table, {test.stage, test.before ? test.before : &first});
  if (!of) throw refusal("the stage {} has no complete cycle", test.stage.name);
  Columns found;
  found.put("cycle", "", "Number of the cycle, from 1", every_second(*cycle, 1, whole));
  const int side = test.stage.asked.cycled;  // which axis cycles, not which has shortened in the end
  for (const auto& curve : of->curves.list) {
    if (curve.name == "time" || curve.name == "inertial_number") continue;
    const Values& values =
        curve.name == "axial_strain" && side >= 0 ? of->curves[side <= right ? "strain_x" : "strain_y"] : curve.values;
    for (const auto& [end, place] : {std::pair{"_maximum", 0}, {"_minimum", 1}})
      found.list.push_back(
          {curve.name + end, curve.meaning, every_second(values, static_cast<std::size_t>(place), whole), {}});
  }
  put_accumulated(found);
  return found;
}

}  // namespace arenite::fields
