#pragma once
#include <string>
#include <vector>

#include "io/film/film.hpp"
#include "options.hpp"
#include "recipe/film_recipe.hpp"

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

}  // namespace arenite::app
