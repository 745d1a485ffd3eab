#include <fmt/core.h>

#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/problems.hpp"
#include "io/film/formats.hpp"

namespace arenite::io {
namespace {

/// What follows "'key':" in the header's dictionary.
std::string_view value_of(std::string_view header, std::string_view key, const std::string& file) {
  for (const char quote : {'\'', '"'}) {
    const std::string name = quote + std::string(key) + quote;
    const std::size_t at = header.find(name);
    if (at == std::string_view::npos) continue;
    std::string_view rest = header.substr(at + name.size());
    while (!rest.empty() && (rest.front() == ' ' || rest.front() == ':')) rest.remove_prefix(1);
    return rest;
  }
  refuse(file, "is a .npy file whose header does not state \"{}\"; save it again", key);
}

std::optional<NumberType> pixel_of(std::string_view type) {
  using enum NumberType;
  static constexpr std::pair<std::string_view, NumberType> known[] = {
      {"u1", u8}, {"u2", u16}, {"i2", i16}, {"u4", u32}, {"i4", i32}, {"f4", f32}, {"f8", f64}};
  for (const auto& [name, number] : known)
    if (name == type) return number;
  return std::nullopt;
}

/// "(100, 240, 320)", or "(240, 320)" for one frame.
std::vector<std::int64_t> shape_in(std::string_view text, const std::string& file) {
  std::vector<std::int64_t> shape;
  text = text.substr(0, text.find(')'));
  for (std::size_t i = 0; i < text.size();) {
    std::int64_t n = 0;
    const auto [end, error] = std::from_chars(text.data() + i, text.data() + text.size(), n);
    if (error == std::errc::result_out_of_range)
      refuse(file, "declares more data than any file can hold; save it again");
    if (error == std::errc()) {
      shape.push_back(n);
      i = static_cast<std::size_t>(end - text.data());
    } else {
      ++i;
    }
  }
  if (shape.size() == 2) shape.insert(shape.begin(), 1);
  if (shape.size() != 3) refuse(file, "has {} dimensions; save an array of frames x height x width", shape.size());
  return shape;
}

constexpr std::size_t array_header_size = 128;
static_assert(array_header_size - 10 == 'v');

std::string npy_header(const FilmInfo& info, std::size_t frames) {
  std::string text("\x93NUMPY\x01\0v\0", 10);
  text += fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}, {}, {}), }}",
                      info.floating ? "<f4" : "<u2", frames, info.height, info.width);
  text.resize(array_header_size - 1, ' ');
  return text + '\n';
}

bool is_npy(std::string_view head) { return head.starts_with("\x93NUMPY"); }

FilmPointer open_npy(const Bytes& bytes, const FilmChoice& choice) {
  const std::string& file = bytes->name();
  const std::string head = bytes->text(0, 12);
  const int version = number_at<std::uint8_t>(head, 6);
  const std::size_t start = version == 1 ? 10 : 12;
  const std::size_t length = version == 1 ? number_at<std::uint16_t>(head, 8) : number_at<std::uint32_t>(head, 8);
  if (version < 1 || version > 3 || length > (std::size_t{1} << 20))
    refuse(file, "is a .npy file with an invalid header; save it again");
  const std::string header = bytes->text(start, length);
  if (header.size() < length) refuse(file, "is a .npy file that ends within its header; copy it again");
  const std::string_view type = value_of(header, "descr", file);
  const std::string_view order = value_of(header, "fortran_order", file);
  const auto pixel = type.size() > 4 ? pixel_of(type.substr(2, 2)) : std::nullopt;
  if (!pixel || (type[4] != '\'' && type[4] != '"'))
    refuse(file, "holds numbers of an unsupported type ({}); save u1, u2, i2, u4, i4, f4 or f8", type.substr(0, 8));
  if (order.starts_with("True")) refuse(file, "is stored in column order; save it with numpy.ascontiguousarray");
  const auto shape = shape_in(value_of(header, "shape", file), file);
  FilmInfo info;
  take_shape(info, file, shape, *pixel, choice);
  PlainLayout layout;
  layout.pixel = *pixel;
  layout.big_endian = type[1] == '>';
  layout.offset = start + length;
  layout.stride = info.pixels() * bytes_of(*pixel);
  return plain_film(bytes, std::move(info), layout, choice);
}

}  // namespace

/// NumPy: frames x height x width (or one frame), numbers of 1 to 8 bytes.
const FilmFormat films::npy{
    .name = "npy",
    .sentence = "NumPy .npy",
    .states = {{"column order", "refused"}, {"frames of NaN, or of zeros", "left out as lost, and named"}},

    .endings = {".npy"},
    .marked = true,
    .is = is_npy,
    .open = open_npy,
    .create = [](const auto& path, const FilmInfo& info) { return create_plain_film(path, info, {npy_header}); }};

}  // namespace arenite::io
