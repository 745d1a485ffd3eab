#include "io/file_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "core/error.hpp"

namespace arenite::io {
namespace {

bool lock_now(int descriptor) {
  int result = 0;
  while ((result = ::flock(descriptor, LOCK_EX | LOCK_NB)) != 0 && errno == EINTR) {
  }
  return result == 0;
}

}  // namespace

FileLock::FileLock(FileLock&& other) noexcept : file_(std::move(other.file_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

FileLock& FileLock::operator=(FileLock&& other) noexcept {
  std::swap(file_, other.file_);
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

FileLock::~FileLock() {
  if (descriptor_ < 0) return;
  ::unlink(file_.c_str());
  ::close(descriptor_);
}

std::optional<FileLock> FileLock::try_take(const std::filesystem::path& file) {
  for (;;) {
    const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor < 0) throw InputError(file.string(), 0, std::string("cannot be made: ") + std::strerror(errno) + "; check the folder's permissions");
    if (!lock_now(descriptor)) {
      ::close(descriptor);
      return std::nullopt;
    }
    // Whoever held it before may have removed the file between our opening and locking it.
    struct stat opened{}, named{};
    if (::fstat(descriptor, &opened) == 0 && ::stat(file.c_str(), &named) == 0 && opened.st_ino == named.st_ino) return FileLock(file, descriptor);
    ::close(descriptor);
  }
}

bool FileLock::is_held(const std::filesystem::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CLOEXEC);
  if (descriptor < 0) return false;
  int result = 0;
  while ((result = ::flock(descriptor, LOCK_SH | LOCK_NB)) != 0 && errno == EINTR) {
  }
  const bool held = result != 0;
  ::close(descriptor);
  return held;
}

}  // namespace arenite::io
