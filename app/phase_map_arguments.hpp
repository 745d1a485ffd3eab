#pragma once
#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "study/foreign_map.hpp"

namespace arenite::app {

/// The command line of a phase map: the file and how it is read.
struct PhaseMapArguments {
  std::string file, phases, crop, dx, dataset, labels, label_dataset, grains = "components";
  std::int64_t slice = -1;
  double smoothing = 1;
};

/// Declares the file and all options that say how it is read.
void add_phase_map(CLI::App& command, PhaseMapArguments& arguments);

/// Reads the map that the arguments mean. Throws InputError as study::read_foreign_map does, or naming the option.
study::LabelledMap read_phase_map(const PhaseMapArguments& arguments);

}  // namespace arenite::app
