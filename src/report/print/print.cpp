#include "report/print/print.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "core/text.hpp"
#include "core/units.hpp"

namespace arenite::report {

const std::vector<std::string>& print_formats() {
  static const std::vector<std::string> list{"pdf", "svg", "png"};
  return list;
}

void declare(ParameterVisitor& v, Print& print) {
  static const std::string formats = "Formats: " + list_of(print_formats(), ", ") + "; several may be given.",
                           unknown = "must be among " + list_of(print_formats(), ", "),
                           width = fmt::format("Width of a figure; if not given {} for one column, {} for two.",
                                               format_quantity(column_width, "mm"), format_quantity(page_width, "mm"));
  v.texts({"formats", formats}, print.formats);
  v.require(
      std::ranges::all_of(print.formats,
                          [](const std::string& format) { return std::ranges::count(print_formats(), format) > 0; }),
      {"formats"}, unknown);
  v.texts({"names", "Names of the figures to draw; all if not given."}, print.names);
  v.number({"width", width}, print.width, "mm", range::between(0.01, 3));
}

}  // namespace arenite::report
