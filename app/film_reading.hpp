#pragma once
#include <string>
#include <vector>

#include "io/film/film.hpp"
#include "options.hpp"
#include "recipe/film_recipe.hpp"
#include "statistics/numbers.hpp"

namespace arenite::app {

/// Options that say of a film what it does not say itself, alike in every command that reads one: [film] of a recipe.
class FilmReading {
 public:
  void add_to(Options& command);
  /// Throws InputError that names the option.
  io::FilmChoice choice() const;
  /// The same as overrides of a film's recipe.
  std::vector<std::string> overrides() const;

 private:
  KeyOptions keys_{recipe::every_key<recipe::FilmSection>()};
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
/// `written`: what is given of io::WrittenMaps.
void write_maps(const std::string& folder, const std::vector<recipe::Given>& written, const FilmMaps& maps);

}  // namespace arenite::app
