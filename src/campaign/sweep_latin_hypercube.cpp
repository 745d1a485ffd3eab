#include "campaign/sweep_latin_hypercube.hpp"

#include <fmt/core.h>

#include <charconv>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "campaign/study.hpp"
#include "campaign/sweep.hpp"
#include "core/hash.hpp"
#include "core/mapped.hpp"
#include "core/random.hpp"
#include "core/text.hpp"
#include "core/unit_names.hpp"
#include "core/units.hpp"

namespace arenite::campaign {
namespace {

/// An interval of a key, its ends as numbers of one unit.
struct Interval {
  double low = 0, high = 1;
  std::string unit;
  bool logarithmic = false, whole = false;
};

/// The number and the unit of "27.35 kN/mm".
std::pair<double, std::string> number_and_unit(const std::string& text) {
  double number = 0;
  const char* const end = std::from_chars(text.data(), text.data() + text.size(), number).ptr;
  return {number, std::string(trimmed(end))};
}

/// Reads "1 kN/mm .. 10 kN/mm". Throws InputError without place.
Interval interval_of(const std::string& text) {
  const auto dots = text.find("..");
  if (dots == std::string::npos)
    throw InputError("must be two values with two dots between them, for example \"1 kN/mm .. 10 kN/mm\"");
  const std::string low(trimmed(std::string_view(text).substr(0, dots))),
      high(trimmed(std::string_view(text).substr(dots + 2)));
  const Quantity a = parse_quantity(low), b = parse_quantity(high);
  if (!(a.dimension == b.dimension))
    throw InputError(fmt::format("\"{}\" is {}, but \"{}\" is {}; give both ends in units of one kind", low,
                                 describe(a.dimension), high, describe(b.dimension)));
  if (!(a.value < b.value))
    throw InputError(fmt::format("\"{}\" is not below \"{}\"; begin with the smaller end", low, high));
  const auto [low_number, low_unit] = number_and_unit(low);
  const auto [high_number, high_unit] = number_and_unit(high);
  if (low_unit == high_unit) return {low_number, high_number, low_unit};
  return {a.value, b.value, si_unit(a.dimension)};
}

std::optional<Interval> read_interval(const Assignment& entry, recipe::Reading& reading) {
  const std::string path = "sweep.latin_hypercube." + entry.key;
  const recipe::Node* range = &entry.value;
  bool logarithmic = false, whole = false;
  if (entry.value.kind == recipe::Node::Kind::table) {
    range = &entry.value.find("range")->value;
    for (const auto& [key, place, value] : entry.value.entries) {
      if (key == "range") continue;
      if (key == "scale" && value.kind == recipe::Node::Kind::text && (value.text == "log" || value.text == "linear"))
        logarithmic = value.text == "log";
      else if (key == "whole" && value.kind == recipe::Node::Kind::flag) whole = value.flag;
      else
        add_problem(
            reading, place, path,
            fmt::format("{}: besides range, only scale = \"linear\" or \"log\" and whole = true are allowed", key));
    }
  }
  try {
    if (range->kind != recipe::Node::Kind::text)
      throw InputError("must be a range in quotes, for example \"0.1 .. 0.5\"");
    Interval interval = interval_of(range->text);
    interval.logarithmic = logarithmic;
    interval.whole = whole;
    if (logarithmic && interval.low <= 0) throw InputError("a logarithmic range must begin above zero");
    return interval;
  } catch (const InputError& error) {
    add_problem(reading, range->place, path, error.what());
    return std::nullopt;
  }
}

recipe::Node value_at(const Interval& interval, double share, const recipe::Place& place) {
  const double at = interval.logarithmic ? interval.low * std::pow(interval.high / interval.low, share)
                                         : interval.low + share * (interval.high - interval.low);
  recipe::Node value;
  if (interval.whole) {
    value.kind = recipe::Node::Kind::integer;
    value.integer = static_cast<std::int64_t>(std::llround(at));
  } else if (!interval.unit.empty()) {
    value.kind = recipe::Node::Kind::text;
    value.text = fmt::format("{:.9g} {}", at, interval.unit);
  } else {
    value = recipe::parse_value(fmt::format("{:.9g}", at));
  }
  value.place = place;
  return value;
}

/// One share of each of `runs` equal strata, in random order. The stream is the key's own, so that a key more or less
/// changes nothing for the others.
std::vector<double> stratified_shares(std::size_t runs, const std::string& key, std::uint64_t seed) {
  const std::uint64_t index = std::stoull(content_hash(key).substr(0, 16), nullptr, 16);
  RandomStream random(seed, Purpose::sweep, index);
  std::vector<std::size_t> stratum(runs);
  std::iota(stratum.begin(), stratum.end(), std::size_t{0});
  for (std::size_t k = runs; k > 1; --k) std::swap(stratum[k - 1], stratum[random.below(k)]);
  return mapped(stratum,
                [&](std::size_t s) { return (static_cast<double>(s) + random.uniform()) / static_cast<double>(runs); });
}

}  // namespace

std::vector<Point> latin_hypercube_points(const recipe::Node& section, recipe::Reading& reading, std::uint64_t seed) {
  const std::string path = "sweep.latin_hypercube";
  std::vector<Point> points;
  if (section.kind != recipe::Node::Kind::table) {
    add_problem(reading, section.place, path,
                "must be a section [sweep.latin_hypercube] of runs = 100 and keys with their ranges");
    return points;
  }
  const recipe::Entry* runs = section.find("runs");
  if (!runs || runs->value.kind != recipe::Node::Kind::integer || runs->value.integer < 1 ||
      runs->value.integer > static_cast<std::int64_t>(most_runs)) {
    add_problem(reading, runs ? runs->value.place : section.place, path,
                fmt::format("must state runs = N, a whole number from 1 to {}", most_runs));
    return points;
  }
  points.resize(static_cast<std::size_t>(runs->value.integer));
  const auto is_range = [](const recipe::Node& table) { return table.find("range") != nullptr; };
  for (const Assignment& entry : flattened(section, is_range)) {
    if (entry.key == "runs") continue;
    const auto interval = read_interval(entry, reading);
    if (!interval) continue;
    const auto shares = stratified_shares(points.size(), entry.key, seed);
    for (std::size_t r = 0; r < points.size(); ++r)
      points[r].push_back({entry.key, value_at(*interval, shares[r], entry.value.place)});
  }
  if (section.entries.size() == 1)
    add_problem(reading, section.place, path,
                "holds no key with a range, such as \"contact.friction\" = \"0.1 .. 0.5\"");
  return points;
}

}  // namespace arenite::campaign
