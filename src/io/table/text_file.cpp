#include "io/table/text_file.hpp"

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <utility>

#include "core/problems.hpp"
#include "core/text.hpp"
#include "io/disk/file.hpp"

namespace arenite::io {
namespace {

/// Appends a character of Unicode in UTF-8.
void append_utf8(std::string& text, std::uint32_t code) {
  const auto put = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
  if (code < 0x80) return put(code);
  const auto more = [&](int shift) { put(0x80 | (code >> shift & 0x3f)); };
  if (code < 0x800) return put(0xc0 | code >> 6), more(0);
  if (code < 0x10000) return put(0xe0 | code >> 12), more(6), more(0);
  put(0xf0 | code >> 18), more(12), more(6), more(0);
}

/// Units of two bytes; two surrogates are one character, one alone is none.
std::string from_utf16(std::string_view bytes, bool big_endian) {
  std::string text;
  std::uint32_t high = 0;
  for (std::size_t at = 0; at + 1 < bytes.size(); at += 2) {
    const auto a = static_cast<unsigned char>(bytes[at]), b = static_cast<unsigned char>(bytes[at + 1]);
    const std::uint32_t unit = big_endian ? a << 8u | b : b << 8u | a;
    if (unit >> 10 == 0x36) {
      high = unit;
    } else if (unit >> 10 == 0x37) {
      if (high != 0) append_utf8(text, 0x10000 + ((high & 0x3ff) << 10) + (unit & 0x3ff));
      high = 0;
    } else {
      append_utf8(text, unit);
    }
  }
  return text;
}

std::string from_latin1(std::string_view bytes) {
  std::string text;
  for (const char c : bytes) append_utf8(text, static_cast<unsigned char>(c));
  return text;
}

}  // namespace

std::string as_utf8(std::string bytes) {
  if (bytes.starts_with("\xFF\xFE")) bytes = from_utf16(std::string_view(bytes).substr(2), false);
  else if (bytes.starts_with("\xFE\xFF")) bytes = from_utf16(std::string_view(bytes).substr(2), true);
  else if (bytes.starts_with("\xEF\xBB\xBF")) bytes.erase(0, 3);
  if (!is_utf8(bytes)) bytes = from_latin1(bytes);
  if (bytes.find('\n') == std::string::npos) std::ranges::replace(bytes, '\r', '\n');
  return bytes;
}

std::string read_text(const std::filesystem::path& path) {
  std::string bytes = read_file(path);
  refuse_compressed(bytes, path.string());
  std::string text = as_utf8(std::move(bytes));
  if (text.find('\0') == std::string::npos) return text;
  refuse(path.string(),
         "is not a text file; results (.h5) are for `arenite show`, or for `arenite export --to csv`, whose tables can "
         "be measured");
}

}  // namespace arenite::io
