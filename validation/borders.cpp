#include "validation/borders.hpp"

#include <fmt/core.h>

#include <map>

#include "core/error.hpp"
#include "workflow/result_folder.hpp"

namespace arenite::validation {

std::string with_border(const std::string& study, double border) {
  return fmt::format("{}, border {:g}", study, border);
}

void add_with_border(Results& results, const std::string& study, double border,
                     const std::function<bool(const Run&)>& wanted) {
  campaign::CollectedTable table;
  table.keys = results.table(study).keys;
  std::map<std::string, std::size_t> columns;
  for (const Run& run : results.runs(study)) {
    if (!wanted(run)) continue;
    auto row = run.study->table().rows[run.row];
    row.numbers.assign(table.names.size(), {});
    try {
      for (const auto& [name, estimate, meaning] :
           campaign::flat_numbers(workflow::numbers(workflow::final_state(run.folder(), {.border = border}), false))) {
        const auto [column, added] = columns.try_emplace(name, table.names.size());
        if (added) table.names.push_back(name);
        row.numbers.resize(table.names.size());
        row.numbers[column->second] = estimate;
      }
    } catch (const InputError&) { continue; }
    table.rows.push_back(std::move(row));
  }
  for (auto& row : table.rows) row.numbers.resize(table.names.size());
  results.add(with_border(study, border), std::move(table), results.study(study).folder());
}

}  // namespace arenite::validation
