#pragma once
#include <filesystem>
#include <optional>

namespace arenite::io {

/// A lock file that is held: other processes that try it are refused until this goes, or its process dies, however it
/// dies. The file is removed with the lock.
class FileLock {
 public:
  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&& other) noexcept;
  ~FileLock();

  /// Nothing if another process, or another FileLock of this one, holds it. Throws InputError when the system refuses.
  static std::optional<FileLock> try_take(const std::filesystem::path& file);
  /// Whether anybody holds it now.
  static bool is_held(const std::filesystem::path& file);

 private:
  FileLock(std::filesystem::path file, int descriptor) : file_(std::move(file)), descriptor_(descriptor) {}
  std::filesystem::path file_;
  int descriptor_ = -1;
};

}  // namespace arenite::io
