#include <fmt/format.h>

#include "io/headed_film_writer.hpp"

namespace arenite::io {
namespace {

constexpr std::size_t header_size = 128;
static_assert(header_size - 10 == 'v');

std::string header(const FilmInfo& info, std::size_t frames) {
  std::string text("\x93NUMPY\x01\0v\0", 10);
  text += fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}, {}, {}), }}", info.floating ? "<f4" : "<u2", frames, info.height, info.width);
  text.resize(header_size - 1, ' ');
  return text + '\n';
}

}  // namespace

FilmWriterPointer create_npy_film(const std::filesystem::path& path, const FilmInfo& info) { return create_headed_film(path, info, header); }

}  // namespace arenite::io
