#include "film_reading.hpp"

#include <fmt/core.h>

#include <filesystem>

#include "core/median.hpp"
#include "io/film/formats.hpp"
#include "io/film/written_format.hpp"
#include "print.hpp"
#include "workflow/result_folder.hpp"

namespace arenite::app {

void FilmReading::add_to(Options& command) {
  keys_.add(command, "--frame-rate", "film.frame_rate").type("FREQUENCY");
  keys_.add(command, "--scale", "film.scale").type("TEMPERATURE");
  keys_.add(command, "--offset", "film.offset").type("TEMPERATURE");
  keys_.add(command, "--dataset", "film.dataset").type("NAME");
}

io::FilmChoice FilmReading::choice() const {
  recipe::FilmSection section;
  read_options(section, keys_.given());
  return section.film.value_or(io::FilmChoice{});
}

std::vector<std::string> FilmReading::overrides() const {
  choice();  // refuses what is no such value by its option's name
  return keys_.overrides();
}

void tell_remarks(const std::string& file, const FilmInfo& film) {
  for (const std::string& remark : film.remarks) print(stderr, "{}: {}\n", file, remark);
}

std::string unit_of(const FilmInfo& film) { return film.quantity == FilmQuantity::kelvin ? "K" : "level"; }

Numbers medians(const FilmMaps& maps, const FilmInfo& film) {
  Numbers all = Numbers::tree();
  for (const auto& [name, unit, values] : maps.maps) {
    if (values->empty()) continue;
    const std::string own = *unit == 'K' ? unit_of(film) + (unit + 1) : unit;
    all[name] = statistics::described(median_of_finite(*values), own.c_str(),
                                      fmt::format("Median of the map \"{}\" over all pixels", name).c_str());
  }
  return all;
}

void write_maps(const std::string& folder, const std::vector<recipe::Given>& written, const FilmMaps& maps) {
  io::WrittenMaps asked;
  read_options(asked, written);
  workflow::make_folder(folder);
  const std::string ending(io::format_named(io::films::all, asked.format)->endings[0]);
  for (const auto& [name, unit, values] : maps.maps) {
    if (values->empty()) continue;
    Film film;
    film.about.width = maps.width;
    film.about.height = maps.height;
    film.about.frames = 1;
    film.about.floating = true;
    film.value = *values;
    io::write_film(std::filesystem::path(folder) / (std::string(name) + ending), film);
  }
}

}  // namespace arenite::app
