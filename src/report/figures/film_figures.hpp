#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "report/figures/drawing.hpp"
#include "thermal/inference/film_stresses.hpp"

namespace arenite::report::figures {

/// A film, with the stresses of its grains beside those of its companion simulation.
struct FilmData {
  const FilmResult& result;
  const inference::FilmStresses& stresses;
};

/// What a source of the stresses of grains is called: "simulation, peak to peak" of "simulation_peak_to_peak".
std::string name_of_source(std::string_view source);

/// Figures of a film, in their order on the page.
const std::vector<Row<FilmData>>& film_figures();

}  // namespace arenite::report::figures
