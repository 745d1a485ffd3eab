#include "io/disk/byte_source.hpp"

#include "core/problems.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

namespace arenite::io {
namespace {

class FileBytes : public ByteSource {
 public:
  explicit FileBytes(const std::filesystem::path& path) : path_(path), name_(path.string()) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) arenite::refuse(name_, "there is no such file; check its name");
    if (!std::filesystem::is_regular_file(status))
      arenite::refuse(name_, "is not a regular file; give the name of a file");
    descriptor_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor_ < 0) refuse();
    const off_t end = ::lseek(descriptor_, 0, SEEK_END);
    if (end < 0) refuse();
    size_ = static_cast<std::uint64_t>(end);
  }
  FileBytes(const FileBytes&) = delete;
  FileBytes& operator=(const FileBytes&) = delete;
  ~FileBytes() override {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

  std::uint64_t size() const override { return size_; }
  const std::string& name() const override { return name_; }
  const std::filesystem::path* path() const override { return &path_; }
  std::size_t read(std::uint64_t at, std::size_t count, void* to) const override {
    std::size_t there = 0;
    while (there < count) {
      const ssize_t n =
          ::pread(descriptor_, static_cast<char*>(to) + there, count - there, static_cast<off_t>(at + there));
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) refuse();
      if (n == 0) break;
      there += static_cast<std::size_t>(n);
    }
    return there;
  }

 private:
  [[noreturn]] void refuse() const {
    throw InputError(name_, 0,
                     std::string("cannot be read: ") + std::strerror(errno) + "; check its permissions and the disk");
  }

  std::filesystem::path path_;
  std::string name_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
};

class MemoryBytes : public ByteSource {
 public:
  MemoryBytes(std::string_view bytes, std::string name) : bytes_(bytes), name_(std::move(name)) {}
  MemoryBytes(std::string&& bytes, std::string name) : own_(std::move(bytes)), bytes_(own_), name_(std::move(name)) {}
  MemoryBytes(const MemoryBytes&) = delete;
  MemoryBytes& operator=(const MemoryBytes&) = delete;
  std::uint64_t size() const override { return bytes_.size(); }
  const std::string& name() const override { return name_; }
  const std::filesystem::path* path() const override { return nullptr; }
  std::size_t read(std::uint64_t at, std::size_t count, void* to) const override {
    return at < bytes_.size() ? bytes_.copy(static_cast<char*>(to), count, static_cast<std::size_t>(at)) : 0;
  }

 private:
  std::string own_;  ///< before what looks into it
  std::string_view bytes_;
  std::string name_;
};

}  // namespace

std::string ByteSource::text(std::uint64_t at, std::size_t count) const {
  const std::uint64_t left = at < size() ? size() - at : 0;
  std::string bytes(static_cast<std::size_t>(std::min<std::uint64_t>(count, left)), '\0');
  bytes.resize(read(at, bytes.size(), bytes.data()));
  return bytes;
}

Bytes open_bytes(const std::filesystem::path& path) { return std::make_shared<FileBytes>(path); }
Bytes bytes_in_memory(std::string bytes, std::string name) {
  return std::make_shared<MemoryBytes>(std::move(bytes), std::move(name));
}
Bytes bytes_kept(std::string_view bytes, std::string name) {
  return std::make_shared<MemoryBytes>(bytes, std::move(name));
}

using namespace std::string_view_literals;

bool is_tiff(std::string_view head) {
  return head.starts_with("II*\0"sv) || head.starts_with("MM\0*"sv) || head.starts_with("II+\0"sv) ||
         head.starts_with("MM\0+"sv);
}

bool is_hdf5(std::string_view head) {
  for (std::size_t at = 0; at < head.size(); at = at == 0 ? 512 : 2 * at)
    if (head.substr(at).starts_with("\x89HDF\r\n\x1a\n"sv)) return true;
  return false;
}

std::size_t bytes_of(NumberType type) {
  constexpr std::size_t size[] = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  const auto at = static_cast<std::size_t>(type);
  return at < std::size(size) ? size[at] : 0;
}

}  // namespace arenite::io
