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
  throw InputError(path.string(), 0,
                   "cannot be written: " + reason(error, path.has_parent_path() ? path.parent_path() : "."));
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

AtomicFile::AtomicFile(const fs::path& path, Until until) : target_(behind_link(path)) {
  std::error_code error;
  const auto status = fs::status(target_, error);
  if (fs::exists(status) && !fs::is_regular_file(status))
    arenite::refuse(path.string(), "cannot be written: it is {}; give the name of a file",
                    fs::is_directory(status) ? "a folder" : "not a regular file");
  struct stat there {};
  if (::lstat(target_.c_str(), &there) != 0 && errno == ENAMETOOLONG)
    refuse_by_system(target_, errno);  // before hours of work, not after
  if (until == Until::nameless && open_nameless()) return;
  beside_ = folder() / ("." + target_.filename().string() + ".tmp");
  while (!open_locked()) {}
  named_ = true;
  if (::ftruncate(descriptor_, 0) != 0) refuse_by_system(target_, errno);
}

AtomicFile::~AtomicFile() {
  if (named_) ::unlink(beside_.c_str());
  ::close(descriptor_);
}

/// False where the system has no files without a name, or no place to find them at.
bool AtomicFile::open_nameless() {
  descriptor_ = ::open(folder().c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, 0666);
  if (descriptor_ < 0) return false;
  beside_ = fmt::format("/proc/self/fd/{}", descriptor_);
  struct stat found {};
  if (::stat(beside_.c_str(), &found) == 0) return true;
  ::close(descriptor_);
  return false;
}

/// A name that nobody can foresee, for the moment until the file is renamed.
void AtomicFile::give_name() {
  for (;;) {
    std::uint64_t random = 0;
    if (::getentropy(&random, sizeof(random)) != 0) refuse_by_system(target_, errno);
    const fs::path name = folder() / fmt::format(".arenite-{:016x}.tmp", random);
    if (::linkat(AT_FDCWD, beside_.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0) {
      beside_ = name;
      named_ = true;
      return;
    }
    if (errno != EEXIST) refuse_by_system(target_, errno);
  }
}

/// False if another process renamed the file away while we waited for its lock: then ours is the other's result.
bool AtomicFile::open_locked() {
  const auto refuse_planted = [&] {
    arenite::refuse(target_.string(), "cannot be written: {} is there already and is not a file of its own; remove it",
                    beside_.string());
  };
  // What somebody else put there must neither lead to another file nor keep us waiting.
  descriptor_ = ::open(beside_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666);
  if (descriptor_ < 0 && (errno == ELOOP || errno == ENXIO)) refuse_planted();
  if (descriptor_ < 0) refuse_by_system(target_, errno);
  lock(descriptor_, LOCK_EX);
  struct stat opened {};
  const bool ours = is_still(descriptor_, beside_);
  const bool alone = ours && ::fstat(descriptor_, &opened) == 0 && S_ISREG(opened.st_mode) && opened.st_nlink == 1;
  if (alone) return true;
  ::close(descriptor_);
  if (ours) refuse_planted();
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
  if (::fsync(descriptor_) != 0) refuse_by_system(target_, errno);
  if (!named_) give_name();
  if (::rename(beside_.c_str(), target_.c_str()) != 0) refuse_by_system(target_, errno);
  named_ = false;
  // The rename itself must survive a power cut; some file systems cannot flush a folder, which is no fault of the file.
  const int parent = ::open(folder().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (parent < 0) return;
  ::fsync(parent);
  ::close(parent);
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
  if (!in.is_open() || in.bad())
    throw InputError(path.string(), 0,
                     std::string("cannot be read: ") + std::strerror(errno) + "; check its permissions");
  return std::move(bytes).str();
}

void refuse_compressed(std::string_view bytes, const std::string& file) {
  struct Packing {
    std::string_view mark, by, mend;
  };
  constexpr Packing known[] = {{"\x1f\x8b", "gzip", "gunzip"},
                               {"\x28\xb5\x2f\xfd", "zstd", "unzstd"},
                               {"\xfd"
                                "7zXZ",
                                "xz", "unxz"},
                               {"BZh", "bzip2", "bunzip2"}};
  for (const Packing& packing : known)
    if (bytes.starts_with(packing.mark))
      arenite::refuse(file, "is compressed ({}); unpack it ({})", packing.by, packing.mend);
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
    const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (descriptor < 0)
      throw InputError(file.string(), 0,
                       std::string("cannot be made: ") + std::strerror(errno) + "; check the folder's permissions");
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
