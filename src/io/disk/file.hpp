#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/error.hpp"

namespace arenite::io {

/// Writes `bytes` to `path` all or nothing: beside it as ".name.tmp", flushed to the disk, then renamed. Whatever happens before the rename (full
/// disk, no permission, a kill), a file that was there stays as it was. Two processes that write the same path take turns; what a killed one left is
/// taken over. The folder must exist. Throws InputError (place, reason, fix) when the system refuses.
void write_atomically(const std::filesystem::path& path, std::string_view bytes);

/// The same for a file that is written part by part: it appears under its name with `commit`, or not at all.
class AtomicFile {
 public:
  explicit AtomicFile(const std::filesystem::path& path);
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  ~AtomicFile();
  void write(std::string_view bytes);                            ///< appends
  void overwrite(std::uint64_t offset, std::string_view bytes);  ///< of what was written
  void commit();
  const std::filesystem::path& beside() const { return beside_; }  ///< where the bytes are until then

 private:
  bool open_locked();
  std::filesystem::path target_, beside_;
  int descriptor_ = -1;
  bool renamed_ = false;
};

/// All bytes of a file. Throws InputError for a missing file, a folder, no permission.
std::string read_file(const std::filesystem::path& path);

/// Writes all bytes, however often the system takes a part of them or is interrupted. 0, or the `errno` that it failed with; `written`, if given, is
/// then how many bytes went out.
int write_all(int descriptor, std::string_view bytes, std::size_t* written = nullptr);

/// A lock file that is held: other processes that try it are refused until this goes, or its process dies, however it dies. The file is removed with
/// the lock.
class FileLock {
 public:
  /// Nothing if another process, or another FileLock of this one, holds it. Throws InputError when the system refuses.
  static std::optional<FileLock> try_take(const std::filesystem::path& file);
  /// Whether anybody holds it now.
  static bool is_held(const std::filesystem::path& file);

 private:
  struct Held;
  explicit FileLock(const Held* held);
  std::shared_ptr<const Held> held_;
};

}  // namespace arenite::io
