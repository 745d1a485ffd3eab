#pragma once
#include <map>
#include <string>
#include <string_view>

#include "model/film.hpp"

namespace arenite::io {

/// What a film says about itself as lines "key = value", for formats that have no place of their own for it.
std::string film_notes(const FilmInfo& info);

/// Takes what such lines say; other lines are left aside.
void take_notes(std::string_view text, FilmInfo& info);

/// The value of a line "time = ..." in s; NaN without one.
double noted_time(std::string_view text);

}  // namespace arenite::io
