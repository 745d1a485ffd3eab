#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <variant>

namespace arenite::python {

/// Which phase each value is: "0=void,85=particle", or {0: "void", 85: "particle"}.
using PhaseWords = std::variant<std::string, std::map<std::int32_t, std::string>>;

/// In the first form.
std::string text_of(const PhaseWords& phases);

}  // namespace arenite::python
