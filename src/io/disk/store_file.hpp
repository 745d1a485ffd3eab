#pragma once
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"

namespace arenite::io {

/// Our HDF5 files begin with a user block of text (HDF5 allows one, and every reader skips it): what the file is, its
/// format's number, its length and the hash of the rest. So a file that is foreign, newer, cut short or damaged is
/// known before HDF5 reads a byte of it, and `head -4` tells a person what lies there.
inline constexpr std::size_t header_size = 512;
inline constexpr int file_format = 1;

/// A file of ours that is empty, cut short or changed: what it held is lost, but whoever can make it again may.
class DamagedFile : public InputError {
 public:
  using InputError::InputError;
};

/// Writes `bytes`, of which HDF5 left the first 512 free for length and checksum, to `path`, all or nothing. `kind` is
/// "result", "field", "voxels", "film", "numbers" or "checkpoint".
void write_checksummed(const std::filesystem::path& path, std::string_view kind, std::string bytes);

/// Reads the bytes of a whole file of that kind; InputError for any other, DamagedFile for one that is no longer whole.
std::string read_checksummed(const std::filesystem::path& path, std::string_view kind);

/// The kind that a file says it is, from its first line; empty if it is none of ours or cannot be read.
std::string stored_kind(const std::filesystem::path& path);

/// "02-compact-<hash>.h5": place in the loading (from 1), the stage's name in the recipe with what a file name should
/// not hold replaced by "-", and the first 12 digits of the hash of what made it; the file holds all of them. So a
/// folder's names sort in the order of the loading.
std::string stage_file_name(int place, std::string_view stage, std::string_view hash);

/// The stage files of a result in the order of the loading: `result` itself if it is a file, else the *.h5 files in
/// that folder by name. Throws InputError if there is none.
std::vector<std::filesystem::path> stage_files(const std::filesystem::path& result);

/// Lines that processes add and nobody changes: a folder with one file for each process that opened it, so that
/// machines that share a disk never write to the same file. Processes forked from the one that opened it share its
/// file; a line is one write at the end of the file, and none is torn by another.
class AppendLog {
 public:
  /// `notice` hears once that a line was lost.
  explicit AppendLog(const std::filesystem::path& folder, std::function<void(const std::string&)> notice = {});
  AppendLog(const AppendLog&) = delete;
  AppendLog& operator=(const AppendLog&) = delete;
  ~AppendLog();
  /// `line` without its end, and without line breaks inside. What cannot be written is lost, for a log must not end a
  /// run, but `notice` hears of it.
  void add(std::string line) const;

 private:
  std::filesystem::path file_;
  int descriptor_ = -1;
  int owner_ = 0;
  std::function<void(const std::string&)> notice_;
  mutable bool notified_ = false, torn_ = false;  ///< torn_: the last line lacks its end
};

/// All whole lines of all files in the folder, file after file; none if there is no folder.
void read_log(const std::filesystem::path& folder, const std::function<void(std::string_view line)>& see);

}  // namespace arenite::io
