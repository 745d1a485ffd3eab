#include "io/volume/numpy_array.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>
#include <tuple>
#include <utility>

#include "core/problems.hpp"

namespace arenite::io {
namespace {

/// What follows "'key':" in the header's dictionary.
std::string_view stated_in(std::string_view header, const std::string& key, const std::string& file) {
  const std::size_t at = header.find("'" + key + "'");
  const std::size_t colon = at == std::string_view::npos ? at : header.find(':', at);
  if (colon == std::string_view::npos)
    refuse(file, "is a .npy array whose header does not state \"{}\"; save it again", key);
  std::string_view rest = header.substr(colon + 1);
  rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
  return rest;
}

std::optional<NumberType> numpy_type(std::string_view word) {
  using enum NumberType;
  static constexpr std::pair<std::string_view, NumberType> known[] = {
      {"b1", u8},  {"u1", u8},  {"i1", i8},  {"u2", u16}, {"i2", i16}, {"u4", u32},
      {"i4", i32}, {"u8", u64}, {"i8", i64}, {"f4", f32}, {"f8", f64}};
  for (const auto& [name, type] : known)
    if (name == word) return type;
  return std::nullopt;
}

}  // namespace

NumpyArray numpy_array_in(const Bytes& bytes) {
  const std::string& file = bytes->name();
  const std::string head = bytes->text(0, 12);
  if (!head.starts_with("\x93NUMPY")) refuse(file, "holds no .npy array; save it with numpy.save or numpy.savez");
  const int version = number_at<std::uint8_t>(head, 6);
  NumpyArray array;
  array.start = version == 1 ? 10 : 12;
  const std::size_t length = version == 1 ? number_at<std::uint16_t>(head, 8) : number_at<std::uint32_t>(head, 8);
  if (version < 1 || version > 3 || length > (std::size_t{1} << 20))
    refuse(file, "is a .npy array with an invalid header; save it again");
  const std::string header = bytes->text(array.start, length);
  array.start += length;
  const std::string_view type = stated_in(header, "descr", file);
  if (!type.starts_with('\'')) refuse(file, "has records instead of numbers; save one array of numbers");
  array.type = type.substr(1, type.find('\'', 1) - 1);
  array.fortran = stated_in(header, "fortran_order", file).starts_with("True");
  std::string_view shape = stated_in(header, "shape", file);
  shape = shape.substr(0, shape.find(')'));
  for (std::size_t i = 0; i < shape.size();) {
    std::int64_t n = 0;
    const auto [end, error] = std::from_chars(shape.data() + i, shape.data() + shape.size(), n);
    if (error == std::errc()) array.shape.push_back(n);
    i = error == std::errc() ? static_cast<std::size_t>(end - shape.data()) : i + 1;
  }
  return array;
}

VolumePointer open_numpy_array(const Bytes& bytes) {
  const std::string& file = bytes->name();
  const NumpyArray array = numpy_array_in(bytes);
  if (array.shape.size() != 3)
    refuse(file, "has {} dimensions; save an array of three: slices x rows x columns", array.shape.size());
  const std::string_view type = std::string_view(array.type).substr(std::min<std::size_t>(1, array.type.size()));
  const auto number = numpy_type(type);
  if (!number) refuse(file, "has voxels of type {}; save whole numbers, or bool", array.type);
  const auto [z, y, x] = std::tuple(array.shape[0], array.shape[1], array.shape[2]);
  VoxelLayout layout{.type = *number, .big_endian = array.type.starts_with('>'), .start = array.start};
  if (array.fortran) layout.step = {z * y, z, 1};
  return voxels_in(bytes, sized({x, y, z}, file), layout);
}

}  // namespace arenite::io
