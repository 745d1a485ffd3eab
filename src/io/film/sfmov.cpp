#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "core/problems.hpp"
#include "core/text.hpp"
#include "io/film/formats.hpp"
#include "io/table/table.hpp"

namespace arenite::io {
namespace {

constexpr std::size_t longest_header = std::size_t{1} << 20;

using Keys = std::map<std::string, std::string, std::less<>>;

/// Lines "key value" up to the word DATA.
Keys keys_of(std::string_view text) {
  Keys keys;
  Lines lines(text);
  for (std::string_view line; lines.next(line);) {
    const auto cells = split_blanks(line);
    if (!cells.empty() && cells[0] == "DATA") break;
    if (cells.size() >= 2)
      keys.emplace(cells[0], std::string(line.substr(static_cast<std::size_t>(cells[1].data() - line.data()))));
  }
  return keys;
}

/// Empty where the header does not say it.
std::string text_of(const Keys& keys, const char* key) {
  const auto found = keys.find(key);
  return found != keys.end() ? found->second : std::string();
}

std::int64_t count_of(const Keys& keys, const char* key, const std::string& file) {
  const auto value = to_integer(text_of(keys, key));
  if (!value) refuse(file, "is a .sfmov film whose header does not state {}; export it again", key);
  return *value;
}

double number_of(const Keys& keys, const char* key) {
  const auto value = to_number(text_of(keys, key));
  return value && *value > 0 ? *value : 0;
}

/// Where the word DATA begins a line; npos if nowhere.
std::size_t find_data(std::string_view header) {
  for (std::size_t at = header.find("DATA"); at != std::string_view::npos; at = header.find("DATA", at + 1))
    if (at == 0 || header[at - 1] == '\n' || header[at - 1] == '\r' || header[at - 1] == '\0') return at;
  return std::string_view::npos;
}

/// Frame rate and integration time may stand in the file that the header includes.
Keys included(const Keys& keys, const ByteSource& bytes) {
  const std::string name = text_of(keys, "Include");
  if (name.empty() || bytes.path() == nullptr) return {};
  const auto beside = bytes.path()->parent_path() / std::filesystem::path(name).filename();
  std::error_code error;
  if (!std::filesystem::is_regular_file(beside, error)) return {};
  return keys_of(open_bytes(beside)->text(0, longest_header));
}

NumberType pixel_of(const Keys& keys, const std::string& file) {
  const auto found = keys.find("DaType");
  const std::string type = found != keys.end() ? lower_case(split_blanks(found->second).front()) : "";
  // Levels have at most 15 bits where the file calls them signed.
  if (type.empty() || type == "uint16" || type == "int16" || type == "word") return NumberType::u16;
  if (type == "flt32" || type == "float32" || type == "single") return NumberType::f32;
  if (type == "flt64" || type == "float64" || type == "double") return NumberType::f64;
  if (type == "uint8" || type == "byte") return NumberType::u8;
  refuse(file, "holds pixels of type \"{}\"; export it with 16-bit levels or Flt32", type);
}

/// Digits left free for the number of frames, which is known at the end.
constexpr std::size_t count_width = 12;

std::string sfmov_header(const FilmInfo& info, std::size_t frames) {
  std::string text = fmt::format("HdSize auto\r\nNumDPs {:0{}}\r\nxPixls {}\r\nyPixls {}\r\nDaType {}\r\n", frames,
                                 count_width, info.width, info.height, info.floating ? "Flt32" : "UInt16");
  if (info.bits > 0) text += fmt::format("ADBits {}\r\n", info.bits);
  if (info.frame_rate > 0) text += fmt::format("FRate_0 {}\r\n", info.frame_rate);
  if (info.integration > 0) text += fmt::format("ITime_0 {}\r\n", info.integration * 1e3);
  return text + "DATA\r\n";
}

bool is_sfmov(std::string_view head) {
  const std::size_t data = find_data(head);
  return head.substr(0, data).find("xPixls") != std::string_view::npos &&
         head.substr(0, data).find("yPixls") != std::string_view::npos;
}

FilmPointer open_sfmov(const Bytes& bytes, const FilmChoice& choice) {
  const std::string& file = bytes->name();
  const std::string header = bytes->text(0, longest_header);
  const std::size_t data = find_data(header);
  if (data == std::string::npos) refuse(file, "is a .sfmov film that ends within its header; copy it again");
  Keys keys = keys_of(std::string_view(header).substr(0, data));
  FilmInfo info;
  const std::int64_t width = count_of(keys, "xPixls", file), height = count_of(keys, "yPixls", file),
                     frames = count_of(keys, "NumDPs", file);
  PlainLayout layout;
  take_shape(info, file, {frames, height, width}, layout.pixel, choice);
  keys.merge(included(keys, *bytes));
  info.frame_rate = number_of(keys, "FRate_0");
  info.integration = number_of(keys, "ITime_0") * 1e-3;
  info.bits = static_cast<int>(std::min(number_of(keys, "ADBits"), 16.0));
  info.camera = text_of(keys, "Camera");
  layout.pixel = pixel_of(keys, file);
  layout.stride = info.pixels() * bytes_of(layout.pixel);
  layout.offset = data + 6;  // the word and the end of its line
  const bool short_end = header.compare(data + 4, 1, "\n") == 0;
  if (short_end && static_cast<std::uint64_t>(info.frames) * layout.stride == bytes->size() - (data + 5))
    layout.offset = data + 5;
  if (is_level(layout.pixel)) info.quantity = FilmQuantity::digital_level;
  return plain_film(bytes, std::move(info), layout, choice);
}

}  // namespace

/// FLIR ResearchIR: lines "key value", the word DATA, then frames.
const FilmFormat films::sfmov{
    .name = "sfmov",
    .sentence = "FLIR ResearchIR .sfmov",
    .states = {{"frame rate and integration time, also in the file it includes", "used"},
               {"frames of NaN, of one number, or the frame before once more", "left out as lost, and named"}},

    .endings = {".sfmov"},
    .marked = true,
    .is = is_sfmov,
    .open = open_sfmov,
    .create = [](const auto& path, const FilmInfo& info) { return create_plain_film(path, info, {sfmov_header}); }};

}  // namespace arenite::io
