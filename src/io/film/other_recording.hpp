#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace arenite::io {

/// What a recording is that cannot be read as a film, by its first bytes or the ending of its name, and what to export
/// instead, as a sentence after its name; empty for anything else.
std::string other_recording(const std::filesystem::path& path, std::string_view head);

}  // namespace arenite::io
