#pragma once
#include <functional>
#include <string>
#include <vector>

#include "campaign/collect.hpp"
#include "report/figure_list.hpp"
#include "report/figures/headlines.hpp"
#include "statistics/numbers.hpp"

namespace arenite::report {

using Headlines = std::vector<figures::Headline>;

/// What stands at an axis for a swept key or a number: its words with its unit, or as much as its statistic says of it
/// up to the first comma.
std::string label_of(const campaign::CollectedTable& table, const std::string& name);

/// A swept key, and those that take other values whenever it does.
struct SweptAxis {
  std::size_t place = 0;  ///< among the table's keys
  std::vector<std::string> with = {};
  std::size_t values = 0;
  bool is_numeric = false;
};
/// All but the seed, those with numbers and the most of them first.
std::vector<SweptAxis> swept_axes(const campaign::CollectedTable& table);

/// What the page of a study without figures.toml shows: what one asks first of its kind of test, and each main number,
/// against the swept key with the most values that are numbers, a curve for each value of the next one and a figure for
/// each combination of further ones; none where no key but the seed has two numbers.
std::vector<Figure> default_figures(const campaign::CollectedTable& table, const Headlines& first = {});

/// The runs as the page lists them: keys, main numbers, and a row a run with its values, numbers and a link to its page
/// (empty: none).
Numbers runs_table(const campaign::CollectedTable& table, const Headlines& first,
                   const std::function<std::string(const std::string& run)>& link);

}  // namespace arenite::report
