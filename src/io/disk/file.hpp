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

/// Writes `bytes` to `path` all or nothing: to a file without a name in its folder, flushed to the disk, then named.
/// Whatever happens before that (full disk, no permission, a kill), a file that was there stays as it was, and nothing
/// else is left. Where the file system has no files without a name (NFS, for one), it is written beside as ".name.tmp":
/// two processes that write the same path then take turns, and what a killed one left is taken over. No link that
/// somebody put there is followed. The folder must exist. Throws InputError (place, reason, fix) when the system
/// refuses.
void write_atomically(const std::filesystem::path& path, std::string_view bytes);

/// The same for a file that is written part by part: it appears under its name with `commit`, or not at all.
class AtomicFile {
 public:
  enum class Until { nameless, named };  ///< how the file is kept until it is complete; nameless where that is possible
  explicit AtomicFile(const std::filesystem::path& path, Until until = Until::nameless);
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  ~AtomicFile();
  void write(std::string_view bytes);                            ///< appends
  void overwrite(std::uint64_t offset, std::string_view bytes);  ///< of what was written
  void commit();
  const std::filesystem::path& beside() const { return beside_; }  ///< where the bytes are until then

 private:
  bool open_nameless();
  bool open_locked();
  void give_name();
  std::filesystem::path folder() const { return target_.has_parent_path() ? target_.parent_path() : "."; }
  std::filesystem::path target_, beside_;
  int descriptor_ = -1;
  bool named_ = false;  ///< `beside_` is a name in the folder
};

/// All bytes of a file. Throws InputError for a missing file, a folder, no permission.
std::string read_file(const std::filesystem::path& path);

/// InputError that says how to unpack what a program has packed (gzip and its like), by its first bytes; nothing for
/// other bytes.
void refuse_compressed(std::string_view bytes, const std::string& file);

/// Writes all bytes, however often the system takes a part of them or is interrupted. 0, or the `errno` that it failed
/// with; `written`, if given, is then how many bytes went out.
int write_all(int descriptor, std::string_view bytes, std::size_t* written = nullptr);

/// A lock file that is held: other processes that try it are refused until this goes, or its process dies, however it
/// dies. The file is removed with the lock.
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
