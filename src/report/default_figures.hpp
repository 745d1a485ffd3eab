#pragma once
#include <functional>
#include <string>
#include <vector>

#include "campaign/collect.hpp"
#include "report/figure_list.hpp"
#include "statistics/numbers.hpp"

namespace arenite::report {

/// A number of runs that one asks for first, where they have it.
struct MainNumber {
  std::string name, label;
};
std::vector<MainNumber> main_numbers(const campaign::CollectedTable& table);

/// What the page of a study without figures.toml shows: each main number against the swept key with the most values that are numbers, a curve
/// for each value of the next one; none where no key but the seed has two numbers.
std::vector<Figure> default_figures(const campaign::CollectedTable& table);

/// The runs as the page lists them: keys, main numbers, and a row a run with its values, numbers and a link to its page (empty: none).
Numbers runs_table(const campaign::CollectedTable& table, const std::function<std::string(const std::string& run)>& link);

}  // namespace arenite::report
