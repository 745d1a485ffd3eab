#include "report/document_parts.hpp"

#include <fmt/format.h>

#include <cstdlib>

namespace arenite::report {
namespace {

constexpr std::size_t history_rows = 1000;  // about as many as a figure has pixels across

/// Every k-th row and the last one.
std::vector<double> thinned(const std::vector<double>& values) {
  const std::size_t stride = (values.size() + history_rows - 1) / history_rows;
  std::vector<double> kept;
  for (std::size_t k = 0; k < values.size(); k += stride) kept.push_back(values[k]);
  if (!values.empty() && (values.size() - 1) % stride != 0) kept.push_back(values.back());
  return kept;
}

}  // namespace

Numbers history_of(const History& history, NumberBlock& block) {
  Numbers columns = Numbers::list();
  for (const History::Column& column : history.columns)
    columns.push_back({{"name", column.name}, {"unit", column.unit}, {"values", reference(block.add_reals(thinned(column.values)))}});
  return columns;
}

Numbers provenance_of(const Provenance& p) {
  Numbers options = Numbers::tree();
  for (const auto& [name, value] : p.options) options[name] = value;
  return {{"version", p.version}, {"stage", p.stage}, {"input_hash", p.input_hash}, {"seed", p.seed},
          {"kernel", p.kernel}, {"recipe", p.recipe}, {"options", options}};
}

void shorten(Numbers& value) {
  if (value.is_real()) value = std::strtod(fmt::format("{:.6g}", value.get<double>()).c_str(), nullptr);
  else
    for (Numbers& part : value) shorten(part);
}

}  // namespace arenite::report
