#pragma once
#include <optional>

#include "statistics/numbers.hpp"

/// A figure of two results, A and B, from what each of them shows.
namespace arenite::report::figures {

/// The series of both that the pointer reads, in the units of the first; nothing where axes are not of the same
/// numbers, or there are no panels.
std::optional<Numbers> together(const Numbers& one, const Numbers& other);

/// A figure of `head` with the first of the drawings of both, and of its caption what is shown; not known where they
/// have nothing in common.
Numbers compared(const Numbers& head, const Numbers& one, const Numbers& other);

}  // namespace arenite::report::figures
