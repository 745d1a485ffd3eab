#pragma once
#include <map>
#include <string>
#include <vector>

#include "report/study_figures.hpp"

namespace arenite::report {

/// Whether a figure's `where` wants this run. Throws InputError for a key that is not swept, as all of these do.
bool is_wanted(const study::CollectedTable& table, const study::CollectedTable::Row& row, const Figure& figure);

/// Values of `by` among the wanted rows, numbers by size; one empty value where the figure has no `by`.
std::vector<std::string> groups_of(const study::CollectedTable& table, const Figure& figure);

/// The wanted rows with this value of `by`.
std::vector<const study::CollectedTable::Row*> rows_of(const study::CollectedTable& table, const Figure& figure, const std::string& group);

/// Unit of the values of `by`.
std::string unit_of(const study::CollectedTable& table, const Figure& figure);

/// Means over runs that differ in their seed alone, which know of how many runs each is.
class MeanRows {
 public:
  explicit MeanRows(const study::CollectedTable& runs);

  study::CollectedTable table;

  /// Points of `figure.x` and y by rising x, with their errors or deviations and the number of runs.
  void set_points(FigureCurve& curve, const std::vector<const study::CollectedTable::Row*>& rows, const Figure& figure, const std::string& y) const;

 private:
  std::size_t samples(const study::CollectedTable::Row& mean, const std::string& y) const;

  const study::CollectedTable& runs_;
  std::map<std::vector<std::string>, std::vector<const study::CollectedTable::Row*>> of_values_;
};

}  // namespace arenite::report
