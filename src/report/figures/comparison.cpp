#include "report/figures/comparison.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "core/unit_names.hpp"

namespace arenite::report::figures {
namespace {

struct Letter {
  const char *name, *colour;
};
constexpr std::array<Letter, 2> letters{{{"A", "line 0"}, {"B", "line 1"}}};

std::string text_at(const Numbers& tree, const char* name) { return tree.value(name, std::string()); }

/// What numbers in one unit are multiplied by to be in another of the same dimension; 1 where units are none.
double factor_between(const std::string& unit, const std::string& wanted) {
  if (unit == wanted) return 1;
  try {
    const Unit from = parse_unit(unit), to = parse_unit(wanted);
    if (from.dimension == to.dimension) return from.factor / to.factor * std::pow(10, from.decade - to.decade);
  } catch (const InputError&) {}  // words, which no factor makes others of
  return 1;
}

Numbers multiplied(const Numbers& values, double by) {
  if (by == 1) return values;
  Numbers list = Numbers::list();
  for (const Numbers& value : values) list.push_back(value.is_number() ? Numbers(by * value.get<double>()) : value);
  return list;
}

/// The numbers of a series that lie along an axis.
bool lies_along(const std::string& name, const char* axis) {
  return *axis == 'x' ? name == "x" : name == "y" || name == "error" || name == "low" || name == "high";
}

void add_series(Numbers& panel, const Numbers& from, const Letter& letter) {
  for (const Numbers& series : from["series"]) {
    if (series.contains("silent")) continue;
    Numbers shown = series;
    for (const char* axis : {"x", "y"}) {
      const double by = factor_between(text_at(from[axis], "unit"), text_at(panel[axis], "unit"));
      for (auto&& [name, values] : shown.items())
        if (lies_along(name, axis)) values = multiplied(values, by);
    }
    shown["name"] = letter.name;
    shown["colour"] = letter.colour;
    panel["series"].push_back(std::move(shown));
  }
}

/// As far as the farther of both goes; open where one is.
void take_ends(Numbers& axis, const Numbers& other) {
  const double by = factor_between(text_at(other, "unit"), text_at(axis, "unit"));
  for (const char* end : {"low", "high"}) {
    if (!axis.contains(end)) continue;
    if (!other.contains(end)) {
      axis.erase(end);
      continue;
    }
    const double mine = axis[end].get<double>(), its = by * other[end].get<double>();
    axis[end] = *end == 'l' ? std::min(mine, its) : std::max(mine, its);
  }
}

std::optional<Numbers> joined(const Numbers& one, const Numbers& other) {
  Numbers panel{{"x", one["x"]}, {"y", one["y"]}, {"near", true}};
  panel["series"] = Numbers::list();
  for (const char* axis : {"x", "y"})
    if (text_at(one[axis], "label") != text_at(other[axis], "label") || one[axis].contains("names"))
      return std::nullopt;
  add_series(panel, one, letters[0]);
  add_series(panel, other, letters[1]);
  for (const char* axis : {"x", "y"}) take_ends(panel[axis], other[axis]);
  return panel;
}

}  // namespace

std::optional<Numbers> together(const Numbers& one, const Numbers& other) {
  if (!one.contains("panels") || !other.contains("panels") || one["panels"].empty() ||
      one["panels"].size() != other["panels"].size())
    return std::nullopt;
  Numbers drawing = Numbers::tree();
  drawing["panels"] = Numbers::list();
  for (std::size_t k = 0; k < one["panels"].size(); ++k) {
    auto panel = joined(one["panels"][k], other["panels"][k]);
    if (!panel) return std::nullopt;
    drawing["panels"].push_back(std::move(*panel));
  }
  drawing["key"] = Numbers::list();
  for (const Letter& letter : letters) drawing["key"].push_back({{"name", letter.name}, {"colour", letter.colour}});
  return drawing;
}

Numbers compared(const Numbers& head, const Numbers& one, const Numbers& other) {
  if (one.empty() || other.empty()) return {};
  auto drawing = together(one.front(), other.front());
  if (!drawing) return {};
  Numbers figure = head;
  if (head.contains("shown")) figure["caption"] = head["shown"];
  figure["drawing"] = std::move(*drawing);
  return figure;
}

}  // namespace arenite::report::figures
