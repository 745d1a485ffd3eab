#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace arenite::io {

/// Bytes that are read at any place: of a file, which need not fit in memory, or of a text in memory.
class ByteSource {
 public:
  virtual ~ByteSource() = default;
  virtual std::uint64_t size() const = 0;
  /// Up to `count` bytes from `at`; fewer at the end. Throws InputError where the system refuses.
  virtual std::size_t read(std::uint64_t at, std::size_t count, void* to) const = 0;
  virtual const std::string& name() const = 0;            ///< for messages
  virtual const std::filesystem::path* path() const = 0;  ///< of a file; null for bytes in memory

  std::string text(std::uint64_t at, std::size_t count) const;
};

using Bytes = std::shared_ptr<const ByteSource>;

/// Throws InputError for a missing file, a folder, no permission.
Bytes open_bytes(const std::filesystem::path& path);
Bytes bytes_in_memory(std::string bytes, std::string name);
/// Bytes that somebody else keeps, for longer than these are used.
Bytes bytes_kept(std::string_view bytes, std::string name);

}  // namespace arenite::io
