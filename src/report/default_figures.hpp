#pragma once
#include <functional>
#include <string>
#include <vector>

#include "campaign/collect.hpp"
#include "report/figure_list.hpp"
#include "statistics/numbers.hpp"

namespace arenite::report {

/// What stands at an axis for a swept key or a number: its name with its unit, or as much as its statistic says of it
/// up to the first comma.
std::string label_of(const campaign::CollectedTable& table, const std::string& name);

/// What the page of a study without figures.toml shows: each main number against the swept key with the most values
/// that are numbers, a curve for each value of the next one; none where no key but the seed has two numbers.
std::vector<Figure> default_figures(const campaign::CollectedTable& table);

/// The runs as the page lists them: keys, main numbers, and a row a run with its values, numbers and a link to its page
/// (empty: none).
Numbers runs_table(const campaign::CollectedTable& table,
                   const std::function<std::string(const std::string& run)>& link);

}  // namespace arenite::report
