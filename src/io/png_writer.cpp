#include "io/png_writer.hpp"

#include <png.h>

#include <stdexcept>
#include <string>

#include "io/atomic_file.hpp"

namespace arenite::io {

void write_png(const std::filesystem::path& path, const ColourPicture& picture) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(picture.width);
  header.height = static_cast<png_uint_32>(picture.height);
  header.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&header, bytes.data(), &size, 0, picture.rgb.data(), 0, nullptr) == 0)
    throw std::runtime_error(std::string("cannot make a PNG picture: ") + header.message);
  bytes.resize(size);
  write_atomically(path, bytes);
}

}  // namespace arenite::io
