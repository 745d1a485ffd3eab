#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

// What the names of a series' files say of its frames.
namespace arenite::io {

/// A name as it is sorted: numbers in it by value (frame 9 before frame 10), as if all had as many digits.
std::string sorting_key(const std::string& name);

/// The one number in which names that are otherwise alike differ; empty where there is none, or more than one.
std::vector<std::int64_t> numbers_in_names(const std::vector<std::filesystem::path>& files);

/// Seconds after the first, of names that differ in one date and time, year to second, perhaps with fractions
/// ("20261127-120000.033", "2026-11-27_12-00-00-033"); empty where any name is none such, or is not after the one
/// before. Digits behind the second are no fraction where they count the files.
std::vector<double> times_in_names(const std::vector<std::filesystem::path>& files);

}  // namespace arenite::io
