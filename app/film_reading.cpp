#include "film_reading.hpp"

#include <fmt/core.h>

#include <filesystem>

#include "core/median.hpp"
#include "io/film/formats.hpp"
#include "print.hpp"
#include "workflow/result_folder.hpp"

namespace arenite::app {

double above_zero(const char* option, const std::string& text, Dimension dimension, const char* unit) {
  const double value = option_value(option, [&] { return parse_si(text, dimension, unit); });
  if (!(value > 0)) throw InputError(fmt::format("{} is {}; it must be above 0", option, text));
  return value;
}

void FilmReading::add_to(Options& command) {
  command.add("--frame-rate", frame_rate, "Frame rate, overriding the film's own, e.g. \"148 Hz\"").type("FREQUENCY");
  command.add("--scale", scale, "Temperature per level, e.g. \"0.01 K\": temperature = scale x level + offset")
      .type("TEMPERATURE");
  command.add("--offset", offset, "Temperature of level 0, e.g. \"273.15 K\"").type("TEMPERATURE");
  command
      .add("--dataset", dataset,
           "Dataset to read from an HDF5 file that holds several, or channel of a TIFF hyperstack (\"channel 2\")")
      .type("NAME");
}

io::FilmChoice FilmReading::choice() const {
  io::FilmChoice choice;
  choice.dataset = dataset;
  if (!frame_rate.empty()) choice.frame_rate = above_zero("--frame-rate", frame_rate, dimension::frequency, "Hz");
  if (!scale.empty()) choice.scale = above_zero("--scale", scale, dimension::temperature, "K");
  if (!offset.empty())
    choice.offset = option_value("--offset", [&] { return parse_si(offset, dimension::temperature, "K"); });
  return choice;
}

std::vector<std::string> FilmReading::overrides() const {
  choice();  // refuses what is no quantity by its option's name
  std::vector<std::string> set;
  const auto add = [&](const char* key, const std::string& value) {
    if (!value.empty()) set.push_back(fmt::format("film.{}=\"{}\"", key, value));
  };
  add("frame_rate", frame_rate);
  add("scale", scale);
  add("offset", offset);
  add("dataset", dataset);
  return set;
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

void write_maps(const std::string& folder, const std::string& format, const FilmMaps& maps) {
  workflow::make_folder(folder);
  const std::string ending(io::format_named(io::films::all, format)->endings[0]);
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
