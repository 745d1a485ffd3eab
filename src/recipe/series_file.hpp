#pragma once
#include <string_view>
#include <vector>

#include "recipe/values.hpp"

namespace arenite::recipe {

/// Reads the CSV file that a text names, of two columns, time and value; adds what is wrong with it.
void read_series_file(const Written& at, std::vector<Vec2>& rows, std::string_view unit);

}  // namespace arenite::recipe
