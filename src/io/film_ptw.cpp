#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/error.hpp"
#include "io/film_formats.hpp"
#include "io/film_times.hpp"
#include "io/lock_in_line.hpp"
#include "io/plain_film.hpp"

namespace arenite::io {
namespace {

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
  Sizes s{number_at<std::int32_t>(header, 11), number_at<std::int32_t>(header, 15), number_at<std::int32_t>(header, 23),
          number_at<std::int32_t>(header, 27), number_at<std::int16_t>(header, 377), number_at<std::int16_t>(header, 379)};
  if (s.main < 411 || s.main > (1 << 24) || s.frame_header < 0 || s.frame_header > (1 << 24))
    throw InputError(file, 0, fmt::format("says that its headers have {} and {} bytes, which no .ptw film has; copy it again", s.main, s.frame_header));
  if (s.frame_words != s.width * s.height)
    throw InputError(file, 0, fmt::format("says that a frame has {} x {} pixels and {} numbers, which disagree; copy it again",
                                          s.width, s.height, s.frame_words));
  return s;
}

/// The stamp of a frame's header, s after midnight: hours, minutes, seconds, hundredths, thousandths and microseconds
/// each in a place of its own.
double stamp_of(std::string_view h) {
  const auto byte = [&](std::size_t at) { return static_cast<double>(number_at<std::uint8_t>(h, at)); };
  return byte(81) * 3600 + byte(80) * 60 + byte(83) + byte(82) * 1e-2 + byte(160) * 1e-3 + number_at<std::uint16_t>(h, 161) * 1e-6;
}

void read_stamps(const ByteSource& bytes, const Sizes& s, FilmInfo& info) {
  constexpr std::size_t needed = 163;
  if (s.frame_header < static_cast<std::int64_t>(needed)) return;
  std::vector<double> stamp;
  for (std::int64_t i = 0; i < s.frames; ++i)
    stamp.push_back(stamp_of(bytes.text(static_cast<std::uint64_t>(s.main + i * (s.frame_header + 2 * s.frame_words)), needed)));
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

FilmInfo info_of(std::string_view header, const Sizes& s) {
  FilmInfo info;
  info.format = "ptw";
  info.quantity = FilmQuantity::digital_level;
  info.width = static_cast<int>(s.width);
  info.height = static_cast<int>(s.height);
  info.frames = s.frames;
  info.camera = name_at(header, 44, 20);
  info.lens = name_at(header, 64, 20);
  info.filter = name_at(header, 84, 20);
  info.emissivity = positive_at(header, 141);
  info.ambient = positive_at(header, 145);
  info.band_low = positive_at(header, 188) * 1e-6;
  info.band_high = positive_at(header, 192) * 1e-6;
  // A float's 0.01 is a double's 0.00999999978: its seven digits are what was meant.
  const auto meant = [](double v) { return std::stod(fmt::format("{:.7g}", v)); };
  const double period = meant(positive_at(header, 403));
  info.frame_rate = period > 0 && std::isfinite(1 / period) ? 1 / period : 0;
  info.integration = meant(positive_at(header, 407));
  const int bits = number_at<std::int16_t>(header, 381);
  info.bits = bits > 0 && bits <= 16 ? bits : 16;
  return info;
}

}  // namespace

bool is_ptw(std::string_view head) { return head.starts_with("CED") && head.size() > 11 && (head[3] == '\0' || head[3] == ' '); }

std::vector<double> lock_in_line(const std::filesystem::path& film) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(film, error)) return {};
  const Bytes bytes = open_bytes(film);
  const std::string header = bytes->text(0, 3476);
  if (!is_ptw(header) || header.size() < 411) return {};
  const Sizes s = sizes_of(header, bytes->name());
  if (!is_lock_in(*bytes, s)) return {};
  const std::size_t words = static_cast<std::size_t>(s.width) - mark.size();
  const auto line_of = [&](std::int64_t frame) {
    return bytes->text(static_cast<std::uint64_t>(s.main + s.frame_header + frame * (s.frame_header + 2 * s.frame_words)) + 2 * mark.size(), 2 * words);
  };
  const std::string first = line_of(0);
  std::vector<char> changes(words, 0);
  std::vector<std::string> lines;
  for (std::int64_t frame = 0; frame < s.frames; ++frame) {
    lines.push_back(line_of(frame));
    if (lines.back().size() != first.size()) return {};  // cut short, which reading it as a film says
    for (std::size_t i = 0; i < words; ++i) changes[i] = changes[i] != 0 || number_at<std::uint16_t>(lines.back(), 2 * i) != number_at<std::uint16_t>(first, 2 * i);
  }
  const auto counted = static_cast<double>(std::count(changes.begin(), changes.end(), 1));
  if (counted == 0) return {};
  std::vector<double> signal;
  for (const std::string& line : lines) {
    double sum = 0;
    for (std::size_t i = 0; i < words; ++i)
      if (changes[i] != 0) sum += number_at<std::uint16_t>(line, 2 * i);
    signal.push_back(sum / counted);
  }
  return signal;
}

FilmPointer open_ptw(const Bytes& bytes, const FilmChoice& choice) {
  const std::string header = bytes->text(0, 3476);
  if (header.size() < 411) throw InputError(bytes->name(), 0, "is a .ptw film that ends within its header; copy it again");
  const Sizes s = sizes_of(header, bytes->name());
  FilmInfo info = info_of(header, s);
  check_film_size(bytes->name(), s.width, s.height, s.frames, choice);
  PlainLayout layout;
  layout.offset = static_cast<std::uint64_t>(s.main + s.frame_header);
  layout.stride = static_cast<std::uint64_t>(s.frame_header + 2 * s.frame_words);
  if (is_lock_in(*bytes, s)) {
    info.height -= 1;
    layout.offset += static_cast<std::uint64_t>(2 * s.width);
    info.remarks.emplace_back("A lock-in film: the first line of its frames holds the lock-in signal and is left out of the picture; it gives the frequency and the phase of the load.");
  }
  check_layout(*bytes, info, layout, choice);  // before stamps are read of frames that are not there
  if (!choice.frame_rate) read_stamps(*bytes, s, info);
  return plain_film(bytes, std::move(info), layout, choice);
}

}  // namespace arenite::io
