#include "io/sealed_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>

#include "core/error.hpp"
#include "core/hash.hpp"
#include "io/atomic_file.hpp"
#include "io/read_file.hpp"

namespace arenite::io {
namespace {

constexpr std::string_view hdf5_signature{"\x89HDF\r\n\x1a\n", 8};

std::string seal_text(std::string_view kind, int format, std::size_t length, std::string_view hash) {
  return fmt::format("arenite {} format {}\nHDF5 from byte {} on\nbytes {}\nxxh3 {}\n", kind, format, seal_size, length, hash);
}

/// What follows `label` up to the end of its line; empty if the label is not there.
std::string_view after(std::string_view text, std::string_view label) {
  const auto start = text.find(label);
  if (start == std::string_view::npos) return {};
  text.remove_prefix(start + label.size());
  return text.substr(0, text.find('\n'));
}

int number(std::string_view text) {
  int value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

}  // namespace

void seal(std::string& bytes, std::string_view kind) {
  const auto rest = std::string_view(bytes).substr(seal_size);
  std::string text = seal_text(kind, file_format, bytes.size(), content_hash(rest));
  text.resize(seal_size, '\0');
  bytes.replace(0, seal_size, text);
}

void check_seal(std::string_view bytes, std::string_view kind, const std::filesystem::path& path) {
  const auto refuse = [&path](std::string message) { throw InputError(path.string(), 0, std::move(message)); };
  const auto damaged = [&path](std::string message) { throw DamagedFile(path.string(), 0, std::move(message)); };
  if (bytes.empty()) damaged(fmt::format("is empty; a {} of Arenite is written by \"arenite run\"", kind));
  const auto head = bytes.substr(0, seal_size);
  if (head.starts_with(hdf5_signature)) refuse(fmt::format("is an HDF5 file of another program, not a {} of Arenite", kind));
  const std::string beginning = fmt::format("arenite {} format ", kind);
  const auto shorter = std::min(head.size(), beginning.size());
  if (head.substr(0, shorter) != std::string_view(beginning).substr(0, shorter)) {
    if (head.starts_with("arenite ")) refuse(fmt::format("is another file of Arenite, not a {}; check its name", kind));
    refuse(fmt::format("is not a {} of Arenite; give a .h5 file written by \"arenite run\"", kind));
  }
  const int format = number(after(head, beginning));
  if (format > file_format)
    refuse(fmt::format("was written by a newer Arenite (file format {}, this one reads up to {}); update Arenite", format, file_format));
  if (after(head, "\nbytes ") != std::to_string(bytes.size()))
    damaged(fmt::format("has not the length it was written with ({} bytes are here): it was cut short or added to; remove it and make it again with \"arenite run\"",
                        bytes.size()));
  if (after(head, "\nxxh3 ") != content_hash(bytes.substr(seal_size)))
    damaged("was changed or damaged after it was written (its checksum differs); remove it and make it again with \"arenite run\"");
}

void write_sealed(const std::filesystem::path& path, std::string_view kind, std::string bytes) {
  seal(bytes, kind);
  write_atomically(path, bytes);
}

std::string sealed_kind(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string line;
  constexpr std::string_view ours = "arenite ", then = " format ";
  if (!std::getline(file, line) || !line.starts_with(ours)) return {};
  const auto end = line.find(then, ours.size());
  return end == std::string::npos ? std::string() : line.substr(ours.size(), end - ours.size());
}

std::string read_sealed(const std::filesystem::path& path, std::string_view kind) {
  std::string bytes = read_file(path);
  check_seal(bytes, kind, path);
  return bytes;
}

}  // namespace arenite::io
