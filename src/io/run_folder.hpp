#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace arenite::io {

/// "02-compact-<hash>.h5": place in the loading (from 1), the stage's name in the recipe with what a file name should
/// not hold replaced by "-", and the first 12 digits of the hash of what made it; the file holds all of them. So a
/// folder's names sort in the order of the loading.
std::string stage_file_name(int place, std::string_view stage, std::string_view hash);

/// The same with the whole hash: what files were called before, and what the names of a study's runs still follow from.
std::string full_stage_file_name(int place, std::string_view stage, std::string_view hash);

/// The stage files of a result in the order of the loading: `result` itself if it is a file, else the *.h5 files in that
/// folder by name. Throws InputError if there is none.
std::vector<std::filesystem::path> stage_files(const std::filesystem::path& result);

}  // namespace arenite::io
