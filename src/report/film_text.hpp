#pragma once
#include <string>

#include "model/film_result.hpp"
#include "statistics/numbers.hpp"

namespace arenite::report {

/// What a film gave, as lines for people and as JSON for programs.
std::string film_text(const FilmResult& result);
Numbers film_numbers(const FilmResult& result);

}  // namespace arenite::report
