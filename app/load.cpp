#include <fmt/core.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <sstream>

#include "commands.hpp"
#include "core/units.hpp"
#include "io/results/results.hpp"
#include "print.hpp"
#include "progress.hpp"
#include "report/page.hpp"
#include "report/summary.hpp"
#include "workflow/field_stages.hpp"

namespace arenite::app {
namespace {

namespace fs = std::filesystem;

struct LoadArguments {
  std::string map, phases, labels = "components", crop, dataset, label_dataset, dx, loading = "tension", axis = "y",
                           lower = "fixed";
  std::string method = "static_solve", stiffness, toughness, strength, out;
  std::int64_t slice = -1, label_slice = -1;
  double smoothing = 1;
  recipe::Load load;
  bool json = false, quiet = false;
};

/// "matrix=1 GPa,particle=4 GPa": each into its place.
void read_by_type(const std::string& text, const char* option, Dimension dimension, const char* unit, double& matrix,
                  std::optional<double>& interface, std::optional<double>& particle) {
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    const auto equals = part.find('=');
    const std::string name = part.substr(0, equals);
    if (equals == std::string::npos || (name != "matrix" && name != "interface" && name != "particle"))
      throw InputError(fmt::format("{0}: \"{1}\" is not of the form matrix=1 {2},interface=1 {2},particle=4 {2}",
                                   option, part, unit));
    double value = 0;
    try {
      value = parse_si(part.substr(equals + 1), dimension, unit);
    } catch (const InputError& error) { throw InputError(fmt::format("{}: {}: {}", option, name, error.what())); }
    if (!(value > 0))
      throw InputError(fmt::format("{}: {} is {}; it must be above 0", option, name, part.substr(equals + 1)));
    if (name == "matrix") matrix = value;
    else (name == "interface" ? interface : particle) = value;
  }
}

recipe::Load load_of(const LoadArguments& a) {
  recipe::Load load = a.load;
  load.name = load.failure ? "failure" : a.loading;
  load.loading = recipe::chosen<peridynamics::Loading>(a.loading, "--loading");
  load.axis = recipe::chosen<recipe::Load::Axis>(a.axis, "--axis");
  load.lower = recipe::chosen<peridynamics::LowerEdge>(a.lower, "--lower");
  load.method = recipe::chosen<peridynamics::Method>(a.method, "--method");
  read_by_type(a.stiffness, "--stiffness", dimension::pressure, "GPa", load.stiffness.matrix, load.stiffness.interface,
               load.stiffness.particle);
  read_by_type(a.toughness, "--toughness", dimension::toughness, "MPa m^0.5", load.toughness.matrix,
               load.toughness.interface, load.toughness.particle);
  if (double matrix = 0; !a.strength.empty()) {
    read_by_type(a.strength, "--strength", dimension::pressure, "MPa", matrix, load.strength.interface,
                 load.strength.particle);
    if (matrix > 0) load.strength.matrix = matrix;
  }
  if (load.failure && a.dx.empty() && io::stored_kind(a.map) != "field")
    throw InputError("a crack needs a length; give the size of a pixel, for example --dx \"25 um\"");
  return load;
}

bool is_file_of_labels(const std::string& labels) {
  return labels != "components" && labels != "watershed" && labels != "none";
}

io::PhaseMapOptions map_options(const LoadArguments& a) {
  io::PhaseMapOptions options;
  if (a.slice >= 0) options.image.slice = a.slice;
  options.image.dataset = a.dataset;
  if (!a.phases.empty()) options.phases = io::parse_phase_table(a.phases);
  if (!a.crop.empty()) options.crop = io::parse_crop(a.crop);
  if (!a.dx.empty()) options.dx = option_value("--dx", [&] { return parse_si(a.dx, dimension::length, "um"); });
  if (!(options.dx > 0)) throw InputError(fmt::format("--dx is {}; give a length above 0", a.dx));
  if (is_file_of_labels(a.labels)) options.labels = a.labels;
  if (a.label_slice >= 0) options.label_image.slice = a.label_slice;
  options.label_image.dataset = a.label_dataset;
  return options;
}

/// What the field depends on beside the map's bytes and the load: options that differ from their defaults, so that a
/// new one renames no result.
std::string asked_of(const LoadArguments& a) {
  const LoadArguments defaults;
  std::string asked;
  const auto add = [&](const char* name, auto LoadArguments::*option) {
    if (a.*option != defaults.*option) asked += fmt::format("{}{} {}", asked.empty() ? "" : "; ", name, a.*option);
  };
  add("phases", &LoadArguments::phases), add("labels", &LoadArguments::labels),
      add("smoothing", &LoadArguments::smoothing);
  add("crop", &LoadArguments::crop), add("slice", &LoadArguments::slice), add("dataset", &LoadArguments::dataset);
  add("label slice", &LoadArguments::label_slice), add("label dataset", &LoadArguments::label_dataset),
      add("dx", &LoadArguments::dx);
  return asked;
}

workflow::MapSource source_of(const LoadArguments& a) {
  workflow::MapSource source{a.map, map_options(a), !a.dx.empty(), {}, asked_of(a)};
  if (a.labels != "none")
    source.labelling = {a.labels == "watershed" ? imaging::Labelling::watershed : imaging::Labelling::components,
                        a.smoothing};
  return source;
}

workflow::MapOutcome carry_out(const LoadArguments& a, const recipe::Load& load) {
  ProgressLine line(a.quiet || a.json);
  workflow::RunOptions options;
  options.out = a.out;
  options.page_follows = !a.out.empty();
  options.asked_to_stop = stop_requested;
  options.progress = [&](const workflow::Progress& progress) { line.show(progress); };
  options.notice = [&](const std::string& sentence) { line.notice(sentence); };
  try {
    return workflow::load_map(source_of(a), load, options);
  } catch (const InputError& error) { throw in_file(error, a.map); }
}

int execute(const LoadArguments& a) {
  const recipe::Load load = load_of(a);
  watch_for_signals();
  const auto [field, file, measured] = carry_out(a, load);
  if (!field) {
    if (load.failure && !a.out.empty())
      print(stderr, "stopped; the same command continues from the checkpoint in {}\n", a.out);
    else print(stderr, "stopped; nothing was stored\n");
    return other_failure;
  }
  print("{}", a.json ? to_json(report::field_numbers(*field), 2) + "\n" : report::field_summary(*field));
  if (!a.out.empty()) {
    const fs::path page = fs::path(a.out) / "report.html";
    report::write_page(page, {.fields = {&*field, 1}, .measured = &measured});
    if (!a.json) print("\nresult: {}\npage:   {}\n", file.string(), page.string());
  }
  return field->converged ? done : not_converged;
}

void add_reading(Options& command, LoadArguments& a) {
  command
      .add("--phases", a.phases,
           "Phase of each grey value, e.g. \"0=void,85=particle,170=matrix\"; not needed for a picture of two values")
      .type("TABLE");
  command
      .add("--labels", a.labels,
           "Grains: components (connected particles; default), watershed (split at necks), none (all one grain), or a "
           "label image")
      .type("WAY");
  command.add("--smoothing", a.smoothing, "Watershed: depth of a neck up to which it is not cut, pixels; default 1")
      .type("NUMBER");
  command.add("--crop", a.crop, "Part of the picture to use, in pixels from its upper left corner")
      .type("X,Y,WIDTH,HEIGHT");
  command.add("--slice", a.slice, "Slice of a stack, counted from 0").between(0, 1e12).type("N");
  command.add("--dataset", a.dataset, "Dataset to read from an HDF5 file that holds several").type("NAME");
  command.add("--label-slice", a.label_slice, "Slice of the labels, counted from 0").between(0, 1e12).type("N");
  command.add("--label-dataset", a.label_dataset, "Dataset of the labels").type("NAME");
  command.add("--dx", a.dx, "Side of a pixel, e.g. \"25 um\"; if not given, lengths are in pixels").type("LENGTH");
}

void add_loading(Options& command, LoadArguments& a) {
  recipe::Load& load = a.load;
  command.add("--loading", a.loading, "Direction in which the top row is moved")
      .among(recipe::plain_words<peridynamics::Loading>());
  command.add("--axis", a.axis, "Axis from the bottom row to the top row; x loads the map rotated")
      .among(recipe::plain_words<recipe::Load::Axis>());
  command.add("--lower", a.lower, "Support of the bottom row").among(recipe::plain_words<peridynamics::LowerEdge>());
  command.add("--method", a.method, "Solution method for the equilibrium field")
      .among(recipe::plain_words<peridynamics::Method>());
  command.add("--strain", load.strain, "Nominal strain: displacement of the top row over the height; default 1e-4")
      .type("NUMBER");
  command.add("--tolerance", load.tolerance, "Relative residual at equilibrium; default 1e-6").type("NUMBER");
  command
      .add("--stiffness", a.stiffness,
           "Young's moduli of bonds, e.g. \"matrix=1 GPa,particle=4 GPa\" (the default; interface as the matrix)")
      .type("MODULI");
  command.add("--stop-at-voids", load.stop_at_voids,
              "No bond passes through a void node; otherwise bonds reach across cracks thinner than 3 nodes");
  command.add("--exact-stretch", load.exact_stretch, "Use the exact (non-linearised) bond stretch");
  command.add("--moduli", load.moduli,
              "Also load along both axes and in shear, for the apparent moduli between rigid clamps");
  command.add("--failure", load.failure, "Load to failure; needs --dx");
  command
      .add("--toughness", a.toughness,
           "Fracture toughness of bonds, e.g. \"matrix=0.1 MPa m^0.5\" (the default; interface the same, particle 3.5 "
           "times as much)")
      .type("TOUGHNESS");
  command
      .add("--strength", a.strength,
           "Tensile strength of bonds beside their toughness, e.g. \"matrix=3 MPa\" (interface the same, particle 3.5 "
           "times as much)")
      .type("STRENGTH");
  command.add("--cracks-stay-open", load.cracks_stay_open,
              "Failure: faces that have parted do not push where they meet again");
  command.add("--max-strain", load.max_strain, "Strain at which a test to failure ends at the latest; default 0.1")
      .type("NUMBER");
  command.add("--clamp-rows", load.statistics.clamp_rows, "Rows at both edges that the statistics leave out; default 4")
      .between(0, 10'000)
      .type("N");
  command.add("--leave-out-surface", load.statistics.leave_out_surface,
              "Exclude nodes that border another phase or grain from the statistics");
}

}  // namespace

void add_load(Options& command, int& status) {
  const auto a = std::make_shared<LoadArguments>();
  command
      .add("map", a->map,
           "Phase map: picture of grey values (" + io::picture_formats(true) + "), or a field file of Arenite (.h5)")
      .required()
      .type("PHASEMAP");
  add_reading(command, *a);
  add_loading(command, *a);
  command.add("--json", a->json, "Print all numbers as JSON");
  command.add("--out", a->out, "Folder for the field (.h5) and its page; if not given, nothing is stored").type("DIR");
  command.add("--quiet", a->quiet, "Show no progress");
  command.work = [a, &status] { status = execute(*a); };
}

}  // namespace arenite::app
