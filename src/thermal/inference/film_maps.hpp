#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "model/colour_scale.hpp"
#include "model/film_result.hpp"

/// The maps of a film's pixels that page and print show.
namespace arenite::inference {

struct FilmMap {
  std::string_view id, label, title;
  std::string_view unit = {};  ///< of a film in kelvin; empty where the title has it
  ColourScale colours = ColourScale::even;
  bool has_convention = false;  ///< amplitudes, whose title says which
  bool marks_bad = false;       ///< replaced pixels are marked on it, and it is not there without any
  std::vector<float> (*values)(const FilmResult& film) = nullptr;
};

/// All, in the order of page and print; a new one is one more row.
const std::vector<FilmMap>& film_maps();

/// How many standard errors an amplitude has at least; below, its phase says nothing.
inline constexpr double faint_below = 3;

std::string title_of(const FilmMap& map, const FilmResult& film);
/// What it shows of each pixel, rows from the top, NaN where nothing is known; empty where the film has it not.
std::vector<float> values_of(const FilmMap& map, const FilmResult& film);

/// A unit in a film: kelvin are digital levels in one of these.
std::string unit_in(const FilmInfo& film, std::string_view unit);

/// What is said of a map: "label", "title", "unit", "colours" (the word of its scale), "around" ("ends" or "zero", what
/// they are centred about), "cyclic", "marks".
Numbers words_of(const FilmMap& map, const FilmResult& film);

}  // namespace arenite::inference
