#include "thermal/identify/findings.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/unit_names.hpp"

namespace arenite::identify {
namespace {

Numbers numbers(const Finding& f) {
  const auto interval = statistics::confidence_95(f.value);
  Numbers j{{"value", f.value.value}, {"error", f.value.error}, {"confidence_95", {interval.low, interval.high}}};
  j["unit"] = f.unit.empty() ? "1" : si_unit(parse_unit(f.unit).dimension);
  j.means({j["unit"].get<std::string>(), f.sentence});
  if (std::isfinite(f.value.freedom)) j["degrees_of_freedom"] = f.value.freedom;
  if (f.stated) j["stated"] = {{"value", f.stated->value}, {"agrees", agrees(f)}};
  return j;
}

Numbers numbers(const Group& group) {
  Numbers j{{"name", group.name}};
  if (group.count > 0) j["count"] = statistics::described(group.count, "", "Number of values or points used");
  for (const auto& f : group.findings) j[f.name] = numbers(f);
  for (const auto& test : group.tests) j["tests"].push_back(numbers(test));
  return j;
}

/// Decimal places of what is printed to half a digit.
int places_of(double half_digit) { return std::max(0, static_cast<int>(std::lround(-std::log10(2 * half_digit)))); }

std::string comparison(const Finding& f) {
  const double stated = f.stated->value / f.scale(), half = f.stated->half_digit / f.scale(),
               ours = f.value.value / f.scale();
  const int places = places_of(half);
  if (agrees(f)) return fmt::format("stated {:.{}f}: agrees", stated, places);
  return fmt::format("stated {:.{}f}, here {:.{}f}: differs by {:+.{}f} ({:+.2g} %)", stated, places, ours, places,
                     ours - stated, places + 1, 100 * (ours / stated - 1));
}

std::string line(const Finding& f) {
  const double scale = f.scale();
  std::string text = statistics::with_error({f.value.value, f.value.error}, 1 / scale);
  if (!f.unit.empty()) text += " " + f.unit;
  const auto interval = statistics::confidence_95(f.value);
  if (std::isfinite(interval.low) && interval.high > interval.low)
    text += fmt::format("  (95 %: {:.4g} to {:.4g})", interval.low / scale, interval.high / scale);
  if (f.stated) text += "  " + comparison(f);
  return text;
}

std::string readable(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

}  // namespace

double Constant::scale() const {
  const Unit shown = parse_unit(unit.empty() ? "1" : unit);
  return shown.factor * std::pow(10, shown.decade);
}

Numbers numbers(const Identification& i) {
  Numbers j{{"kind", i.kind}, {"file", i.file}, {"groups", Numbers::list()}};
  for (const auto& group : i.groups) j["groups"].push_back(numbers(group));
  if (i.all) j["all"] = numbers(*i.all);
  j["notes"] = i.notes;
  return j;
}

bool agrees(const Finding& f) {
  return f.stated && std::abs(f.value.value - f.stated->value) <=
                         f.stated->half_digit * (1 + 1e-9) + 1e-12 * std::abs(f.value.value);
}

std::string to_text(const Identification& i) {
  std::vector<std::pair<std::string, std::string>> rows;
  std::string meanings, text;
  std::vector<Group> groups = i.groups;
  if (i.all) groups.push_back(*i.all);
  for (const Group& group : groups) {
    const std::string counted = group.count > 0 ? fmt::format("{} ({})", group.name, group.count) : group.name;
    for (const auto& f : group.findings) {
      rows.emplace_back((counted.empty() ? "" : counted + ": ") + readable(f.name), line(f));
      const std::string meaning = fmt::format("{}: {}\n", readable(f.name), f.sentence);
      if (meanings.find(meaning) == std::string::npos) meanings += meaning;
    }
    for (const auto& test : group.tests)
      for (const auto& f : test.findings) rows.emplace_back("  " + test.name + ": " + readable(f.name), line(f));
  }
  std::size_t width = 34;
  for (const auto& [name, value] : rows) width = std::max(width, name.size());
  for (const auto& [name, value] : rows) text += fmt::format("{:<{}} {}\n", name, width, value);
  for (const auto& note : i.notes) meanings += "note: " + note + "\n";
  return text + meanings;
}

}  // namespace arenite::identify
