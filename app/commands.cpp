#include "commands.hpp"

namespace arenite::app {

const std::vector<Command>& commands() {
  static const std::vector<Command> list{
      {"run", "Run a recipe: packing, loading stage by stage, results and page", add_run},
      {"watch", "Show a run as it goes on, on a page for this machine's browsers, with a button to stop it", add_watch},
      {"study", "Run many: a recipe with [sweep], on all cores or a cluster", add_study},
      {"verify", "Check the claims of the thesis or the paper by their studies, which it runs", add_verify},
      {"init", "Write a commented recipe to start from", add_init},
      {"check", "Check a recipe, print it as it was understood, and predict what its run will cost and be like", add_check},
      {"load", "Load any phase map by peridynamics: moduli, stresses by phase, failure", add_load},
      {"lockin", "Lock in a film of a cyclically loaded sample: signed amplitude, errors and warnings of every pixel", add_lockin},
      {"step", "Measure the jump of temperature at a step of the load, in every pixel of a film", add_step},
      {"grains", "Find grains in a picture: centres, radii and materials, as a table to measure or simulate", add_grains},
      {"show", "Summarise a result (what, when, outcome, walls, energies, texture) or a film", add_show},
      {"export", "Write a result for ParaView, OVITO, LAMMPS tools or as tables", add_export},
      {"measure", "Measure the texture of grains and contacts from any program's files", add_measure},
      {"identify", "Find contact stiffness, thermoelastic factor or surface energy in a laboratory's records", add_identify},
      {"film", "From an infrared film of a loaded packing to stresses of grains and contact forces", add_film},
      {"camera", "Film simulated states with a virtual infrared camera", add_camera},
      {"figures", "Draw journal figures of a result: PDF, SVG, PNG in column width", add_figures},
      {"animate", "Film a run along its loading: MP4 or GIF, grains by stress, motion or friction", add_animate},
      {"compare", "Put two results side by side: numbers that differ beyond their errors, curves, a page", add_compare},
      {"doctor", "Say what this installation can do: versions, kernels, threads, helpers found", add_doctor},
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
        texts.emplace_back(CommandText{command.name, command.sentence, {{{"-h", "--help"}, "", {}, "Print this help message and exit", false, false}}});
    for (const Option& o : options.table) {
      const std::string name = o.name.substr(0, o.name.find('{'));
      const std::string value = o.is_flag() ? "" : !o.value.empty() ? o.value : o.is_named() ? "TEXT" : name;
      text.arguments.push_back({o.is_named() ? std::vector{name} : std::vector<std::string>{}, value, o.choices, o.sentence, o.is_required, o.repeats()});
    }
  }
  return texts;
}

void add_overrides(Options& command, std::vector<std::string>& overrides) {
  command.add("--set", overrides, "Change one key of the recipe, e.g. seed=7 or stages.0.bottom.force=\"60 kN\"; may be repeated").each().type("KEY=VALUE");
}

}  // namespace arenite::app
