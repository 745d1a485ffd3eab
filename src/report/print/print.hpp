#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/parameters.hpp"

namespace arenite::report {

/// How wide figures in print are, m: one and two columns of most journals.
inline constexpr double column_width = 0.085, page_width = 0.175;

/// Figures of a result or a study as files.
struct Print {
  std::vector<std::string> formats{"pdf"}, names;
  std::optional<double> width;  ///< m
};
void declare(ParameterVisitor& visitor, Print& print);

/// Formats that figures can be written in.
const std::vector<std::string>& print_formats();

}  // namespace arenite::report
