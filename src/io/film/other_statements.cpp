#include "io/film/other_statements.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "core/text.hpp"

namespace arenite::io {

void OtherStatements::note(std::string_view line, char separator, FilmInfo& info) {
  constexpr std::size_t longest_name = 40;
  line.remove_prefix(std::min(line.find_first_not_of(" \t#%/*\"'"), line.size()));
  std::size_t sign = line.find_first_of("=:");
  if (sign == line.npos && separator != ' ' && std::ranges::count(line, separator) == 1) sign = line.find(separator);
  if (sign == line.npos || trimmed(line.substr(sign + 1)).empty()) return;
  const std::string name(trimmed(line.substr(0, std::min(sign, longest_name))));
  if (lower_case(name) == "camera") info.camera = trimmed(line.substr(sign + 1));
  else if (!name.empty() && !is_digit(name.front()) && std::ranges::count(names_, name) == 0 &&
           names_.size() <= most_told)
    names_.push_back(name);
}

void OtherStatements::tell(FilmInfo& info) const {
  if (names_.empty()) return;
  const std::size_t n = std::min(names_.size(), most_told);
  info.remarks.push_back(
      fmt::format("Its lines of words also state {}{}, which {} not used; write what the measurement needs into the "
                  "recipe, an emissivity as temperature.{}.",
                  list_of(std::vector(names_.begin(), names_.begin() + static_cast<std::ptrdiff_t>(n))),
                  names_.size() > n ? " and more" : "", names_.size() > 1 ? "are" : "is",
                  info.quantity == FilmQuantity::kelvin ? "assumed_emissivity" : "emissivity"));
}

}  // namespace arenite::io
