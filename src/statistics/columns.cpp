#include "statistics/columns.hpp"

#include <algorithm>
#include <utility>

namespace arenite::statistics {

const Column* Columns::find(std::string_view name) const {
  const auto at = std::ranges::find(list, name, &Column::name);
  return at == list.end() ? nullptr : &*at;
}

const std::vector<double>& Columns::operator[](std::string_view name) const {
  const Column* column = find(name);
  if (!column) throw NumbersError("there is no column " + std::string(name));
  return column->values;
}

void Columns::put(std::string name, const char* unit, const char* sentence, std::vector<double> values,
                  std::vector<double> error) {
  list.push_back({std::move(name), {unit, sentence}, std::move(values), std::move(error)});
}

}  // namespace arenite::statistics
