#pragma once
#include <string>
#include <vector>

#include "core/units.hpp"
#include "io/film/film.hpp"
#include "options.hpp"
#include "statistics/numbers.hpp"

namespace arenite::app {

/// The value of an option in SI. Throws InputError that names it for what is no such quantity, or not above 0.
double above_zero(const char* option, const std::string& text, Dimension dimension, const char* unit);

/// Options that say of a film what it does not say itself, alike in every command that reads one.
struct FilmReading {
  std::string frame_rate, scale, offset, dataset;

  void add_to(Options& command);
  /// Throws InputError that names the option.
  io::FilmChoice choice() const;
  /// The same as overrides of a film's recipe.
  std::vector<std::string> overrides() const;
};

/// Prints what should be known of a film that was opened.
void tell_remarks(const std::string& file, const FilmInfo& film);

/// "K" or "level".
std::string unit_of(const FilmInfo& film);

/// Maps of a film, one number a pixel, with the names of their files and their units for a film in kelvin.
struct FilmMaps {
  struct Map {
    const char *name, *unit;
    const std::vector<float>* values;
  };
  int width = 0, height = 0;
  std::vector<Map> maps;  ///< empty ones are left out
};

/// The median of every map over its pixels, in the unit of the film.
Numbers medians(const FilmMaps& maps, const FilmInfo& film);

/// Writes every map into the folder, which is made: NAME with the first ending of the format.
void write_maps(const std::string& folder, const std::string& format, const FilmMaps& maps);

}  // namespace arenite::app
