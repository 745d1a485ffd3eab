#include "io/read_file.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "core/error.hpp"

namespace arenite::io {

std::string read_file(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw InputError(path.string(), 0, "there is no such file; check its name");
  if (std::filesystem::is_directory(status)) throw InputError(path.string(), 0, "is a folder; give the name of a file");
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  std::ostringstream bytes;
  if (in && in.peek() != std::ifstream::traits_type::eof()) bytes << in.rdbuf();
  if (!in.is_open() || in.bad())
    throw InputError(path.string(), 0, std::string("cannot be read: ") + std::strerror(errno) + "; check its permissions");
  return std::move(bytes).str();
}

}  // namespace arenite::io
