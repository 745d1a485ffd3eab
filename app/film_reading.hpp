#pragma once
#include <string>
#include <utility>
#include <vector>

#include "core/units.hpp"
#include "io/film/film.hpp"
#include "options.hpp"

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

/// Maps of a film, one number a pixel, with the names of their files.
struct FilmMaps {
  int width = 0, height = 0;
  std::vector<std::pair<const char*, const std::vector<float>*>> named;  ///< empty maps are left out
};

/// Writes every map into the folder, which is made: NAME.tif, NAME.npy or NAME.h5 for the formats tiff, npy, hdf5.
void write_maps(const std::string& folder, const std::string& format, const FilmMaps& maps);

}  // namespace arenite::app
