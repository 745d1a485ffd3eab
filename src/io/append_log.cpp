#include "io/append_log.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "io/read_file.hpp"
#include "io/write_all.hpp"

namespace arenite::io {
namespace fs = std::filesystem;
namespace {

/// No two processes on any machine choose the same; names sort by the time of their making.
std::string own_name() {
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size() - 1);
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return fmt::format("{:020}-{}-{}.log", std::chrono::duration_cast<std::chrono::nanoseconds>(now).count(), host.data(), ::getpid());
}

}  // namespace

AppendLog::AppendLog(const fs::path& folder, std::function<void(const std::string&)> notice) : owner_(::getpid()), notice_(std::move(notice)) {
  std::error_code error;
  fs::create_directories(folder, error);
  file_ = folder / own_name();
  descriptor_ = ::open(file_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor_ < 0) throw InputError(file_.string(), 0, fmt::format("cannot be written: {}; check the folder's permissions", std::strerror(errno)));
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
  if (error == 0 || told_ || !notice_) return;
  told_ = true;
  notice_(fmt::format("{}: lines are being lost: {}; make room, or what is done may look as if it were not", file_.string(), std::strerror(error)));
}

void read_log(const fs::path& folder, const std::function<void(std::string_view)>& see) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    if (entry->path().extension() == ".log") files.push_back(entry->path());
  std::sort(files.begin(), files.end());
  for (const auto& file : files) {
    const std::string text = read_file(file);
    for (std::size_t begin = 0, end = 0; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1)
      see(std::string_view(text).substr(begin, end - begin));
  }
}

}  // namespace arenite::io
