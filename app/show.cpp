#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>

#include "commands.hpp"
#include "report/course.hpp"
#include "report/summary.hpp"

namespace arenite::app {

void add_show(CLI::App& command, int&) {
  const auto result = std::make_shared<std::string>();
  const auto json = std::make_shared<bool>(false);
  command.add_option("result", *result, "Stage file (.h5) or folder of a run")->required()->type_name("RESULT");
  command.add_flag("--json", *json, "Print everything as JSON: provenance, stages, texture of the last state");
  const auto states = std::make_shared<bool>(false);
  command.add_flag("--states", *states, "Print one row a stored state as CSV: strains, stress and texture along the loading")->excludes("--json");
  command.callback([result, json, states] {
    if (*states) {
      std::fputs(report::course_csv(*result).c_str(), stdout);
      return;
    }
    const report::Summary summary(*result);
    std::fputs((*json ? summary.json() : summary.text()).c_str(), stdout);
  });
}

}  // namespace arenite::app
