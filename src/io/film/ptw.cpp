#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "io/film/formats.hpp"

namespace arenite::io {
namespace {

constexpr std::size_t main_header = 3476, frame_header = 1016;  // bytes, as cameras write them

/// A text of at most `size` bytes that ends at the first zero, without what is not printable.
std::string name_at(std::string_view header, std::size_t at, std::size_t size) {
  std::string name;
  for (const char c : header.substr(at, size)) {
    if (c == '\0') break;
    if (c >= ' ' && c <= '~') name += c;
  }
  return name;
}

double positive_at(std::string_view header, std::size_t at) {
  const double value = number_at<float>(header, at);
  return std::isfinite(value) && value > 0 ? value : 0;
}

struct Sizes {
  std::int64_t main = 0, frame_header = 0, frame_words = 0, frames = 0, width = 0, height = 0;
};

Sizes sizes_of(std::string_view header, const std::string& file) {
  if (header.size() < 411) refuse(file, "is a .ptw film that ends within its header; copy it again");
  Sizes s{number_at<std::int32_t>(header, 11),  number_at<std::int32_t>(header, 15),
          number_at<std::int32_t>(header, 23),  number_at<std::int32_t>(header, 27),
          number_at<std::int16_t>(header, 377), number_at<std::int16_t>(header, 379)};
  if (s.main < 411 || s.main > (1 << 24) || s.frame_header < 0 || s.frame_header > (1 << 24))
    refuse(file, "states that its headers have {} and {} bytes, which is impossible in a .ptw film; copy it again",
           s.main, s.frame_header);
  if (s.frame_words != s.width * s.height)
    refuse(file, "states that a frame has {} x {} pixels and {} numbers, which disagree; copy it again", s.width,
           s.height, s.frame_words);
  return s;
}

/// The stamp of a frame's header, s after midnight: hours, minutes, seconds, hundredths, thousandths and microseconds
/// each in a place of its own.
double stamp_of(std::string_view h) {
  const auto byte = [&](std::size_t at) { return static_cast<double>(number_at<std::uint8_t>(h, at)); };
  return byte(81) * 3600 + byte(80) * 60 + byte(83) + byte(82) * 1e-2 + byte(160) * 1e-3 +
         number_at<std::uint16_t>(h, 161) * 1e-6;
}

void read_stamps(const ByteSource& bytes, const Sizes& s, FilmInfo& info) {
  constexpr std::size_t needed = 163;
  if (s.frame_header < static_cast<std::int64_t>(needed)) return;
  std::vector<double> stamp;
  for (std::int64_t i = 0; i < s.frames; ++i)
    stamp.push_back(
        stamp_of(bytes.text(static_cast<std::uint64_t>(s.main + i * (s.frame_header + 2 * s.frame_words)), needed)));
  take_stamps(info, std::move(stamp));
}

/// A lock-in film begins its frames with these numbers.
constexpr std::array<std::uint16_t, 4> mark{1220, 3907, 1204, 2382};

bool is_lock_in(const ByteSource& bytes, const Sizes& s) {
  const std::string line = bytes.text(static_cast<std::uint64_t>(s.main + s.frame_header), 2 * mark.size());
  for (std::size_t i = 0; i < mark.size(); ++i)
    if (number_at<std::uint16_t>(line, 2 * i) != mark[i]) return false;
  return s.height > 1 && s.width >= 4;
}

/// Where a header says what the camera is and sees; numbers in a unit of their own.
struct Name {
  std::size_t at;
  std::string FilmInfo::*member;
};
struct Number {
  std::size_t at;
  double FilmInfo::*member;
  double unit;
};
constexpr Name name_fields[] = {{44, &FilmInfo::camera}, {64, &FilmInfo::lens}, {84, &FilmInfo::filter}};
constexpr Number numbers[] = {{141, &FilmInfo::emissivity, 1},
                              {145, &FilmInfo::ambient, 1},
                              {188, &FilmInfo::band_low, 1e-6},
                              {192, &FilmInfo::band_high, 1e-6}};

FilmInfo info_of(std::string_view header, const Sizes& s) {
  FilmInfo info;
  info.quantity = FilmQuantity::digital_level;
  info.width = static_cast<int>(s.width);
  info.height = static_cast<int>(s.height);
  info.frames = s.frames;
  for (const auto& [at, member] : name_fields) info.*member = name_at(header, at, 20);
  for (const auto& [at, member, unit] : numbers) info.*member = positive_at(header, at) * unit;
  // A float's 0.01 is a double's 0.00999999978: its seven digits are what was meant.
  const auto meant = [](double v) { return std::stod(fmt::format("{:.7g}", v)); };
  const double period = meant(positive_at(header, 403));
  info.frame_rate = period > 0 && std::isfinite(1 / period) ? 1 / period : 0;
  info.integration = meant(positive_at(header, 407));
  const int bits = number_at<std::int16_t>(header, 381);
  info.bits = bits > 0 && bits <= 16 ? bits : 16;
  return info;
}

std::string ptw_header(const FilmInfo& info, std::size_t frames) {
  std::string h(main_header, '\0');
  const auto words = static_cast<std::int32_t>(info.pixels());
  h.replace(0, 3, "CED");
  h.replace(5, 4, "5.60");
  h[10] = 26;
  put<std::int32_t>(h, 11, main_header);
  put<std::int32_t>(h, 15, frame_header);
  put<std::int32_t>(h, 19, words + static_cast<std::int32_t>(frame_header) / 2);
  put<std::int32_t>(h, 23, words);
  put<std::int32_t>(h, 27, static_cast<std::int32_t>(frames));
  for (const auto& [at, member] : name_fields)
    h.replace(at, std::min<std::size_t>((info.*member).size(), 19), info.*member, 0, 19);
  for (const auto& [at, member, unit] : numbers)
    put<float>(h, at, static_cast<float>(info.*member * std::round(1 / unit)));
  put<std::int16_t>(h, 377, static_cast<std::int16_t>(info.width));
  put<std::int16_t>(h, 379, static_cast<std::int16_t>(info.height));
  put<std::int16_t>(h, 381, static_cast<std::int16_t>(info.bits > 0 ? info.bits : 16));
  put<float>(h, 403, info.frame_rate > 0 ? static_cast<float>(1 / info.frame_rate) : 0.0F);
  put<float>(h, 407, static_cast<float>(info.integration));
  return h;
}

/// Microseconds after midnight, in the places of a camera's own headers; zeros without times.
std::string stamp(const FilmInfo& info, std::size_t frame) {
  std::string h(frame_header, '\0');
  put<std::uint32_t>(h, 292, static_cast<std::uint32_t>(frame + 1));
  if (frame >= info.time.size()) return h;
  constexpr std::uint64_t day = 86400'000'000;
  const auto us = static_cast<std::uint64_t>(std::llround(info.time[frame] * 1e6)) % day;
  h[81] = static_cast<char>(us / 3600'000'000);
  h[80] = static_cast<char>(us / 60'000'000 % 60);
  h[83] = static_cast<char>(us / 1'000'000 % 60);
  h[82] = static_cast<char>(us / 10'000 % 100);
  h[160] = static_cast<char>(us / 1000 % 10);
  put<std::uint16_t>(h, 161, static_cast<std::uint16_t>(us % 1000));
  put<std::uint64_t>(h, 301, us);
  return h;
}

bool is_ptw(std::string_view head) {
  return head.starts_with("CED") && head.size() > 11 && (head[3] == '\0' || head[3] == ' ');
}

FilmPointer open_ptw(const Bytes& bytes, const FilmChoice& choice) {
  const std::string header = bytes->text(0, main_header);
  const Sizes s = sizes_of(header, bytes->name());
  FilmInfo info = info_of(header, s);
  check_film_size(bytes->name(), s.width, s.height, s.frames, choice);
  PlainLayout layout;
  layout.offset = static_cast<std::uint64_t>(s.main + s.frame_header);
  layout.stride = static_cast<std::uint64_t>(s.frame_header + 2 * s.frame_words);
  if (is_lock_in(*bytes, s)) {
    info.height -= 1;
    layout.offset += static_cast<std::uint64_t>(2 * s.width);
    info.remarks.emplace_back(
        "A lock-in film: the first line of its frames holds the lock-in signal and is left out of the picture; it "
        "gives the frequency and the phase of the load.");
  }
  check_layout(*bytes, info, layout, choice);  // before stamps are read of frames that are not there
  read_stamps(*bytes, s, info);
  return plain_film(bytes, std::move(info), layout, choice);
}

/// One number a frame: the mean of those words of the first line, after those that mark it, which change over the film.
std::vector<double> signal_of(const ByteSource& bytes) {
  const Sizes s = sizes_of(bytes.text(0, main_header), bytes.name());
  if (!is_lock_in(bytes, s)) return {};
  const std::size_t words = static_cast<std::size_t>(s.width) - mark.size();
  std::vector<std::string> lines;
  std::vector<char> changes(words, 0);
  for (std::int64_t frame = 0; frame < s.frames; ++frame) {
    lines.push_back(
        bytes.text(static_cast<std::uint64_t>(s.main + s.frame_header + frame * (s.frame_header + 2 * s.frame_words)) +
                       2 * mark.size(),
                   2 * words));
    if (lines.back().size() != 2 * words) return {};  // cut short, which reading it as a film says
    for (std::size_t i = 0; i < words; ++i)
      if (lines.back().compare(2 * i, 2, lines.front(), 2 * i, 2) != 0) changes[i] = 1;
  }
  const auto counted = static_cast<double>(std::count(changes.begin(), changes.end(), 1));
  if (counted == 0) return {};
  return mapped(lines, [&](const std::string& line) {
    double sum = 0;
    for (std::size_t i = 0; i < words; ++i)
      if (changes[i] != 0) sum += number_at<std::uint16_t>(line, 2 * i);
    return sum / counted;
  });
}

}  // namespace

/// Cedip/FLIR: a main header, then frames with headers of their own, whose stamps give the times. A lock-in film holds
/// the lock-in signal in the first line of its frames, which is left out.
const FilmFormat films::ptw{
    .name = "ptw",
    .sentence = "Cedip or FLIR .ptw",
    .states = {{"time stamps", "used; told where they differ from the frame rate, or are set aside by --frame-rate"},
               {"frame rate, integration, band, emissivity, surroundings", "used"},
               {"lock-in line", "gives frequency and phase of the load"},
               {"frames of one number, or the frame before once more", "left out as lost, and named"}},

    .endings = {".ptw"},
    .marked = true,
    .levels_only = true,
    .is = is_ptw,
    .open = open_ptw,
    .create =
        [](const auto& path, const FilmInfo& info) {
          return create_plain_film(path, info, {ptw_header, stamp});
        },
    .lock_in_line = signal_of};

}  // namespace arenite::io
