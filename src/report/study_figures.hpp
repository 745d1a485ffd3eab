#pragma once
#include <functional>
#include <string>
#include <vector>

#include "report/figure_list.hpp"
#include "statistics/estimate.hpp"
#include "study/collect.hpp"

namespace arenite::report {

/// One curve of a figure. Points have standard errors where several runs make one, NaN otherwise.
struct FigureCurve {
  std::string name;
  statistics::Curve points;
};

/// The numbers of a run as JSON, by its name; empty if it has none.
using NumbersOf = std::function<std::string(const std::string& run)>;

/// Curves of a figure from the runs of a study that are done: means over runs that differ in their seed alone, in the
/// order of `by`. Densities are means over all runs of a curve; `numbers` is asked for those only. Throws InputError for
/// a key that is not swept.
std::vector<FigureCurve> curves_of(const Figure& figure, const study::CollectedTable& table, const NumbersOf& numbers);

}  // namespace arenite::report
