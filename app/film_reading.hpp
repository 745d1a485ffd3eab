#pragma once
#include <string>
#include <vector>

#include "io/film.hpp"
#include "options.hpp"

namespace arenite::app {

/// Options that say of a film what it does not say itself, alike in every command that reads one.
struct FilmReading {
  std::string frame_rate, scale, offset, dataset;

  void add_to(Options& command);
  /// Throws InputError that names the option.
  io::FilmChoice choice() const;
  /// The same as overrides of a film's recipe.
  std::vector<std::string> overrides() const;
};

}  // namespace arenite::app
