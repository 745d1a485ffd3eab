#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "io/film_formats.hpp"
#include "io/plain_film.hpp"

namespace arenite::io {
namespace {

[[noreturn]] void refuse(const std::string& file, const std::string& what) { throw InputError(file, 0, what); }

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
  refuse(file, fmt::format("is a .npy file whose header does not say \"{}\"; save it again", key));
}

std::optional<Sample> sample_of(std::string_view type) {
  if (type == "u1") return Sample::u8;
  if (type == "u2") return Sample::u16;
  if (type == "i2") return Sample::i16;
  if (type == "u4") return Sample::u32;
  if (type == "i4") return Sample::i32;
  if (type == "f4") return Sample::f32;
  if (type == "f8") return Sample::f64;
  return std::nullopt;
}

/// "(100, 240, 320)", or "(240, 320)" for one frame.
std::vector<std::int64_t> shape_of(std::string_view text, const std::string& file) {
  std::vector<std::int64_t> shape;
  text = text.substr(0, text.find(')'));
  for (std::size_t i = 0; i < text.size();) {
    std::int64_t n = 0;
    const auto [end, error] = std::from_chars(text.data() + i, text.data() + text.size(), n);
    if (error == std::errc::result_out_of_range) refuse(file, "says that it holds more than any file does; save it again");
    if (error == std::errc()) {
      shape.push_back(n);
      i = static_cast<std::size_t>(end - text.data());
    } else {
      ++i;
    }
  }
  if (shape.size() == 2) shape.insert(shape.begin(), 1);
  if (shape.size() != 3) refuse(file, fmt::format("has {} dimensions; save an array of frames x height x width", shape.size()));
  return shape;
}

}  // namespace

bool is_npy(std::string_view head) { return head.starts_with("\x93NUMPY"); }

FilmPointer open_npy(const Bytes& bytes, const FilmChoice& choice) {
  const std::string& file = bytes->name();
  const std::string head = bytes->text(0, 12);
  const int version = number_at<std::uint8_t>(head, 6);
  const std::size_t start = version == 1 ? 10 : 12;
  const std::size_t length = version == 1 ? number_at<std::uint16_t>(head, 8) : number_at<std::uint32_t>(head, 8);
  if (version < 1 || version > 3 || length > (std::size_t{1} << 20)) refuse(file, "is a .npy file with a header that cannot be; save it again");
  const std::string header = bytes->text(start, length);
  if (header.size() < length) refuse(file, "is a .npy file that ends within its header; copy it again");
  const std::string_view type = value_of(header, "descr", file);
  const std::string_view order = value_of(header, "fortran_order", file);
  const auto sample = type.size() > 4 ? sample_of(type.substr(2, 2)) : std::nullopt;
  if (!sample || (type[4] != '\'' && type[4] != '"'))
    refuse(file, fmt::format("holds numbers of a type that is no pixel ({}); save u1, u2, i2, u4, i4, f4 or f8", type.substr(0, 8)));
  if (order.starts_with("True")) refuse(file, "holds its columns first; save it with numpy.ascontiguousarray");
  const auto shape = shape_of(value_of(header, "shape", file), file);
  check_film_size(file, shape[2], shape[1], shape[0], choice);
  FilmInfo info;
  info.format = "npy";
  info.frames = shape[0];
  info.height = static_cast<int>(shape[1]);
  info.width = static_cast<int>(shape[2]);
  PlainLayout layout;
  layout.sample = *sample;
  layout.big_endian = type[1] == '>';
  layout.offset = start + length;
  layout.stride = info.pixels() * bytes_of(*sample);
  return plain_film(bytes, std::move(info), layout, choice);
}

}  // namespace arenite::io
