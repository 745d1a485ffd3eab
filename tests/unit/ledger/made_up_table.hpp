#pragma once
#include <string>
#include <utility>
#include <vector>

#include "study/collect.hpp"

namespace arenite::ledger {

/// A run of a made-up study: swept values and numbers.
struct MadeUpRun {
  std::vector<std::string> values;
  std::vector<double> numbers;
  std::string status = "done";
};

inline study::CollectedTable made_up_table(const std::vector<std::string>& keys, const std::vector<std::string>& names, const std::vector<MadeUpRun>& runs) {
  study::CollectedTable table;
  for (const auto& key : keys) table.keys.push_back({key, ""});
  table.names = names;
  for (const auto& run : runs) {
    study::CollectedTable::Row row;
    row.status = run.status;
    row.values = run.values;
    for (std::size_t k = 0; k < names.size(); ++k)
      row.numbers.push_back(k < run.numbers.size() ? std::optional(study::Estimate{run.numbers[k], std::nullopt}) : std::nullopt);
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace arenite::ledger
