#pragma once
#include <memory>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/thread_count.hpp"
#include "film_reading.hpp"
#include "io/film/written_format.hpp"
#include "progress.hpp"
#include "statistics/numbers.hpp"

namespace arenite::app {

/// Maps of a film, one number a pixel, with the names of their files and their units for a film in kelvin.
struct FilmMaps {
  struct Map {
    const char *name, *unit;
    const std::vector<float>* values;
  };
  int width = 0, height = 0;
  std::vector<Map> maps;  ///< empty ones are left out
};

/// A command that makes maps of one film: the film, where the maps go, and what is printed of them.
struct MapsOfFilm {
  std::string film, out;
  KeyOptions written{recipe::every_key<io::WrittenMaps>()};
  FilmReading reading;
  int threads = Threads{}.threads;
  bool json = false, quiet = false;

  /// The film itself; then --out and --format; then all others.
  void add_film(Options& command, const char* meaning);
  void add_out(Options& command);
  void add_others(Options& command);

  /// The film, after what should be known of it.
  std::unique_ptr<FilmSource> open() const;
  /// What `transform` makes of the film under a progress line; an InputError names the film. Without a pixel, and told,
  /// where the user stopped it.
  template <class Transform> auto made(Transform transform) const;
  /// Prints a sentence about the film.
  void tell(const std::string& sentence) const;
  /// Writes each of the maps into the folder, where one is named: NAME with the first ending of the format.
  void write(const FilmMaps& maps) const;
  /// Adds the size of the maps, and the median of each over its pixels in the unit of the film.
  static void describe(Numbers& numbers, const FilmMaps& maps, const FilmInfo& about);
  void print_numbers(const Numbers& numbers) const;
};

template <class Transform> auto MapsOfFilm::made(Transform transform) const {
  watch_for_signals();
  try {
    ProgressLine line(quiet || json);
    auto maps = transform(line);
    if (maps.size() == 0) line.notice("stopped; nothing was stored");
    return maps;
  } catch (const InputError& error) { throw in_file(error, film); }
}

}  // namespace arenite::app
