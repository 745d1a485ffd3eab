#include "option_names.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace arenite::python {
namespace {

/// Options whose argument has another name than they have.
constexpr std::array<std::pair<std::string_view, std::string_view>, 6> renamed{{{"doubled merge", "merge_doubled"},
                                                                                {"touching", "propose_contacts"},
                                                                                {"columns", "contact_columns"},
                                                                                {"radius", "radii"},
                                                                                {"set", "changes"},
                                                                                {"k", "stiffness"}}};

}  // namespace

std::string argument_of(std::string_view option) {
  for (const auto& [name, argument] : renamed)
    if (name == option) return std::string(argument);
  std::string argument(option);
  std::ranges::replace(argument, '-', '_');
  return argument;
}

}  // namespace arenite::python
