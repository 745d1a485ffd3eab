#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>

namespace arenite::io {

/// Writes `bytes` to `path` all or nothing: beside it as ".name.tmp", flushed to the disk, then renamed. Whatever
/// happens before the rename (full disk, no permission, a kill), a file that was there stays as it was. Two processes
/// that write the same path take turns; what a killed one left is taken over. The folder must exist.
/// Throws InputError (place, reason, mend) when the system refuses.
void write_atomically(const std::filesystem::path& path, std::string_view bytes);

/// The same for a file that is written part by part: it appears under its name with `commit`, or not at all.
class AtomicFile {
 public:
  explicit AtomicFile(const std::filesystem::path& path);
  ~AtomicFile();
  void write(std::string_view bytes);                          ///< appends
  void overwrite(std::uint64_t offset, std::string_view bytes);  ///< of what was written
  void commit();
  const std::filesystem::path& beside() const;  ///< where the bytes are until then

 private:
  class Beside;
  std::unique_ptr<Beside> beside_;
};

}  // namespace arenite::io
