#pragma once
#include <string>
#include <vector>

#include "report/figures/drawing.hpp"
#include "statistics/numbers.hpp"

namespace arenite::report::figures {

/// The rose of a set of directions; `inner`: of a part of it.
Rose rose_of(std::string name, std::string colour, const Numbers& set, const Numbers* inner = nullptr);

/// a_c of a set with its error, and what it would be of random directions where it is no larger.
std::vector<std::string> anisotropy_in_words(const Numbers& set);

}  // namespace arenite::report::figures
