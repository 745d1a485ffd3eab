#include "io/disk/numpy_header.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "core/text.hpp"

namespace arenite::io {
namespace {

/// What follows "'key':" in the header's dictionary.
std::string_view stated_in(std::string_view header, std::string_view key, const std::string& file) {
  for (const char quote : {'\'', '"'}) {
    const std::string name = quote + std::string(key) + quote;
    const std::size_t at = header.find(name);
    if (at == std::string_view::npos) continue;
    std::string_view rest = header.substr(at + name.size());
    rest.remove_prefix(std::min(rest.find_first_not_of(" :"), rest.size()));
    return rest;
  }
  refuse(file, "is a .npy array whose header does not state \"{}\"; save it again", key);
}

std::optional<NumberType> number_of(std::string_view word) {
  using enum NumberType;
  static constexpr std::pair<std::string_view, NumberType> known[] = {
      {"b1", u8},  {"u1", u8},  {"i1", i8},  {"u2", u16}, {"i2", i16}, {"u4", u32},
      {"i4", i32}, {"u8", u64}, {"i8", i64}, {"f4", f32}, {"f8", f64}};
  for (const auto& [name, type] : known)
    if (name == word) return type;
  return std::nullopt;
}

/// "(100, 240, 320)".
std::vector<std::int64_t> shape_in(std::string_view text, const std::string& file) {
  std::vector<std::int64_t> shape;
  text = text.substr(0, text.find(')'));
  for (std::size_t i = 0; i < text.size();) {
    std::int64_t n = 0;
    const auto [end, error] = std::from_chars(text.data() + i, text.data() + text.size(), n);
    if (error == std::errc::result_out_of_range)
      refuse(file, "declares more data than any file can hold; save it again");
    if (error == std::errc()) shape.push_back(n);
    i = error == std::errc() ? static_cast<std::size_t>(end - text.data()) : i + 1;
  }
  return shape;
}

}  // namespace

bool is_numpy_array(std::string_view head) { return head.starts_with("\x93NUMPY"); }

NumpyHeader numpy_header_in(const Bytes& bytes) {
  const std::string& file = bytes->name();
  const std::string head = bytes->text(0, 12);
  if (!is_numpy_array(head)) refuse(file, "holds no .npy array; save it with numpy.save or numpy.savez");
  const int version = head.size() > 6 ? number_at<std::uint8_t>(head, 6) : 0;
  NumpyHeader array;
  array.start = version == 1 ? 10 : 12;
  if (head.size() < array.start) refuse(file, "is a .npy array that ends within its header; copy it again");
  const std::size_t length = version == 1 ? number_at<std::uint16_t>(head, 8) : number_at<std::uint32_t>(head, 8);
  if (version < 1 || version > 3 || length > (std::size_t{1} << 20))
    refuse(file, "is a .npy array with an invalid header; save it again");
  const std::string header = bytes->text(array.start, length);
  if (header.size() < length) refuse(file, "is a .npy array that ends within its header; copy it again");
  array.start += length;
  const std::string_view type = stated_in(header, "descr", file);
  if (!type.starts_with('\'') && !type.starts_with('"'))
    refuse(file, "has records instead of numbers; save one array of numbers");
  array.type = type.substr(1, type.find(type.front(), 1) - 1);
  array.big_endian = array.type.starts_with('>');
  if (array.type.size() == 3) array.number = number_of(std::string_view(array.type).substr(1));
  array.fortran = stated_in(header, "fortran_order", file).starts_with("True");
  array.shape = shape_in(stated_in(header, "shape", file), file);
  return array;
}

std::string numpy_file(std::string_view type, const std::vector<std::int64_t>& shape, std::string_view numbers) {
  std::string header = fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}{}), }}", type,
                                   list_of(mapped(shape, [](std::int64_t n) { return std::to_string(n); })),
                                   shape.size() == 1 ? "," : "");
  constexpr std::size_t before = 10, multiple = 64;  // the numbers begin at a multiple
  header.append(multiple - (before + header.size() + 1) % multiple, ' ');
  header += '\n';
  std::string bytes("\x93NUMPY\x01\x00", 8);
  bytes += static_cast<char>(header.size() & 0xffU);
  bytes += static_cast<char>(header.size() >> 8U);
  bytes.reserve(bytes.size() + header.size() + numbers.size());
  return bytes.append(header).append(numbers);
}

}  // namespace arenite::io
