#include <fmt/core.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/problems.hpp"
#include "io/disk/numpy_header.hpp"
#include "io/film/formats.hpp"

namespace arenite::io {
namespace {

constexpr std::size_t array_header_size = 128;
static_assert(array_header_size - 10 == 'v');

std::string npy_header(const FilmInfo& info, std::size_t frames) {
  std::string text("\x93NUMPY\x01\0v\0", 10);
  text += fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}, {}, {}), }}",
                      info.floating ? "<f4" : "<u2", frames, info.height, info.width);
  text.resize(array_header_size - 1, ' ');
  return text + '\n';
}

FilmPointer open_npy(const Bytes& bytes, const FilmChoice& choice) {
  using enum NumberType;
  const std::string& file = bytes->name();
  const NumpyHeader array = numpy_header_in(bytes);
  const auto pixel = array.number;
  if (!pixel || *pixel == i8 || *pixel == u64 || *pixel == i64 || array.type.ends_with("b1"))
    refuse(file, "holds numbers of an unsupported type ({}); save u1, u2, i2, u4, i4, f4 or f8", array.type);
  if (array.fortran) refuse(file, "is stored in column order; save it with numpy.ascontiguousarray");
  auto shape = array.shape;
  if (shape.size() == 2) shape.insert(shape.begin(), 1);
  if (shape.size() != 3) refuse(file, "has {} dimensions; save an array of frames x height x width", shape.size());
  FilmInfo info;
  take_shape(info, file, shape, *pixel, choice);
  PlainLayout layout;
  layout.pixel = *pixel;
  layout.big_endian = array.big_endian;
  layout.offset = array.start;
  layout.stride = info.pixels() * bytes_of(*pixel);
  if (bytes->size() > layout.offset + layout.stride * static_cast<std::uint64_t>(info.frames))
    info.remarks.push_back(fmt::format(
        "More numbers follow than {} frames of {} x {} pixels have, and are left aside; check the shape of the array.",
        info.frames, info.width, info.height));
  return plain_film(bytes, std::move(info), layout, choice);
}

}  // namespace

/// NumPy: frames x height x width (or one frame), numbers of 1 to 8 bytes.
const FilmFormat films::npy{
    .name = "npy",
    .sentence = "NumPy .npy",
    .states = {{"column order", "refused"},
               {"more numbers than the shape says", "left aside, and told"},
               {"frames of NaN, of one number, or the frame before once more", "left out as lost, and named"}},

    .endings = {".npy"},
    .marked = true,
    .is = is_numpy_array,
    .open = open_npy,
    .create = [](const auto& path, const FilmInfo& info) { return create_plain_film(path, info, {npy_header}); }};

}  // namespace arenite::io
