#include "campaign/sweep.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string_view>
#include <utility>

#include "campaign/sweep_latin_hypercube.hpp"
#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "core/text.hpp"
#include "io/table/table.hpp"
#include "io/table/text_file.hpp"

namespace arenite::campaign {
namespace {

/// A cell with the unit of its column; its place is the row of the table's file.
recipe::Node value_of(std::string_view cell, const std::string& unit, const std::string& file, int line) {
  recipe::Node value = recipe::parse_value(std::string(cell) + (unit.empty() ? "" : " " + unit));
  value.place = {line, 0, file};
  return value;
}

void read_runs_table(const recipe::Node& file, recipe::Reading& reading, Sweep& sweep) {
  std::vector<Point>& points = sweep.axes.emplace_back();
  if (file.kind != recipe::Node::Kind::text)
    return add_problem(reading, file.place, "sweep.table", "must be the name of a CSV table, for example \"runs.csv\"");
  const std::string path = (std::filesystem::path(reading.folder) / file.text).string();
  sweep.files.push_back(path);
  try {
    const std::string text = io::read_text(path);
    Problems problems(path);
    const io::Table table = io::read_table(text, "", problems);
    problems.raise();
    for (const auto& row : table.rows) {
      Point point;
      for (std::size_t c = 0; c < table.columns.size(); ++c)
        if (!row.cells[c].empty())
          point.push_back({table.columns[c].written, value_of(row.cells[c], table.columns[c].unit, path, row.line)});
      points.push_back(std::move(point));
    }
    if (points.empty())
      add_problem(reading, file.place, "sweep.table", fmt::format("{} holds no run; add rows below its header", path));
  } catch (const InputError& error) {
    reading.problems.insert(reading.problems.end(), error.problems().begin(), error.problems().end());
  }
}

const auto no_table = [](const recipe::Node&) { return false; };

void read_grid(const recipe::Node& section, recipe::Reading& reading, Sweep& sweep) {
  if (section.kind != recipe::Node::Kind::table) {
    return add_problem(reading, section.place, "sweep.grid",
                       fmt::format("is {}, but must be a section [sweep.grid] of keys with lists", kind_name(section)));
  }
  for (auto& [key, values] : flattened(section, no_table)) {
    if (values.kind != recipe::Node::Kind::array || values.items.empty()) {
      add_problem(reading, values.place, "sweep.grid." + key,
                  "must be a list of the values that the key takes, for example [1, 1.25, 1.67]");
      continue;
    }
    sweep.axes.push_back(mapped(values.items, [&key = key](const recipe::Node& value) { return Point{{key, value}}; }));
  }
}

void read_list(const recipe::Node& list, recipe::Reading& reading, Sweep& sweep) {
  std::vector<Point> axis;
  if (list.kind != recipe::Node::Kind::array || list.items.empty()) {
    return add_problem(reading, list.place, "sweep.list",
                       "must be tables [[sweep.list]], one per run, of keys with their values");
  }
  for (const auto& item : list.items) {
    if (item.kind == recipe::Node::Kind::table) axis.push_back(flattened(item, no_table));
    else
      add_problem(reading, item.place, "sweep.list",
                  fmt::format("holds {}, but must hold tables [[sweep.list]]", kind_name(item)));
  }
  sweep.axes.push_back(std::move(axis));
}

void read_replicates(const recipe::Node& value, recipe::Reading& reading, Sweep& sweep) {
  if (value.kind == recipe::Node::Kind::integer && value.integer >= 1 &&
      value.integer <= static_cast<std::int64_t>(most_runs)) {
    sweep.replicates = value.integer;
  } else {
    add_problem(reading, value.place, "sweep.replicates",
                fmt::format("must be a whole number from 1 to {}, the number of seeds of each combination", most_runs));
  }
}

void read_seeds(const recipe::Node& value, recipe::Reading& reading, Sweep& sweep) {
  if (value.kind == recipe::Node::Kind::text && value.text == "hashed") sweep.seeds = Sweep::Seeds::hashed;
  else if (value.kind != recipe::Node::Kind::text || value.text != "consecutive")
    add_problem(reading, value.place, "sweep.seeds",
                "must be \"consecutive\" (seed, seed + 1, ... for every combination) or \"hashed\" (every packing has "
                "seeds of its own)");
}

/// A key may be swept in one way only.
void refuse_doubles(const Sweep& sweep, recipe::Reading& reading) {
  std::map<std::string, std::size_t> axis_of;
  for (std::size_t a = 0; a < sweep.axes.size(); ++a)
    for (const Point& point : sweep.axes[a])
      for (const auto& [key, value] : point) {
        if (sweep.replicates > 0 && key == "seed")
          add_problem(reading, value.place, "sweep",
                      "seed: replicates give each run its seed; leave out one of the two");
        if (axis_of.emplace(key, a).first->second != a)
          add_problem(reading, value.place, "sweep", fmt::format("{}: is swept twice; keep one", key));
      }
}

}  // namespace

std::vector<Assignment> flattened(const recipe::Node& table, const std::function<bool(const recipe::Node&)>& is_leaf) {
  std::vector<Assignment> out;
  for (const auto& [key, place, value] : table.entries) {
    if (value.kind != recipe::Node::Kind::table || is_leaf(value)) out.push_back({key, value});
    else
      for (auto& inner : flattened(value, is_leaf)) out.push_back({key + "." + inner.key, std::move(inner.value)});
  }
  return out;
}

std::size_t Sweep::combinations() const {
  std::size_t count = 1;
  for (const auto& axis : axes) {
    if (axis.size() > most_runs || count * axis.size() > most_runs) return most_runs + 1;
    count *= axis.size();
  }
  return count;
}

Point Sweep::combination(std::size_t index) const {
  std::vector<const Point*> parts;
  for (auto axis = axes.rbegin(); axis != axes.rend(); ++axis) {
    parts.push_back(&(*axis)[index % axis->size()]);
    index /= axis->size();
  }
  Point point;
  for (auto part = parts.rbegin(); part != parts.rend(); ++part)
    point.insert(point.end(), (*part)->begin(), (*part)->end());
  return point;
}

std::vector<std::string> Sweep::keys() const {
  std::vector<std::string> keys;
  for (const auto& axis : axes)
    for (const Point& point : axis)
      for (const auto& assignment : point)
        if (std::find(keys.begin(), keys.end(), assignment.key) == keys.end()) keys.push_back(assignment.key);
  return keys;
}

Sweep read_sweep(const recipe::Node& section, recipe::Reading& reading, std::uint64_t seed) {
  Sweep sweep;
  sweep.place = section.place;
  if (section.kind != recipe::Node::Kind::table) {
    add_problem(reading, section.place, "sweep",
                fmt::format("is {}, but must be a section [sweep]", kind_name(section)));
    return sweep;
  }
  const std::vector<std::string> known{"grid", "latin_hypercube", "list", "replicates", "seeds", "table"};
  for (const auto& [key, place, value] : section.entries) {
    if (key == "grid") read_grid(value, reading, sweep);
    else if (key == "list") read_list(value, reading, sweep);
    else if (key == "table") read_runs_table(value, reading, sweep);
    else if (key == "latin_hypercube") sweep.axes.push_back(latin_hypercube_points(value, reading, seed));
    else if (key == "replicates") read_replicates(value, reading, sweep);
    else if (key == "seeds") read_seeds(value, reading, sweep);
    else {
      const std::string near = nearest(key, known);
      add_problem(reading, place, "sweep." + key,
                  near.empty()
                      ? fmt::format("unknown key; the keys here are: {}; keys of the recipe go into [sweep.grid]",
                                    list_of(known))
                      : fmt::format("unknown key; did you mean {}?", near));
    }
  }
  refuse_doubles(sweep, reading);
  const std::size_t runs = sweep.combinations();
  if (runs > most_runs || runs * static_cast<std::size_t>(std::max<std::int64_t>(sweep.replicates, 1)) > most_runs)
    add_problem(reading, section.place, "sweep", fmt::format("gives more than {} runs; sweep fewer values", most_runs));
  if (reading.problems.empty() && sweep.axes.empty() && sweep.replicates == 0)
    add_problem(
        reading, section.place, "sweep",
        "holds nothing to sweep; add [sweep.grid], [[sweep.list]], table, [sweep.latin_hypercube] or replicates");
  return sweep;
}

}  // namespace arenite::campaign
