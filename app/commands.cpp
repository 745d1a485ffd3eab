#include "commands.hpp"

namespace arenite::app {

const std::vector<Command>& commands() {
  static const std::vector<Command> list{
      {"run", "Run a recipe: packing, loading stage by stage, results and page", add_run},
      {"watch", "Follow a run on a live page for browsers on this machine, with a button to stop it", add_watch},
      {"study", "Run a study: a recipe with [sweep], on all cores or on a cluster", add_study},
      {"verify", "Check the claims of the thesis or the paper by running their studies", add_verify},
      {"init", "Write a commented recipe to start from", add_init},
      {"check", "Check a recipe, print it as interpreted, and predict the cost and regime of its run", add_check},
      {"load", "Load any phase map by peridynamics: moduli, stresses by phase, failure", add_load},
      {"lockin",
       "Lock-in analysis of a film of a cyclically loaded sample: signed amplitude and error of every pixel, with "
       "warnings",
       add_lockin},
      {"step", "Measure the temperature jump at a step of the load, in every pixel of a film", add_step},
      {"grains", "Find grains in a picture: a table of centres, radii and materials to measure or simulate",
       add_grains},
      {"show", "Summarise a result (provenance, outcome, walls, energies, fabric and forces) or a film", add_show},
      {"export", "Export a result for ParaView, OVITO, LAMMPS tools, or as tables", add_export},
      {"measure", "Measure fabric, coordination, forces and stresses of grains and contacts from any program's files",
       add_measure},
      {"identify", "Identify contact stiffness, thermoelastic factor or surface energy from laboratory records",
       add_identify},
      {"film", "Infer grain stresses and contact forces from an infrared film of a loaded packing", add_film},
      {"camera", "Film simulated states with a virtual infrared camera", add_camera},
      {"figures", "Draw journal figures of a result: PDF, SVG, PNG in column width", add_figures},
      {"animate", "Animate a run along its loading: MP4 or GIF, grains coloured by stress, motion or friction",
       add_animate},
      {"compare", "Compare two results: numbers that differ beyond their errors, curves, a page", add_compare},
      {"doctor", "Report the installation: versions, kernels, threads, helper programs", add_doctor},
      {"completion", "Print the completion script of a shell", add_completion},
      {"man", "Print the manual page, or the reference of all recipe keys", add_man},
  };
  return list;
}

std::vector<CommandText> command_texts() {
  std::vector<CommandText> texts;
  int status = done;
  for (const Command& command : commands()) {
    Options options;
    command.add(options, status);
    CommandText& text =
        texts.emplace_back(CommandText{command.name,
                                       command.sentence,
                                       {{{"-h", "--help"}, "", {}, "Print this help message and exit", false, false}}});
    for (const Option& o : options.table) {
      const std::string name = o.name.substr(0, o.name.find('{'));
      const std::string value = o.is_flag() ? "" : !o.value.empty() ? o.value : o.is_named() ? "TEXT" : name;
      text.arguments.push_back({o.is_named() ? std::vector{name} : std::vector<std::string>{}, value, o.choices,
                                o.sentence, o.is_required, o.repeats()});
    }
  }
  return texts;
}

void add_overrides(Options& command, std::vector<std::string>& overrides) {
  command
      .add("--set", overrides,
           "Change one key of the recipe, e.g. seed=7 or stages.0.bottom.force=\"60 kN\"; may be repeated")
      .each()
      .type("KEY=VALUE");
}

}  // namespace arenite::app
