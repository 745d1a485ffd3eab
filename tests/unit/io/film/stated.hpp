#pragma once
#include <algorithm>
#include <filesystem>
#include <string>

#include "io/film/formats.hpp"
#include "support/films.hpp"

namespace arenite::io {

inline std::filesystem::path data(const char* name) {
  return std::filesystem::path(ARENITE_SOURCE_DIR) / "tests/data/films" / name;
}

inline bool tells(const FilmSource& film, const std::string& part) {
  return std::ranges::any_of(film.info().remarks,
                             [&](const std::string& said) { return said.find(part) != std::string::npos; });
}

}  // namespace arenite::io
