
#include <cstdio>
#include <memory>

#include "commands.hpp"
#include "film_reading.hpp"
#include "io/film.hpp"
#include "no_result.hpp"
#include "report/film_summary.hpp"
#include "report/summary.hpp"
#include "states_table.hpp"

namespace arenite::app {

void add_show(Options& command, int&) {
  const auto result = std::make_shared<std::string>();
  const auto json = std::make_shared<bool>(false);
  command.add("result", *result, "Stage file (.h5) or folder of a run, or a film: a file, a folder of frames, or a name with *").required().type("RESULT");
  command.add("--json", *json, "Print everything as JSON: provenance, stages, texture of the last state; or what a film says about itself");
  const auto all = std::make_shared<bool>(false);
  command.add("--all", *all, "Print every number, not the headlines alone").not_with("--json");
  const auto states = std::make_shared<bool>(false);
  command.add("--states", *states, "Print one row a stored state as CSV: strains, stress and texture along the loading").not_with("--json").not_with("--all");
  const auto reading = std::make_shared<FilmReading>();
  reading->add_to(command);
  command.work = [result, json, all, states, reading] {
    refuse_no_result(*result);
    io::refuse_other_recording(*result);
    if (!*states && io::looks_like_film(*result)) {
      const report::FilmSummary film(*io::open_film(*result, reading->choice()));
      std::fputs((*json ? film.json() : film.text()).c_str(), stdout);
      return;
    }
    if (*states) {
      std::fputs(states_table(*result).c_str(), stdout);
      return;
    }
    const report::Summary summary(*result);
    std::fputs((*json ? to_json(summary.numbers(), 2) + "\n" : *all ? summary.all() : summary.text()).c_str(), stdout);
  };
}

}  // namespace arenite::app
