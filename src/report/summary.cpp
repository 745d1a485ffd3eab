#include "report/summary.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <variant>

#include "grains/dem/run_stage.hpp"
#include "grains/fields/laboratory/test_numbers.hpp"
#include "grains/fields/stage_numbers.hpp"
#include "io/disk/store_file.hpp"
#include "report/film_text.hpp"
#include "report/packing_layers.hpp"
#include "report/page_document.hpp"
#include "report/stage_doubts.hpp"
#include "workflow/asked.hpp"
#include "workflow/load_voxels.hpp"
#include "workflow/run.hpp"

namespace arenite::report {
namespace {

using statistics::described;

std::string made_by(const Provenance& p) {
  return fmt::format("{}{}Made by Arenite {}, {}{}seed {}; input {}\n", p.title, p.title.empty() ? "" : "\n", p.version,
                     p.kernel.empty() ? "" : "kernel ", p.kernel.empty() ? "" : p.kernel + ", ", p.seed,
                     p.input_hash.substr(0, 12));
}

Numbers provenance(const Provenance& p) {
  Numbers j{{"title", p.title}};
  j.update(provenance_of(p));
  return j;
}

Numbers equilibrium(const Equilibrium& now) {
  return {{"unbalanced_ratio",
           described(now.unbalanced_ratio, "", "Mean resultant force on a grain over the mean contact force")},
          {"kinetic_ratio", described(now.kinetic_ratio, "", "Kinetic over elastic energy")},
          {"loose_kinetic_ratio", described(now.loose_kinetic, "", "The same for grains that carry no load")},
          {"falling", described(now.falling, "", "Fraction of grains that are falling")},
          {"mobilisation", described(now.mobilisation, "", "Mean |F_t|/F_n")},
          {"wall_speed_m_s", described(now.wall_speed, "m/s", "Speed of the fastest wall or boundary")}};
}

Numbers walls(const Domain& domain) {
  Numbers j = Numbers::tree();
  for (std::size_t side = 0; side < domain.wall.size(); ++side) {
    const Wall& wall = domain.wall[side];
    if (!wall.present) continue;
    j[side_names[side]] = {{"position_m", described(wall.position, "m", "Position along the normal of the wall")},
                           {"velocity_m_s", described(wall.velocity, "m/s", "Velocity along the normal of the wall")},
                           {"force_N", described(wall.force, "N", "Normal force of the grains on the wall")},
                           {"shear_force_N", described(wall.shear_force, "N", "Force of the grains along the wall")}};
  }
  return j;
}

Numbers boundaries(const Domain& domain) {
  Numbers j = Numbers::tree();
  for (const Boundary& b : domain.boundaries)
    j[b.name] = {{"present", described(b.present, "", "Whether it is present")},
                 {"centre_m", described({b.centre.x, b.centre.y}, "m", "Centre, which moves with the boundary")},
                 {"velocity_m_s", described({b.velocity.x, b.velocity.y}, "m/s", "Velocity of the centre")},
                 {"spin_rad_s", described(b.spin, "rad/s", "Counter-clockwise")},
                 {"force_N", described({b.force.x, b.force.y}, "N", "Force of the grains on it, along x and y")},
                 {"torque_N_m", described(b.torque, "N m", "Torque of the grains about the centre")}};
  return j;
}

/// Without the terms that are added up on the way where nobody asked for that; broken bonds always are.
Numbers energies_of(const Energies& e) {
  const bool tracked =
      std::ranges::any_of(energy_terms, [&](const EnergyTerm& t) { return t.tracked && e.*t.value != 0; });
  Numbers energies = Numbers::tree();
  for (const EnergyTerm& term : energy_terms)
    if (tracked || !term.tracked) energies[term.name] = described(e.*term.value, "J", term.phrase);
  if (e.exchanged != 0) energies[exchange_term.name] = described(e.exchanged, "J", exchange_term.phrase);
  return energies;
}

Numbers state(const Snapshot& snapshot) {
  Numbers j{{"label", snapshot.label},
            {"time_s", described(snapshot.time, "s", "Time since the run began")},
            {"step", described(snapshot.step, "", "Steps since the run began")},
            {"walls", walls(snapshot.packing.domain)},
            {"equilibrium", equilibrium(snapshot.equilibrium)},
            {"energies_J", energies_of(snapshot.energies)}};
  if (!snapshot.packing.domain.boundaries.empty()) j["boundaries"] = boundaries(snapshot.packing.domain);
  return j;
}

Numbers converged(const ResultHead& head) {
  return described(head.converged, "", "Whether equilibrium, or a solution, was reached");
}

/// What the list of stages says of every kind of result.
Numbers entry(const ResultHead& head, const std::string& file) {
  return {{"name", head.name},
          {"file", file},
          {"input_hash", head.provenance.input_hash},
          {"converged", converged(head)},
          {"outcome", head.outcome}};
}

/// As stored, or measured now.
Numbers last_texture(const StageResult& last) {
  if (!last.texture.empty()) return last.texture;
  if (last.snapshots.empty()) return Numbers::tree();
  return texture::numbers(texture::measure(last.snapshots.back().packing, fields::texture_options(last)));
}

std::string grains_of(const Packing& packing) {
  const std::size_t all = packing.grains.size();
  if (packing.materials.size() < 2) return std::to_string(all);
  std::string parts;
  for (std::size_t m = 0; m < packing.materials.size(); ++m) {
    const auto count =
        std::count(packing.grains.material.begin(), packing.grains.material.end(), static_cast<std::int32_t>(m));
    parts += fmt::format("{}{} {}", m > 0 ? ", " : "", count, packing.materials[m].name);
  }
  return fmt::format("{}: {}", all, parts);
}

std::string forces_on_sides(const Domain& domain) {
  std::string text;
  for (std::size_t side = 0; side < domain.wall.size(); ++side)
    if (const double f = domain.wall[side].force; domain.wall[side].present)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", side_names[side],
                          std::abs(f) < 1e4 ? fmt::format("{:.4g} N", f) : fmt::format("{:.4g} kN", 1e-3 * f));
  return text;
}

std::string state_of(const StageResult& last) {
  const Equilibrium& now = last.snapshots.back().equilibrium;
  const bool rests = last.asked.known ? last.asked.in_equilibrium
                                      : last.converged && dem::is_at_rest(now, dem::EquilibriumCriterion{});
  return fmt::format("{}: {}", rests ? "in equilibrium" : "NOT IN EQUILIBRIUM", dem::describe(now));
}

/// How the last state of a stage stands: its balance, its grains by material, the forces on its walls.
std::string state_text(const StageResult& last) {
  const Snapshot& snapshot = last.snapshots.back();
  std::string text = fmt::format("\nLast state: {} of {}\n", snapshot.label, last.name);
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) text += fmt::format("  {:<32} {}\n", name, value);
  };
  if (!last.provenance.kernel.empty()) add("state", state_of(last));
  add("grains", grains_of(snapshot.packing));
  add("forces on the walls", forces_on_sides(snapshot.packing.domain));
  return text;
}

/// Loads that were not reached, and energies that do not balance, each a line; empty where all is well.
std::string doubts_of(const StageResult& stage) {
  std::string text;
  for (const std::string& doubt : doubts_about(stage)) text += fmt::format("  {:<32} WARNING: {}\n", "", doubt);
  return text;
}

/// The numbers that one asks for first, as rows of a table: of a test what it tells, as on the page, then those of
/// grains and of nodes.
std::string headlines(const Numbers& numbers) {
  return rows_of(
      numbers,
      "critical_state peak uniaxial oedometer cycles discharge surface floor cohesion boundary_loads contacts "
      "wall_contacts " +
          std::string(numbers.contains("surface") ? "" : "solid_fraction ") +
          "coordination.all coordination.without_rattlers "
          "coordination.all,* coordination.rattlers coordination.Z fabric.a_c fabric.a_c_noise long_axes.order "
          "long_axes.noise force.mean_N force.strong_share force.beta stress_details.pressure_Pa "
          "stress_details.deviator_Pa map.lengths grains.all "
          "phases.void phases.matrix S_m pores.count pores.mean voids.count modulus_Pa poisson apparent_moduli "
          "strength_Pa failure.strain_at_strength stress.sigma_yy.sets.*.mean_over_sample_mean map.voxels "
          "map.phases map.grains load.voxels.carrying load.voxels.floating effective_stiffness.young_Pa "
          "effective_stiffness.shear_Pa effective_stiffness.poisson effective_stiffness.isotropic_mean_Pa "
          "effective_stiffness.anisotropy effective_stiffness.bounds_Pa stress.sigma_zz.sets.*.mean_over_sample_mean "
          "stress.sigma_xz.sets.*.mean_over_sample_mean");
}

}  // namespace

Summary::Summary(const std::filesystem::path& result) {
  for (const auto& file : io::stage_files(result)) {
    auto any = workflow::read_result(file);
    if (auto* film = std::get_if<FilmResult>(&any)) films_.push_back(std::move(*film));
    else if (const auto* field = std::get_if<FieldResult>(&any)) add(file, *field, field->numbers);
    else if (const auto* voxels = std::get_if<VoxelResult>(&any)) add(file, *voxels, voxels->numbers);
    else add(file, std::get<StageResult>(any));
  }
}

Summary::Summary(const workflow::RunOutcome& outcome) {
  auto file = outcome.files.begin();
  for (const StageResult& stage : outcome.stages) add(*file++, stage);
  for (const FieldResult& field : outcome.fields) add(*file++, field, field.numbers);
  for (const VoxelResult& sample : outcome.voxels) add(*file++, sample, sample.numbers);
}

void Summary::add(const std::filesystem::path& file, const StageResult& stage) {
  StageResult kept{stage, stage.asked, stage.began, {}, stage.history, stage.cycles, stage.texture, {}};
  if (!stage.snapshots.empty()) kept.snapshots.push_back(stage.snapshots.back());
  stages_.push_back({file.filename().string(), std::move(kept), stage.snapshots.size()});
}

void Summary::add(const std::filesystem::path& file, const ResultHead& head, const Numbers& numbers) {
  fields_.push_back({file.filename().string(), head, numbers});
}

const ResultHead& Summary::last() const { return fields_.empty() ? stages_.back().result : fields_.back().head; }

Numbers Summary::numbers() const {
  if (!films_.empty()) return film_numbers(films_.back());
  const Numbers texture = stages_.empty() ? Numbers::tree() : last_texture(stages_.back().result);
  Numbers j = fields_.empty() ? texture : fields_.back().numbers;
  if (!fields_.empty() && !stages_.empty()) j["texture"] = texture;
  j["provenance"] = provenance(last().provenance);
  const Packing* before = nullptr;
  for (const Stage& stage : stages_) {
    Numbers one = entry(stage.result, stage.file);
    one["states"] = described(stage.states, "", "Stored states");
    if (!stage.result.snapshots.empty()) one["last_state"] = state(stage.result.snapshots.back());
    const Numbers test = fields::test_numbers({stage.result, before});
    one.update(test);
    j.update(test);
    j["stages"].push_back(one);
    if (!stage.result.snapshots.empty()) before = &stage.result.snapshots.back().packing;
  }
  for (const Field& field : fields_) {
    j["stages"].push_back(entry(field.head, field.file));
    j["stages"].back()["numbers"] = field.numbers;
  }
  return j;
}

std::string Summary::how_stages_ended() const {
  std::string text = made_by(last().provenance) + "\nStages\n";
  for (const Stage& stage : stages_) {
    text += fmt::format("  {:<32} {}{}\n", stage.result.name,
                        stage.result.converged ? "" : "NOT IN EQUILIBRIUM: ", stage.result.outcome);
    for (const std::string& load : loads_in_words(stage.result)) text += fmt::format("  {:<32} {}\n", "", load);
    text += doubts_of(stage.result);
    text += fmt::format("  {:<32} {} {} in {}\n", "", stage.states, stage.states == 1 ? "state" : "states", stage.file);
  }
  for (const Field& field : fields_)
    text += fmt::format("  {:<32} {}{}\n  {:<32} {}\n", field.head.name,
                        field.head.converged ? "" : "NOT SOLVED: ", field.head.outcome, "", field.file);
  return text;
}

std::string Summary::text() const {
  if (!films_.empty()) return all();
  const bool has_state = fields_.empty() && !stages_.back().result.snapshots.empty();
  if (fields_.empty() && !has_state) return how_stages_ended();
  return how_stages_ended() + (has_state ? state_text(stages_.back().result) : "") +
         "\nNumbers, each +- its standard error\n" + headlines(numbers()) +
         "\n`arenite show RESULT --all` prints every number, `--json` the same for programs.\n";
}

std::string Summary::all() const {
  if (!films_.empty()) return made_by(films_.back().provenance) + film_text(films_.back());
  std::string text = how_stages_ended();
  if (fields_.empty() && !stages_.back().result.snapshots.empty())
    text += "\nLast state\n" + to_text(state(stages_.back().result.snapshots.back()));
  return text + "\nNumbers, each +- its standard error\n" + to_text(numbers(), {"provenance"});
}

std::string field_summary(const ResultHead& result, const Numbers& numbers) {
  return fmt::format(
      "{}{}: {}\n\nNumbers of the sample, each +- its standard error\n{}\n`--json` prints every number; of a result "
      "that is kept (`--out`) `arenite show RESULT --all` does.\n",
      result.name, result.converged ? "" : " NOT SOLVED", result.outcome, headlines(numbers));
}

Numbers field_numbers(const ResultHead& result, Numbers numbers) {
  numbers["provenance"] = provenance(result.provenance);
  numbers["converged"] = converged(result);
  numbers["outcome"] = result.outcome;
  return numbers;
}

}  // namespace arenite::report
