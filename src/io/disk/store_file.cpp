#include "io/disk/store_file.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>
#include <utility>

#include "core/hash.hpp"
#include "core/problems.hpp"
#include "core/text.hpp"
#include "io/disk/file.hpp"

namespace arenite::io {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view hdf5_signature{"\x89HDF\r\n\x1a\n", 8};

/// What follows `label` up to the end of its line; empty if the label is not there.
std::string_view after(std::string_view text, std::string_view label) {
  const auto start = text.find(label);
  if (start == std::string_view::npos) return {};
  text.remove_prefix(start + label.size());
  return text.substr(0, text.find('\n'));
}

/// No two processes on any machine choose the same; names sort by the time of their making.
std::string own_name() {
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size() - 1);
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return fmt::format("{:020}-{}-{}.log", std::chrono::duration_cast<std::chrono::nanoseconds>(now).count(), host.data(),
                     ::getpid());
}

/// Throws unless `bytes` are one whole file of that kind.
void check_header(std::string_view bytes, std::string_view kind, const fs::path& path) {
  const std::string file = path.string();
  const auto damaged = [&](const std::string& message) { throw DamagedFile(file, 0, message); };
  if (bytes.empty()) damaged(fmt::format("is empty; a {} of Arenite is written by \"arenite run\"", kind));
  const auto head = bytes.substr(0, header_size);
  if (head.starts_with(hdf5_signature)) refuse(file, "is an HDF5 file of another program, not a {} of Arenite", kind);
  const std::string beginning = fmt::format("arenite {} format ", kind);
  if (!std::string_view(beginning).starts_with(head.substr(0, beginning.size()))) {
    if (head.starts_with("arenite ")) refuse(file, "is another file of Arenite, not a {}; check its name", kind);
    refuse(file, "is not a {} of Arenite; give a .h5 file written by \"arenite run\"", kind);
  }
  const int format = parse_number<int>(after(head, beginning)).value_or(0);
  if (format > file_format)
    refuse(file, "was written by a newer Arenite (file format {}, this one reads up to {}); update Arenite", format,
           file_format);
  if (after(head, "\nbytes ") != std::to_string(bytes.size()))
    damaged(
        fmt::format("does not have its original length (it has {} bytes): it was truncated or extended; remove it and "
                    "compute it again with \"arenite run\"",
                    bytes.size()));
  if (after(head, "\nxxh3 ") != content_hash(bytes.substr(header_size)))
    damaged(
        "was changed or damaged after it was written (its checksum differs); remove it and make it again with "
        "\"arenite run\"");
}

/// Files of a folder with this ending by their names, without those that are still being written.
std::vector<fs::path> files_in(const fs::path& folder, std::string_view ending, std::error_code& error) {
  std::vector<fs::path> files;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    if (entry->path().extension() == ending && entry->path().filename().string().front() != '.')
      files.push_back(entry->path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

void write_checksummed(const fs::path& path, std::string_view kind, std::string bytes) {
  std::string header =
      fmt::format("arenite {} format {}\nHDF5 from byte {} on\nbytes {}\nxxh3 {}\n", kind, file_format, header_size,
                  bytes.size(), content_hash(std::string_view(bytes).substr(header_size)));
  header.resize(header_size, '\0');
  bytes.replace(0, header_size, header);
  write_atomically(path, bytes);
}

std::string stored_kind(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string line;
  constexpr std::string_view ours = "arenite ", then = " format ";
  if (!std::getline(file, line) || !line.starts_with(ours)) return {};
  const auto end = line.find(then, ours.size());
  return end == std::string::npos ? std::string() : line.substr(ours.size(), end - ours.size());
}

std::string read_checksummed(const fs::path& path, std::string_view kind) {
  std::string bytes = read_file(path);
  check_header(bytes, kind, path);
  return bytes;
}

std::string stage_file_name(int place, std::string_view stage, std::string_view hash) {
  std::string name(stage);
  for (char& c : name)
    if (!is_name_character(c) && c != '.') c = '-';
  return fmt::format("{:02}-{}-{}.h5", place, name, hash.substr(0, 12));
}

std::vector<fs::path> stage_files(const fs::path& result) {
  std::error_code error;
  if (!fs::is_directory(result, error)) return {result};
  auto files = files_in(result, ".h5", error);
  if (error) throw InputError(result.string(), 0, "cannot be listed: " + error.message() + "; check its permissions");
  if (files.empty()) refuse(result.string(), "holds no stage file (.h5); give the folder that \"arenite run\" wrote");
  return files;
}

AppendLog::AppendLog(const fs::path& folder, std::function<void(const std::string&)> notice)
    : owner_(::getpid()),
      notice_(std::move(notice)) {
  std::error_code error;
  fs::create_directories(folder, error);
  file_ = folder / own_name();
  descriptor_ = ::open(file_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor_ < 0)
    refuse(file_.string(), "cannot be written: {}; check the folder's permissions", std::strerror(errno));
}

AppendLog::~AppendLog() {
  std::error_code error;
  if (::getpid() == owner_ && fs::file_size(file_, error) == 0 && !error) fs::remove(file_, error);
  ::close(descriptor_);
}

void AppendLog::add(std::string line) const {
  std::replace(line.begin(), line.end(), '\n', ' ');
  line += '\n';
  if (torn_) line.insert(line.begin(), '\n');
  std::size_t written = 0;
  const int error = write_all(descriptor_, line, &written);
  torn_ = error != 0 && (torn_ || written > 0);
  if (error == 0 || notified_ || !notice_) return;
  notified_ = true;
  notice_(fmt::format("{}: lines are being lost: {}; free some space, or finished runs may appear unfinished",
                      file_.string(), std::strerror(error)));
}

void read_log(const fs::path& folder, const std::function<void(std::string_view)>& see) {
  std::error_code error;
  for (const auto& file : files_in(folder, ".log", error)) {
    const std::string text = read_file(file);
    for (std::size_t begin = 0, end = 0; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1)
      see(std::string_view(text).substr(begin, end - begin));
  }
}

}  // namespace arenite::io
