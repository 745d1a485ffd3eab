#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace arenite::io {

/// Lines that processes add and nobody changes: a folder with one file for each process that opened it, so that machines
/// that share a disk never write to the same file. Processes forked from the one that opened it share its file; a
/// line is one write at the end of the file, and none is torn by another.
class AppendLog {
 public:
  /// `notice` is told, once, that a line was lost.
  explicit AppendLog(const std::filesystem::path& folder, std::function<void(const std::string&)> notice = {});
  AppendLog(const AppendLog&) = delete;
  AppendLog& operator=(const AppendLog&) = delete;
  ~AppendLog();
  /// `line` without its end, and without line breaks inside. What cannot be written is lost, for a log must not end a run,
  /// but `notice` is told.
  void add(std::string line) const;

 private:
  std::filesystem::path file_;
  int descriptor_ = -1;
  int owner_ = 0;
  std::function<void(const std::string&)> notice_;
  mutable bool told_ = false, torn_ = false;  ///< torn_: the last line lacks its end
};

/// All whole lines of all files in the folder, file after file; none if there is no folder.
void read_log(const std::filesystem::path& folder, const std::function<void(std::string_view line)>& see);

}  // namespace arenite::io
