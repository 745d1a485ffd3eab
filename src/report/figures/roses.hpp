#pragma once
#include <string>

#include "report/figures/drawing.hpp"
#include "statistics/numbers.hpp"

namespace arenite::report::figures {

/// The rose of a set of directions; `inner`: of a part of it.
Rose rose_of(std::string name, std::string colour, const Numbers& set, const Numbers* inner = nullptr);

}  // namespace arenite::report::figures
