#pragma once
#include <filesystem>
#include <string>

namespace arenite::io {

/// The text of a file in UTF-8, whatever it is written in: UTF-8 or UTF-16 with their marks, or Latin-1, which any
/// other bytes are taken for; lines that end with a carriage return alone end with a line feed. Throws InputError for a
/// file that cannot be read or holds zero bytes.
std::string read_text(const std::filesystem::path& path);
/// The same of bytes that have been read.
std::string as_utf8(std::string bytes);

}  // namespace arenite::io
