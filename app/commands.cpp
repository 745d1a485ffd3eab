#include "commands.hpp"

namespace arenite::app {

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
