#include "validation/results.hpp"

#include <cmath>

#include "io/table/table.hpp"

namespace arenite::validation {
namespace {

double as_number(const std::string& text) { return io::to_number(text).value_or(statistics::unknown); }

bool fits(const Run& run, const Where& where) {
  for (const auto& [key, wanted] : where) {
    const std::string value = run.text(key);
    if (value != wanted && !(as_number(value) == as_number(wanted))) return false;
  }
  return true;
}

}  // namespace

StudyResults::StudyResults(campaign::CollectedTable table, std::filesystem::path folder)
    : table_(std::move(table)),
      folder_(std::move(folder)) {
  for (std::size_t row = 0; row < table_.rows.size(); ++row)
    if (table_.rows[row].status == "done") done_.push_back(row);
  for (std::size_t column = 0; column < table_.names.size(); ++column) columns_.emplace(table_.names[column], column);
}

double StudyResults::number(std::size_t row, std::string_view name) const {
  const auto at = columns_.find(std::string(name));
  return at == columns_.end() ? statistics::unknown : table_.rows[row].numbers[at->second].value;
}

std::string StudyResults::value(std::size_t row, std::string_view key) const {
  for (std::size_t k = 0; k < table_.keys.size(); ++k)
    if (table_.keys[k].name == key) return table_.rows[row].values[k];
  return {};
}

double Run::key(std::string_view name) const { return as_number(text(name)); }

std::filesystem::path Run::folder() const { return study->folder() / "runs" / study->table().rows[row].run; }

void Results::add(const std::string& study, campaign::CollectedTable table, std::filesystem::path folder) {
  studies_.insert_or_assign(study, StudyResults(std::move(table), std::move(folder)));
}

const StudyResults& Results::study(const std::string& name) const {
  static const StudyResults none;
  const auto at = studies_.find(name);
  return at == studies_.end() ? none : at->second;
}

std::vector<Run> Results::runs(const std::string& study_name, const Where& where) const {
  const StudyResults& all = study(study_name);
  std::vector<Run> runs;
  for (const std::size_t row : all.done())
    if (const Run run{&all, row}; fits(run, where)) runs.push_back(run);
  return runs;
}

statistics::Measured mean(const Results& results, const std::string& study, const Number& number, const Where& where) {
  std::vector<double> values;
  for (const Run& run : results.runs(study, where))
    if (const double value = number.of(run); std::isfinite(value)) values.push_back(value);
  return values.empty() ? statistics::Measured{} : statistics::mean_of(values);
}

Series series(const Results& results, const std::string& study, const Number& x, const Number& y, const Where& where) {
  std::map<double, std::vector<double>> groups;
  for (const Run& run : results.runs(study, where)) {
    const double at = x.of(run), value = y.of(run);
    if (std::isfinite(at) && std::isfinite(value)) groups[at].push_back(value);
  }
  Series points;
  for (const auto& [at, values] : groups) {
    const auto m = statistics::mean_of(values);
    points.push_back({at, m.value, m.error, values.size()});
  }
  return points;
}

Number swept(std::string key) {
  return [key = std::move(key)](const Run& run) { return run.key(key); };
}

}  // namespace arenite::validation
