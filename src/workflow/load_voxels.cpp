#include "workflow/load_voxels.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/option.hpp"
#include "core/problems.hpp"
#include "io/results/results.hpp"
#include "io/volume/spheres.hpp"
#include "io/volume/voxel_map.hpp"
#include "solid/cement/cement_spheres.hpp"
#include "solid/elements/load.hpp"
#include "solid/elements/stiffness_numbers.hpp"
#include "solid/grid/label_grains.hpp"
#include "solid/grid/map_numbers.hpp"
#include "solid/grid/rasterise_spheres.hpp"
#include "solid/grid/thin_voids.hpp"
#include "solid/peridynamics/cracks.hpp"
#include "solid/peridynamics/space/lattice_in_space.hpp"
#include "solid/peridynamics/space/load_in_space.hpp"
#include "solid/stress/measure_voxels.hpp"
#include "statistics/numbers.hpp"
#include "workflow/field_numbers.hpp"
#include "workflow/read_map.hpp"
#include "workflow/runner.hpp"

namespace arenite::workflow {
namespace {

namespace fs = std::filesystem;
using statistics::described;

void refuse_keys_of_the_plane(const recipe::MapSection& map) {
  if (!map.crop.empty() || map.slice || map.label_slice)
    throw InputError(fmt::format("crop and slice are of pictures; leave them out in space, or {}",
                                 io::is_sphere_table(map.file) || io::is_volume(map.file)
                                     ? "store the slice that is meant as a picture"
                                     : "load a slice with " + option("dimension") + " 2"));
}

Numbers asked_in_space(const recipe::Load& load) {
  const elements::Material m = load.material();
  Numbers j{{"loading", recipe::word_of(load.loading)}};
  if (load.by_elements()) j["element"] = recipe::word_of(m.element);
  else
    j["horizon_in_space"] =
        described(load.horizon_in_space, "", "Horizon of the bonds in voxels: 2 for 32 bonds a voxel, 3 for 122");
  j["stiffness_Pa"] =
      described(by_type(m.matrix.young, m.interface.young, m.particle.young), "Pa",
                load.by_elements() ? "Young's modulus of these elements" : "Young's modulus of these bonds");
  if (load.by_elements())
    j["poisson_ratio"] = described(by_type(m.matrix.poisson, m.interface.poisson, m.particle.poisson), "",
                                   "Poisson's ratio of these elements");
  else
    j["poisson_ratio"] = described(peridynamics::space_lattice_poisson, "",
                                   "Poisson's ratio of the lattice of bonds, whatever its bonds");
  return j;
}

Numbers load_numbers(const recipe::Load& load, const statics::LoadReportIn<3>& r) {
  Numbers j = asked_in_space(load);
  j.update({{"strain", described(load.strain, "", "Strain of the sample")},
            {"iterations", described(r.iterations, "", "Iterations of the solver")},
            {"residual", described(r.residual, "", "Out-of-balance force over that of uniform strain")},
            {"reaction_balance_error",
             described(r.identity_defect, "",
                       "Volume integral of the stress over the product of clamp force and height, minus 1")},
            {"top_force_N",
             described({r.top_force.x, r.top_force.y, r.top_force.z}, "N", "Force of the upper clamp on the sample")},
            {"voxels", elements::support_numbers(r.support)}});
  return j;
}

statics::LoadResultIn<3> loaded_by_bonds(const recipe::Load& load, const VoxelMap& map, const statics::Watch& watch) {
  peridynamics::LoadOptions bonds{load, load, load.stiffness.resolved(), watch};
  return peridynamics::load(map, bonds);
}

/// A table of spheres, cemented and cut into voxels.
VoxelMap read_cemented_spheres(const recipe::MapSection& map, const std::function<void(const std::string&)>& notice) {
  std::vector<std::string> notes;
  SpherePack pack = io::read_spheres(map.file, notes);
  const bool is_cut = pack.periodic && !grid::is_whole_in_voxels(pack, static_cast<int>(map.voxels));
  if (is_cut) {
    pack = cement::with_images(pack, 2 * *std::ranges::max_element(pack.radius));
    pack.periodic = false;
    notes.emplace_back(
        "its cell is no whole number of voxels along each axis, so it is cut out of the repeated packing and does not "
        "repeat itself exactly");
  }
  if (!map.box.empty()) grid::cut_out(pack, map.box);
  double parameter = 0;
  VoxelMap voxels = grid::cemented_voxels(pack, map.cement, static_cast<int>(map.voxels), parameter);
  if (is_cut || !map.box.empty()) grid::drop_absent_grains(voxels);
  for (const std::string& note : notes) notice(fmt::format("{}: {}", map.file, note));
  if (const std::string doubt = grid::doubt_about_cement(map.cement, voxels); !doubt.empty())
    notice(fmt::format("{}: {}", map.file, doubt));
  std::string used;
  if (map.cement.saturation)
    used = fmt::format(", {} {:.4g}",
                       map.cement.kind == cement::CementParameters::Kind::coating ? "by a thickness in m of"
                                                                                  : "by a width over the radius of",
                       parameter);
  notice(fmt::format("{}: {} spheres, {} x {} x {} voxels of {:.4g} m; S_m {:.4f}{}", map.file,
                     voxels.grain_class.size(), voxels.width, voxels.height, voxels.depth, voxels.dx,
                     grid::saturation_of(voxels), used));
  return voxels;
}

}  // namespace

void require_space(const recipe::Load& load, const elements::OtherSolver* solver) {
  if (const std::string sentence = load.not_in_space(); !sentence.empty()) throw InputError(sentence);
  if (solver && !load.by_elements())
    throw refusal("{} solves samples of elements; give method = \"elements\", or use `arenite load`", solver->name);
  if (solver && load.effective_stiffness)
    throw refusal("{} solves no periodic samples; leave effective_stiffness out, or use `arenite load`", solver->name);
}

bool is_in_space(const recipe::MapSection& map) {
  return map.dimension == 3 || io::is_sphere_table(map.file) || io::is_volume(map.file);
}

VoxelMap read_voxels(const recipe::MapSection& map, const std::function<void(const std::string&)>& notice) {
  refuse_keys_of_the_plane(map);
  if (io::is_sphere_table(map.file)) return read_cemented_spheres(map, notice);
  if (!map.box.empty()) refuse(map.file, "is a volume, and box is of a table of spheres; leave it out");
  io::VoxelMapOptions options;
  options.volume.dataset = map.dataset;
  if (!map.phases.empty()) options.phases = io::parse_phase_table(map.phases);
  options.dx = map.dx;
  if (map.has_label_file()) options.labels = map.labels;
  options.label_volume.dataset = map.label_dataset;
  io::ForeignVoxels read = io::read_voxel_map(map.file, options);
  for (const std::string& note : read.notes) notice(fmt::format("{}: {}", map.file, note));
  if (!read.map.has_length) notice(fmt::format("{}: lengths are in voxels, since dx was not given", map.file));
  if (!read.labelled && map.labels == "none") grid::label_alike(read.map);
  else if (!read.labelled) grid::label_grains(read.map, map.label_options(), map.periodic);
  return std::move(read.map);
}

namespace {

/// What is worth a word of bonds that reach across voids.
void note_thin_voids(const recipe::Load& load, const VoxelMap& map, std::vector<std::string>& notes) {
  if (load.by_elements()) return;
  if (peridynamics::joined_through_voids_only(map)) {
    notes.emplace_back(
        "no solid joins the two clamps: all load passes through bonds that reach across voids thinner than the "
        "horizon; method = \"elements\" (--method elements) lets none pass");
    return;
  }
  const int horizon = load.horizon_in_space;
  auto crack =
      note_of_bridged_crack(grid::longest_thin_void(map, horizon - 1), std::min({map.width, map.height, map.depth}),
                            horizon, "method = \"elements\" (--method elements)");
  if (!crack.empty()) notes.push_back(std::move(crack));
}

/// Statistics of a result's stresses, with its notes.
void measure_stresses(const recipe::Load& load, VoxelResult& result) {
  std::vector<std::string> notes;
  note_thin_voids(load, result.map, notes);
  stress::VoxelStressOptions statistics;
  const int depth = result.map.depth;
  statistics.clamp_layers = static_cast<int>(std::min<std::int64_t>(load.statistics.clamp_rows, (depth - 1) / 2));
  if (statistics.clamp_layers < load.statistics.clamp_rows)
    notes.push_back(
        fmt::format("statistics leave out {} layers at each clamp, not clamp_rows = {}: there are {} in all",
                    statistics.clamp_layers, load.statistics.clamp_rows, depth));
  statistics.shear = load.loading == statics::Loading::shear;
  result.numbers["stress"] = stress::measure(result.map, result.field, statistics, notes);
  for (std::string& note : notes) result.numbers["notes"].push_back(std::move(note));
}

/// Of a sample in which nothing ties the clamps.
VoxelStress without_stress(const VoxelMap& map) {
  VoxelStress field;
  field.width = map.width, field.height = map.height, field.depth = map.depth, field.dx = map.dx;
  for (auto* values :
       {&field.ux, &field.uy, &field.uz, &field.xx, &field.yy, &field.zz, &field.yz, &field.xz, &field.xy})
    values->assign(map.size(), 0.0f);
  return field;
}

std::optional<VoxelResult> load_until_failure(const recipe::Load& load, VoxelResult result, const statics::Watch& watch,
                                              const FailureCheckpointIn<3>& checkpoint) {
  if (!result.map.has_length) throw crack_without_length(side_to_give("voxel"));
  auto tested = peridynamics::load_to_failure<3>(result.map, damage_options<3>(load, watch, checkpoint));
  if (tested.ending == peridynamics::DamageOutcome::Ending::stopped) return std::nullopt;
  put_outcome(result, result.curve, tested, "J");
  result.cracks = peridynamics::space_cracks_of(tested.broken, load.horizon_in_space, result.map.dx);
  add_failure<3>(result.numbers, asked_in_space(load), load, tested, result.map.dx);
  if (tested.at_strength.size() > 0) {
    result.field = std::move(tested.at_strength);
    measure_stresses(load, result);
  } else {
    result.field = without_stress(result.map);
  }
  result.field.damage = peridynamics::damage_of(result.map, tested.broken, load.horizon_in_space);
  return result;
}

}  // namespace

std::optional<VoxelResult> apply_load(const recipe::Load& load, const VoxelMap& map, const statics::Watch& watch,
                                      const elements::OtherSolver* solver, const FailureCheckpointIn<3>& checkpoint,
                                      int threads) {
  require_space(load, solver);
  VoxelResult result;
  result.name = load.name;
  result.map = map;
  result.numbers["map"] = grid::map_numbers(map);
  if (load.failure) return load_until_failure(load, std::move(result), watch, checkpoint);
  const SolveShares shares(load, voigt_count<3>, watch);
  elements::LoadOptions solve;
  solve.tolerance = load.tolerance;
  solve.max_iterations = load.max_iterations;
  solve.material = load.material();
  solve.loading = load.loading;
  solve.lower = load.lower;
  solve.strain = load.strain;
  solve.watch = shares.of_load();
  solve.solver = solver;
  solve.threads = threads;
  auto loaded = load.by_elements() ? elements::load(map, solve) : loaded_by_bonds(load, map, solve.watch);
  if (loaded.report.ending == statics::Ending::stopped) return std::nullopt;
  result.convergence = convergence_of(loaded.report.history);
  result.converged = loaded.report.ending == statics::Ending::solved;
  result.outcome = loaded.report.sentence;
  result.numbers["load"] = load_numbers(load, loaded.report);
  if (solver) result.numbers["load"]["solver"] = solver->name;
  result.field = std::move(loaded.field);
  if (result.converged) {
    result.numbers["modulus_Pa"] =
        described(loaded.report.modulus, "Pa", "Apparent modulus, mean stress over strain, between clamps");
    measure_stresses(load, result);
  }
  solve.watch = shares.of_stiffness();
  if (load.effective_stiffness && !add_effective_stiffness(map, solve, result)) return std::nullopt;
  return result;
}

LoadedMap<VoxelResult> load_voxels(const recipe::MapSection& map, const recipe::Load& load, const RunOptions& options,
                                   const elements::OtherSolver* solver) {
  require_space(load, solver);
  const bool is_stored = !options.out.empty();
  const auto make = [&](const statics::Watch& watch, const std::string& hash, const fs::path& checkpoint) {
    return apply_load(load, read_voxels(map, options.notice), watch, solver,
                      kept_failure<3>(load, is_stored ? checkpoint : fs::path(), hash, options), options.threads);
  };
  auto loaded = load_by_itself<VoxelResult>(map, load, options, make, io::write_voxels, io::read_voxels);
  std::error_code error;
  if (loaded.result && is_stored) fs::remove(options.out / "run.checkpoint", error);
  return loaded;
}

}  // namespace arenite::workflow
