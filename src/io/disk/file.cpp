#include "io/disk/file.hpp"

#include "core/problems.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

namespace arenite::io {

namespace fs = std::filesystem;
namespace {

std::string reason(int error, const fs::path& folder) {
  switch (error) {
    case ENOENT: return fmt::format("there is no folder {}; create it or write elsewhere", folder.string());
    case ENOTDIR: return fmt::format("{} is not a folder; write elsewhere", folder.string());
    case EACCES:
    case EPERM: return fmt::format("no permission to write in {}; change it or write elsewhere", folder.string());
    case EROFS: return fmt::format("{} is read-only; write elsewhere", folder.string());
    case ENOSPC:
    case EDQUOT: return "the disk is full; free some space and try again";
    case EFBIG: return "the file would pass the size limit of this shell (ulimit -f); raise it or store less";
    case ENAMETOOLONG: return "the name is too long; choose a shorter one";
    default: return fmt::format("{}; check the disk or write elsewhere", std::strerror(error));
  }
}

[[noreturn]] void refuse_by_system(const fs::path& path, int error) {
  throw InputError(path.string(), 0, "cannot be written: " + reason(error, path.has_parent_path() ? path.parent_path() : "."));
}

/// Behind a symbolic link the file it points to is replaced, not the link.
fs::path behind_link(const fs::path& path) {
  std::error_code error;
  if (!fs::is_symlink(path, error)) return path;
  const fs::path target = fs::canonical(path, error);
  return error ? path : target;
}

/// False if it is somebody else's.
bool lock(int descriptor, int how) {
  int result = 0;
  while ((result = ::flock(descriptor, how)) != 0 && errno == EINTR) {}
  return result == 0;
}

/// Whoever held a lock before may have removed or renamed the file between our opening and locking it.
bool is_still(int descriptor, const fs::path& name) {
  struct stat opened {
  }, named{};
  return ::fstat(descriptor, &opened) == 0 && ::stat(name.c_str(), &named) == 0 && opened.st_ino == named.st_ino;
}

}  // namespace

AtomicFile::AtomicFile(const fs::path& path) : target_(behind_link(path)), beside_(target_.parent_path() / ("." + target_.filename().string() + ".tmp")) {
  std::error_code error;
  const auto status = fs::status(target_, error);
  if (fs::exists(status) && !fs::is_regular_file(status))
    arenite::refuse(path.string(), "cannot be written: it is {}; give the name of a file", fs::is_directory(status) ? "a folder" : "not a regular file");
  while (!open_locked()) {}
  if (::ftruncate(descriptor_, 0) != 0) refuse_by_system(target_, errno);
}

AtomicFile::~AtomicFile() {
  if (!renamed_) ::unlink(beside_.c_str());
  ::close(descriptor_);
}

/// False if another process renamed the file away while we waited for its lock: then ours is the other's result.
bool AtomicFile::open_locked() {
  descriptor_ = ::open(beside_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor_ < 0) refuse_by_system(target_, errno);
  lock(descriptor_, LOCK_EX);
  if (is_still(descriptor_, beside_)) return true;
  ::close(descriptor_);
  return false;
}

void AtomicFile::write(std::string_view bytes) {
  if (const int error = write_all(descriptor_, bytes)) refuse_by_system(target_, error);
}

void AtomicFile::overwrite(std::uint64_t offset, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) refuse_by_system(target_, errno);
    bytes.remove_prefix(static_cast<std::size_t>(n));
    offset += static_cast<std::uint64_t>(n);
  }
}

void AtomicFile::commit() {
  if (::fsync(descriptor_) != 0 || ::rename(beside_.c_str(), target_.c_str()) != 0) refuse_by_system(target_, errno);
  renamed_ = true;
  // The rename itself must survive a power cut; some file systems cannot flush a folder, which is no fault of the file.
  const int folder = ::open(target_.has_parent_path() ? target_.parent_path().c_str() : ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) return;
  ::fsync(folder);
  ::close(folder);
}

void write_atomically(const fs::path& path, std::string_view bytes) {
  AtomicFile file(path);
  file.write(bytes);
  file.commit();
}

std::string read_file(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) arenite::refuse(path.string(), "there is no such file; check its name");
  if (std::filesystem::is_directory(status)) arenite::refuse(path.string(), "is a folder; give the name of a file");
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  std::ostringstream bytes;
  if (in && in.peek() != std::ifstream::traits_type::eof()) bytes << in.rdbuf();
  if (!in.is_open() || in.bad()) throw InputError(path.string(), 0, std::string("cannot be read: ") + std::strerror(errno) + "; check its permissions");
  return std::move(bytes).str();
}

int write_all(int descriptor, std::string_view bytes, std::size_t* written) {
  std::size_t out = 0;
  int error = 0;
  while (out < bytes.size() && error == 0) {
    const ssize_t n = ::write(descriptor, bytes.data() + out, bytes.size() - out);
    if (n > 0) out += static_cast<std::size_t>(n);
    else if (n == 0) error = EIO;
    else if (errno != EINTR) error = errno;
  }
  if (written) *written = out;
  return error;
}

struct FileLock::Held {
  std::filesystem::path file;
  int descriptor = -1;
  ~Held() {
    ::unlink(file.c_str());
    ::close(descriptor);
  }
};

FileLock::FileLock(const Held* held) : held_(held) {}

std::optional<FileLock> FileLock::try_take(const std::filesystem::path& file) {
  for (;;) {
    const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor < 0) throw InputError(file.string(), 0, std::string("cannot be made: ") + std::strerror(errno) + "; check the folder's permissions");
    if (!lock(descriptor, LOCK_EX | LOCK_NB)) {
      ::close(descriptor);
      return std::nullopt;
    }
    if (is_still(descriptor, file)) return FileLock(new Held{file, descriptor});
    ::close(descriptor);
  }
}

bool FileLock::is_held(const std::filesystem::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool held = !lock(descriptor, LOCK_SH | LOCK_NB);
  ::close(descriptor);
  return held;
}

}  // namespace arenite::io
