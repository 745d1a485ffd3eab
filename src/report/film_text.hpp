#pragma once
#include <string>

#include "model/film_result.hpp"

namespace arenite::report {

/// What a film gave, as lines for people and as JSON for programs.
std::string film_text(const FilmResult& result);
std::string film_json(const FilmResult& result);

}  // namespace arenite::report
