#pragma once
#include <string>

#include "validation/pooled.hpp"
#include "validation/results.hpp"

namespace arenite::validation {

/// Laws that chapter 4 is run with: the tangential spring and the thesis's own.
struct LawStudy {
  const char* law;
  const char* study;
};
inline constexpr LawStudy laws_of_chapter_4[] = {{"law S", "thesis-ch4"}, {"law R", "thesis-ch4-r"}};

inline Number number_ratio() { return swept("populations.1.ratio"); }

}  // namespace arenite::validation
