#include "film_reading.hpp"

#include "print.hpp"

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

}  // namespace arenite::app
