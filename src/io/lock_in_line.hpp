#pragma once
#include <filesystem>
#include <vector>

namespace arenite::io {

/// The load's signal that a camera writes into the first line of a .ptw lock-in film: one number a frame, the mean of those words of the line
/// (after the four that mark it) which change over the film. Empty for any other file, and for a line in which nothing changes.
std::vector<double> lock_in_line(const std::filesystem::path& film);

}  // namespace arenite::io
