#include "phase_words.hpp"

#include <fmt/core.h>

namespace arenite::python {

std::string text_of(const PhaseWords& phases) {
  if (const auto* text = std::get_if<std::string>(&phases)) return *text;
  std::string text;
  for (const auto& [value, name] : std::get<1>(phases))
    text += fmt::format("{}{}={}", text.empty() ? "" : ",", value, name);
  return text;
}

}  // namespace arenite::python
