#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/error.hpp"

namespace arenite::io {

/// Our HDF5 files begin with a user block of text (HDF5 allows one, and every reader skips it): what the file is, its
/// format's number, its length and the hash of the rest. So a file that is foreign, newer, cut short or damaged is
/// known before HDF5 reads a byte of it, and `head -4` tells a person what lies there.
inline constexpr std::size_t seal_size = 512;
inline constexpr int file_format = 1;

/// A file of ours that is empty, cut short or changed: what it held is lost, but whoever can make it again may.
class DamagedFile : public InputError {
 public:
  using InputError::InputError;
};

/// Seals `bytes` and writes them to `path`, all or nothing.
void write_sealed(const std::filesystem::path& path, std::string_view kind, std::string bytes);

/// Reads the bytes of a whole file of that kind; InputError for any other, DamagedFile for one that is no longer whole.
std::string read_sealed(const std::filesystem::path& path, std::string_view kind);

/// The kind that a file says it is, from its first line; empty if it is none of ours or cannot be read.
std::string sealed_kind(const std::filesystem::path& path);

/// Puts the seal into the first 512 bytes, which HDF5 left free. `kind` is "result", "field", "film" or "checkpoint".
void seal(std::string& bytes, std::string_view kind);

/// Throws InputError (DamagedFile for one that is no longer whole) naming `path` unless `bytes` are one whole file of that kind.
void check_seal(std::string_view bytes, std::string_view kind, const std::filesystem::path& path);

}  // namespace arenite::io
