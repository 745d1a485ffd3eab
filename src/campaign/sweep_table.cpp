#include <fmt/format.h>

#include <filesystem>

#include "io/read_file.hpp"
#include "io/table.hpp"
#include "campaign/sweep.hpp"

namespace arenite::study {
namespace {

/// A cell with the unit of its column; its place is the row of the table's file.
Node value_of(std::string_view cell, const std::string& unit, const std::string& file, int line) {
  Node value = parse_value(std::string(cell) + (unit.empty() ? "" : " " + unit));
  value.place = {line, 0, file};
  return value;
}

}  // namespace

std::vector<Point> table_points(const Node& file, Reading& reading, std::vector<std::string>& files) {
  std::vector<Point> points;
  if (file.kind != Node::Kind::text) {
    add_problem(reading, file.place, "sweep.table", "must be the name of a CSV table, for example \"runs.csv\"");
    return points;
  }
  const std::string path = (std::filesystem::path(reading.folder) / file.text).string();
  files.push_back(path);
  try {
    const std::string text = io::read_file(path);
    Problems problems(path);
    const io::Table table = io::read_table(text, "", problems);
    problems.raise();
    for (const auto& row : table.rows) {
      Point point;
      for (std::size_t c = 0; c < table.columns.size(); ++c)
        if (!row.cells[c].empty()) point.push_back({table.columns[c].written, value_of(row.cells[c], table.columns[c].unit, path, row.line)});
      points.push_back(std::move(point));
    }
    if (points.empty()) add_problem(reading, file.place, "sweep.table", fmt::format("{} holds no run; add rows below its header", path));
  } catch (const InputError& error) {
    reading.problems.insert(reading.problems.end(), error.problems().begin(), error.problems().end());
  }
  return points;
}

}  // namespace arenite::study
