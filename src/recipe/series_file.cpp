#include "recipe/series_file.hpp"

#include <fmt/core.h>

#include <filesystem>
#include <string>

#include "core/error.hpp"
#include "core/units.hpp"
#include "io/table/laboratory_table.hpp"
#include "recipe/quantities.hpp"

namespace arenite::recipe {

void read_series_file(const Written& at, std::vector<Vec2>& rows, std::string_view unit) {
  const auto place = (std::filesystem::path(at.reading.folder) / at.node.text).string();
  try {
    io::LaboratoryTable table(place);
    if (table.columns() != 2)
      throw InputError(place, table.header_line(),
                       fmt::format("has {} columns; a programme has two, time and value", table.columns()));
    const auto x = table.values(0, {{"time"}, dimension::time, "s"}),
               y = table.values(1, {{table.title(1)}, dimension_of(unit), unit});
    for (std::size_t row = 0; row < x.size(); ++row) rows.push_back({x[row], y[row]});
    for (const std::string& note : table.notes()) at.reading.notices.push_back(fmt::format("{}: {}", place, note));
  } catch (const InputError& error) { at.refuse(error.what()); }
}

}  // namespace arenite::recipe
