#include "film_maps.hpp"

#include <fmt/core.h>

#include <filesystem>

#include "core/median.hpp"
#include "io/film/film.hpp"
#include "io/film/formats.hpp"
#include "print.hpp"
#include "statistics/numbers_text.hpp"
#include "workflow/result_folder.hpp"

namespace arenite::app {

using statistics::described;

void MapsOfFilm::add_film(Options& command, const char* meaning) {
  command.add("film", film, meaning).required().type("FILM");
}

void MapsOfFilm::add_out(Options& command) {
  command.add("--out", out, "Folder for the maps; if not given, nothing is stored").type("DIR");
  written.add(command, "--format", "format");
}

void MapsOfFilm::add_others(Options& command) {
  reading.add_to(command);
  add_threads(command, threads);
  add_json(command, json);
  add_quiet(command, quiet);
}

std::unique_ptr<FilmSource> MapsOfFilm::open() const {
  auto opened = io::open_film(film, reading.choice());
  tell_remarks(film, opened->info());
  return opened;
}

void MapsOfFilm::tell(const std::string& sentence) const { print(stderr, "{}: {}\n", film, sentence); }

void MapsOfFilm::write(const FilmMaps& maps) const {
  if (out.empty()) return;
  io::WrittenMaps asked;
  read_options(asked, written.given());
  workflow::make_folder(out);
  const std::string ending(io::format_named(io::films::all, asked.format)->endings[0]);
  for (const auto& [name, unit, values] : maps.maps) {
    if (values->empty()) continue;
    Film one;
    one.about.width = maps.width;
    one.about.height = maps.height;
    one.about.frames = 1;
    one.about.floating = true;
    one.value = *values;
    io::write_film(std::filesystem::path(out) / (std::string(name) + ending), one);
  }
}

void MapsOfFilm::describe(Numbers& numbers, const FilmMaps& maps, const FilmInfo& about) {
  numbers["width"] = described(maps.width, "", "Pixels along x");
  numbers["height"] = described(maps.height, "", "Pixels along y");
  Numbers medians = Numbers::tree();
  for (const auto& [name, unit, values] : maps.maps) {
    if (values->empty()) continue;
    const std::string own = *unit == 'K' ? unit_of(about) + (unit + 1) : unit;
    medians[name] = described(median_of_finite(*values), own.c_str(),
                              fmt::format("Median of the map \"{}\" over all pixels", name).c_str());
  }
  numbers["median"] = medians;
}

void MapsOfFilm::print_numbers(const Numbers& numbers) const {
  print("{}", json ? to_json(numbers, 2) + "\n" : to_text(numbers));
}

}  // namespace arenite::app
