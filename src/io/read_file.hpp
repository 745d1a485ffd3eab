#pragma once
#include <filesystem>
#include <string>

namespace arenite::io {

/// All bytes of a file. Throws InputError for a missing file, a folder, no permission.
std::string read_file(const std::filesystem::path& path);

}  // namespace arenite::io
