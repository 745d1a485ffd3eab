#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "campaign/collect.hpp"
#include "statistics/measured.hpp"
#include "validation/draw.hpp"

namespace arenite::validation {

/// The runs of one study that are done, with their numbers.
class StudyResults {
 public:
  StudyResults() = default;
  explicit StudyResults(campaign::CollectedTable table, std::filesystem::path folder = {});

  const campaign::CollectedTable& table() const { return table_; }
  const std::filesystem::path& folder() const { return folder_; }  ///< of the study; empty for made-up tables
  const std::vector<std::size_t>& done() const { return done_; }   ///< places of the rows that are done
  bool complete() const { return !table_.rows.empty() && done_.size() == table_.rows.size(); }
  double number(std::size_t row, std::string_view name) const;  ///< NaN if the run does not have it
  std::string value(std::size_t row,
                    std::string_view key) const;  ///< of a swept key, without the unit; empty if there is none

 private:
  campaign::CollectedTable table_;
  std::filesystem::path folder_;
  std::vector<std::size_t> done_;
  std::unordered_map<std::string, std::size_t> columns_;
};

/// One run: its numbers by flat name ("coordination.all") and its swept values.
struct Run {
  const StudyResults* study;
  std::size_t row;
  double operator()(std::string_view name) const { return study->number(row, name); }
  double key(std::string_view name) const;  ///< a swept value as a number; NaN if it is none
  std::string text(std::string_view name) const { return study->value(row, name); }
  std::filesystem::path folder() const;  ///< with its stage files
};

/// A number of a run: by its flat name, or worked out from several.
struct Number {
  Number(const char* flat_name) : of([name = std::string(flat_name)](const Run& run) { return run(name); }) {}
  Number(std::string flat_name) : of([name = std::move(flat_name)](const Run& run) { return run(name); }) {}
  template <class F>
  requires std::is_invocable_r_v<double, F, const Run&> Number(F work_out) : of(std::move(work_out)) {}
  std::function<double(const Run&)> of;
};

/// The runs that claims are judged by.
class Results {
 public:
  void add(const std::string& study, campaign::CollectedTable table, std::filesystem::path folder = {});
  /// Of a study that was not added: no runs.
  const StudyResults& study(const std::string& name) const;
  const campaign::CollectedTable& table(const std::string& study_name) const { return study(study_name).table(); }
  std::vector<Run> runs(const std::string& study_name, const Where& where = {}) const;

 private:
  std::map<std::string, StudyResults> studies_;
};

/// Mean over runs and its standard error from their scatter; runs without the number are left out.
statistics::Measured mean(const Results& results, const std::string& study, const Number& number,
                          const Where& where = {});

/// Means over the runs of each value of a swept key, in rising order of the key.
struct Point {
  double x = 0, mean = 0, error = 0;  ///< error NaN for one run
  std::size_t runs = 0;
  double freedom = statistics::unknown;  ///< behind the error, where that is not of these runs alone
};
using Series = std::vector<Point>;
/// `x` gives what runs are put together by; usually Number that reads a swept key, see swept().
Series series(const Results& results, const std::string& study, const Number& x, const Number& y,
              const Where& where = {});
/// A swept key as a number.
Number swept(std::string key);

}  // namespace arenite::validation
