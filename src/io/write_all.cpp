#include "io/write_all.hpp"

#include <unistd.h>

#include <cerrno>

namespace arenite::io {

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

}  // namespace arenite::io
