#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "commands.hpp"
#include "core/thread_count.hpp"
#include "io/image/image.hpp"
#include "io/volume/volume.hpp"
#include "print.hpp"
#include "progress.hpp"
#include "recipe/given.hpp"
#include "report/page.hpp"
#include "report/summary/summary.hpp"
#include "solid/elements/load.hpp"
#include "workflow/apply_load.hpp"
#include "workflow/load_voxels.hpp"
#include "workflow/read_map.hpp"

namespace arenite::app {
namespace {

namespace fs = std::filesystem;

struct LoadArguments {
  std::string file, out;
  KeyOptions map{recipe::every_key<recipe::MapSection>()}, load{recipe::every_key<recipe::Load>()};
  bool json = false, quiet = false;
  int threads = Threads{}.threads;
  const elements::OtherSolver* solver = nullptr;
};

recipe::MapSection map_of(const LoadArguments& a) {
  recipe::MapSection map;
  auto given = a.map.given();
  given.push_back({"PHASEMAP", "file", {.kind = recipe::Node::Kind::text, .text = a.file, .entries = {}}});
  read_options(map, given);
  return map;
}

recipe::Load load_of(const LoadArguments& a) {
  recipe::Load load;
  read_options(load, a.load.given());
  load.name = load.failure ? "failure" : recipe::word_of(load.loading);
  return load;
}

void tell_idle_options(const LoadArguments& a, const recipe::MapSection& map) {
  std::vector<std::string> told;
  for (const KeyOptions* options : {&a.map, &a.load})
    for (const recipe::Given& each : options->given()) {
      const std::string without = workflow::idle_without(each.key.substr(0, each.key.find('.')), map),
                        option = each.label.substr(0, each.label.find(':'));
      if (without.empty() || std::ranges::count(told, option) > 0) continue;
      print(stderr, "{}\n", recipe::left_aside(option, without));
      told.push_back(option);
    }
}

workflow::RunOptions options_of(const LoadArguments& a, ProgressLine& line) {
  workflow::RunOptions options;
  options.out = a.out;
  options.threads = a.threads;
  options.asked_to_stop = stop_requested;
  options.progress = [&](const workflow::Progress& progress) { line.show(progress); };
  options.notice = [&](const std::string& sentence) { line.notice(sentence); };
  return options;
}

workflow::MapOutcome carry_out(const LoadArguments& a, const recipe::MapSection& map, const recipe::Load& load) {
  ProgressLine line(a.quiet || a.json);
  workflow::RunOptions options = options_of(a, line);
  options.page_follows = !a.out.empty();
  try {
    return workflow::load_map(map, load, options);
  } catch (const InputError& error) { throw in_file(error, a.file); }
}

void tell(const LoadArguments& a, const ResultHead& result, const Numbers& numbers) {
  if (a.json) print("{}\n", to_json(report::field_numbers(result, numbers), 2));
  else print("{}", report::field_summary(result, numbers));
}

int tell_stopped(const LoadArguments& a, const recipe::Load& load) {
  if (load.failure && !a.out.empty())
    print(stderr, "stopped; the same command continues from the checkpoint in {}\n", a.out);
  else print(stderr, "stopped; nothing was stored\n");
  return other_failure;
}

int execute_in_space(const LoadArguments& a, const recipe::MapSection& map, const recipe::Load& load) {
  ProgressLine line(a.quiet || a.json);
  const workflow::RunOptions options = options_of(a, line);
  watch_for_signals();
  const auto [result, file] = workflow::load_voxels(map, load, options, a.solver);
  if (!result) return tell_stopped(a, load);
  tell(a, *result, result->numbers);
  if (!a.out.empty()) {
    const fs::path page = fs::path(a.out) / "report.html";
    report::write_page(page, {.voxels = {&*result, 1}});
    if (!a.json) print("\nresult: {}\npage:   {}\n", file.string(), page.string());
  }
  return result->converged ? done : not_converged;
}

int execute(const LoadArguments& a) {
  const recipe::MapSection map = map_of(a);
  const recipe::Load load = load_of(a);
  tell_idle_options(a, map);
  if (workflow::is_in_space(map)) return execute_in_space(a, map, load);
  if (a.solver) throw InputError(a.solver->name + " solves samples in space; load pictures by `arenite load`");
  workflow::require_length(map, load);
  watch_for_signals();
  const auto [field, file, measured] = carry_out(a, map, load);
  if (!field) return tell_stopped(a, load);
  tell(a, *field, field->numbers);
  if (!a.out.empty()) {
    const fs::path page = fs::path(a.out) / "report.html";
    report::write_page(page, {.fields = {&*field, 1}, .measured = &measured});
    if (!a.json) print("\nresult: {}\npage:   {}\n", file.string(), page.string());
  }
  return field->converged ? done : not_converged;
}

void add_reading(Options& command, KeyOptions& map) {
  map.add(command, "--phases", "phases").type("TABLE");
  map.add(command, "--labels", "labels").type("WAY");
  map.add(command, "--smoothing", "smoothing");
  map.add(command, "--crop", "crop").type("X,Y,WIDTH,HEIGHT");
  map.add(command, "--dimension", "dimension");
  map.add(command, "--slice", "slice");
  map.add(command, "--dataset", "dataset").type("NAME");
  map.add(command, "--label-slice", "label_slice");
  map.add(command, "--label-dataset", "label_dataset").type("NAME");
  map.add(command, "--dx", "dx").type("LENGTH");
  map.add(command, "--periodic", "periodic");
  map.add(command, "--voxels", "voxels");
  map.add(command, "--box", "box").type("CORNERS");
  map.add(command, "--cement", "cement").type("CEMENT");
}

void add_loading(Options& command, KeyOptions& load) {
  for (const char* key :
       {"loading", "axis", "lower", "method", "element", "plane", "strain", "tolerance", "horizon_in_space",
        "stop_at_voids", "exact_stretch", "moduli", "effective_stiffness", "failure", "cracks_stay_open", "max_strain"})
    load.add(command, option_name(key), key);
  load.add(command, "--stiffness", "stiffness").type("MODULI");
  load.add(command, "--poisson", "poisson").type("RATIOS");
  load.add(command, "--toughness", "toughness").type("TOUGHNESS");
  load.add(command, "--strength", "strength").type("STRENGTH");
  load.add(command, "--clamp-rows", "statistics.clamp_rows");
  load.add(command, "--leave-out-surface", "statistics.leave_out_surface");
}

}  // namespace

void add_load(Options& command, int& status) { add_load_by(nullptr, command, status); }

void add_load_by(const elements::OtherSolver* solver, Options& command, int& status) {
  const auto a = std::make_shared<LoadArguments>();
  a->solver = solver;
  command
      .add("map", a->file,
           recipe::help_of(a->map.at("file")) + "; pictures: " + io::picture_formats(true) +
               "; volumes: " + io::volume_formats() + "; spheres: .csv and what `arenite measure` reads of them")
      .required()
      .type("PHASEMAP");
  add_reading(command, a->map);
  add_loading(command, a->load);
  add_json(command, a->json);
  command.add("--out", a->out, "Folder for the field (.h5) and its page; if not given, nothing is stored").type("DIR");
  if (!solver) add_threads(command, a->threads);
  add_quiet(command, a->quiet);
  command.work = [a, &status] { status = execute(*a); };
}

}  // namespace arenite::app
