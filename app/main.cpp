#include <sys/resource.h>

#include <algorithm>
#include <string>
#include <vector>

#include "commands.hpp"
#include "program.hpp"

using namespace arenite;

const std::vector<app::Command>& app::commands() {
  static const std::vector<Command> list{
      {"run", "Run a recipe: packing, loading stage by stage, results and page", app::add_run, true},
      {"watch", "Follow a run on a live page for browsers on this machine, with a button to stop it", app::add_watch},
      {"study", "Run a study: a recipe with [sweep], on all cores or on a cluster", app::add_study, true},
      {"verify", "Check the claims of the thesis or the paper by running their studies", app::add_verify, true},
      {"init", "Write a commented recipe to start from", app::add_init},
      {"check", "Check a recipe, print it as interpreted, and predict the cost and regime of its run", app::add_check},
      {"load", "Load any phase map by peridynamics: moduli, stresses by phase, failure", app::add_load, true},
      {"lockin",
       "Lock-in analysis of a film of a cyclically loaded sample: signed amplitude and error of every pixel, with "
       "warnings",
       app::add_lockin},
      {"step", "Measure the temperature jump at a step of the load, in every pixel of a film", app::add_step},
      {"grains", "Find grains in a picture: a table of centres, radii and materials to measure or simulate",
       app::add_grains},
      {"show", "Summarise a result (provenance, outcome, walls, energies, fabric and forces) or a film", app::add_show},
      {"export", "Export a result for ParaView, OVITO, LAMMPS tools, or as tables", app::add_export},
      {"measure", "Measure fabric, coordination, forces and stresses of grains and contacts from any program's files",
       app::add_measure},
      {"identify", "Identify contact stiffness, thermoelastic factor or surface energy from laboratory records",
       app::add_identify},
      {"film", "Infer grain stresses and contact forces from an infrared film of a loaded packing", app::add_film},
      {"camera", "Film simulated states with a virtual infrared camera", app::add_camera},
      {"figures", "Draw journal figures of a result: PDF, SVG, PNG in column width", app::add_figures},
      {"animate", "Animate a run along its loading: MP4 or GIF, grains coloured by stress, motion or friction",
       app::add_animate},
      {"compare", "Compare two results: numbers that differ beyond their errors, curves, a page", app::add_compare},
      {"doctor", "Report the installation: versions, kernels, threads, helper programs", app::add_doctor},
      {"completion", "Print the completion script of a shell", app::add_completion},
      {"man", "Print the manual page, or the reference of all recipe keys", app::add_man},
  };
  return list;
}

namespace {

/// Where address space is limited a thread of OpenBLAS may ask for memory for ever, which the end of the program then
/// waits for.
bool has_limited_space() {
  rlimit space{};
  return ::getrlimit(RLIMIT_AS, &space) == 0 && space.rlim_cur != RLIM_INFINITY;
}

bool works_for_long(int argc, char** argv) {
  const std::string named = argc > 1 ? argv[1] : "";
  return std::ranges::any_of(app::commands(), [&](const auto& c) { return c.works_for_long && named == c.name; });
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<app::Setting> settings;
  if (has_limited_space()) settings.push_back(app::one_blas_thread);
  if (works_for_long(argc, argv)) settings.push_back(app::large_pages);
  app::start_anew_with(settings, argv);
  return app::run_program(argc, argv);
}
