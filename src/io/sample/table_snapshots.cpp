#include "io/sample/table_snapshots.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "core/text.hpp"

namespace arenite::io {
namespace {

constexpr const char* moment_names[] = {"step", "frame", "time"};  // in those of columns

bool repeats(const Table& table, OwnColumns own) {
  std::set<std::vector<std::string_view>> seen;
  return std::ranges::any_of(table.rows, [&](const Table::Row& row) {
    std::vector<std::string_view> key;
    for (const std::string_view name : own)
      if (const auto at = table.find({name})) key.push_back(row.cells[*at]);
    return !key.empty() && !seen.insert(std::move(key)).second;
  });
}

}  // namespace

SnapshotsOfRows::SnapshotsOfRows(const Table& table, OwnColumns own) {
  const auto step = table.find({"step", "timestep", "frame"}), time = table.find({"time"});
  if (!step && !time) return;
  const std::size_t column = step ? *step : *time;
  Problems ignored;
  const double second = factor_or_problem(table.columns[column].unit, "", dimension::time, 1, 0, ignored);
  std::map<std::string_view, std::size_t> number;
  for (const auto& row : table.rows) {
    const std::string_view cell = row.cells[column];
    const auto [at, is_new] = number.emplace(cell, moments.size());
    of_row.push_back(at->second);
    if (!is_new) continue;
    Moment moment;
    if (step) moment.step = to_integer(cell);
    else if (const auto value = to_number(cell)) moment.time = *value * second;
    moments.push_back(moment);
  }
  if (!step && moments.size() > 1 && !repeats(table, own)) *this = {};  // another time, of birth, say
}

std::vector<std::size_t> SnapshotsOfRows::sizes() const {
  std::vector<std::size_t> sizes(moments.size());
  for (const std::size_t snapshot : of_row) ++sizes[snapshot];
  return sizes;
}

void SnapshotsOfRows::keep(std::size_t snapshot, Table& table) const {
  if (moments.size() < 2) return;
  std::vector<Table::Row> kept;
  for (std::size_t row = 0; row < table.rows.size(); ++row)
    if (of_row[row] == snapshot) kept.push_back(std::move(table.rows[row]));
  table.rows = std::move(kept);
}

std::vector<Moment> moments_of_rows(std::string_view text, const std::string& columns, OwnColumns own) {
  const std::string head = lower_case(columns.empty() ? text.substr(0, 4096) : std::string_view(columns));
  const auto is_named = [&](std::string_view name) { return head.find(name) != std::string::npos; };
  if (std::ranges::none_of(moment_names, is_named)) return {};
  Problems ignored;
  return SnapshotsOfRows(read_table(text, columns, ignored), own).moments;
}

}  // namespace arenite::io
