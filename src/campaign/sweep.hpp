#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "recipe/document.hpp"
#include "recipe/reader.hpp"
#include "recipe/recipe.hpp"

namespace arenite::campaign {

/// One key of a recipe, dotted as in --set, with a value for it; the value keeps the place where it was written.
struct Assignment {
  std::string key;
  recipe::Node value;
};
using Point = std::vector<Assignment>;

/// What [sweep] asks for: every combination of a point of each axis. A key of [sweep.grid] is an axis of its own;
/// [[sweep.list]], sweep.table and [sweep.latin_hypercube] are one axis each. The last axis varies fastest.
struct Sweep {
  enum class Seeds { consecutive, hashed };
  std::vector<std::vector<Point>> axes;
  std::int64_t replicates = 0;  ///< runs of each combination with seeds of their own; 0: the recipe's seed
  Seeds seeds = Seeds::consecutive;
  std::vector<std::string> files;  ///< that it was read from, beside the recipe
  recipe::Place place = {};        ///< of its section

  std::size_t combinations() const;
  Point combination(std::size_t index) const;
  std::vector<std::string> keys() const;  ///< in the order of the axes, each once
};

/// Reads the section [sweep]. `seed` is the recipe's own: it seeds the Latin hypercube. Problems are collected in
/// `reading`.
Sweep read_sweep(const recipe::Node& section, recipe::Reading& reading, std::uint64_t seed);

/// More runs than anybody means to ask for.
inline constexpr std::size_t most_runs = 1'000'000;

/// Dotted keys of a table and of the tables in it; `is_leaf` says which tables are values by themselves.
std::vector<Assignment> flattened(const recipe::Node& table, const std::function<bool(const recipe::Node&)>& is_leaf);

}  // namespace arenite::campaign
