#include "io/film/formats.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/problems.hpp"
#include "core/text.hpp"
#include "io/table/table.hpp"

namespace arenite::io {
namespace {

class PlainFilm : public KnownFilm {
 public:
  PlainFilm(Bytes bytes, FilmInfo info, const PlainLayout& layout) : bytes_(std::move(bytes)), layout_(layout) {
    info_ = std::move(info);
  }

  void fill(std::int64_t first, std::size_t count, FrameBlock& block) override {
    const std::size_t pixels = info_.pixels(), frame = pixels * bytes_of(layout_.pixel);
    const bool as_is = layout_.pixel == NumberType::u16 && !layout_.big_endian && !info_.floating;
    const std::size_t at_once = std::max<std::size_t>(1, most_at_once / layout_.stride);
    for (std::size_t i = 0; i < count; i += at_once) {
      const std::size_t n = std::min(at_once, count - i);
      const std::uint64_t at = layout_.offset + (static_cast<std::uint64_t>(first) + i) * layout_.stride;
      if (as_is && layout_.stride == frame) {
        take(at, n * frame, reinterpret_cast<char*>(block.level.data() + i * pixels), first);
        continue;
      }
      buffer_.resize((n - 1) * layout_.stride + frame);
      take(at, buffer_.size(), buffer_.data(), first);
      for (std::size_t k = 0; k < n; ++k)
        take_pixels(layout_, buffer_.data() + k * layout_.stride, pixels, block, (i + k) * pixels);
    }
  }

 private:
  static constexpr std::size_t most_at_once = std::size_t{4} << 20;  // bytes in the buffer, if a frame is smaller

  void take(std::uint64_t at, std::size_t count, char* to, std::int64_t frame) const {
    if (bytes_->read(at, count, to) != count)
      refuse(bytes_->name(), "became shorter while frame {} was read; copy it again", frame);
  }

  Bytes bytes_;
  PlainLayout layout_;
  std::vector<char> buffer_;
};

class PlainFilmWriter : public FilmWriter {
 public:
  PlainFilmWriter(const std::filesystem::path& path, const FilmInfo& info, const FilmForm& form)
      : file_(path),
        info_(info),
        form_(form) {
    file_.write(form_.header(info_, 0));
  }
  void append(const FrameBlock& block) override {
    const std::string_view bytes = pixel_bytes(info_, block);
    const std::size_t n = form_.before != nullptr ? block.frames : std::min<std::size_t>(block.frames, 1);  // pieces
    for (std::size_t i = 0, size = n > 0 ? bytes.size() / n : 0; i < n; ++i) {
      if (form_.before != nullptr) file_.write(form_.before(info_, frames_ + i));
      file_.write(bytes.substr(i * size, size));
    }
    frames_ += block.frames;
  }
  void finish() override {
    file_.overwrite(0, form_.header(info_, frames_));
    file_.commit();
  }

 private:
  AtomicFile file_;
  FilmInfo info_;
  FilmForm form_;
  std::size_t frames_ = 0;
};

template <class Member> struct Noted {
  const char* key;
  Member FilmInfo::*member;
};
constexpr Noted<double> noted_numbers[] = {
    {"frame_rate", &FilmInfo::frame_rate}, {"integration", &FilmInfo::integration},
    {"emissivity", &FilmInfo::emissivity}, {"ambient", &FilmInfo::ambient},
    {"band_low", &FilmInfo::band_low},     {"band_high", &FilmInfo::band_high}};
constexpr Noted<std::string> noted_texts[] = {
    {"camera", &FilmInfo::camera}, {"lens", &FilmInfo::lens}, {"filter", &FilmInfo::filter}};

template <class Take> void each_note(std::string_view text, Take&& take) {
  Lines lines(text);
  for (std::string_view line; lines.next(line);)
    if (const auto equals = line.find('='); equals != std::string_view::npos)
      take(trimmed(line.substr(0, equals)), trimmed(line.substr(equals + 1)));
}

/// One line of text, whatever a camera's name holds.
std::string in_one_line(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  return text;
}

}  // namespace

void take_pixels(const PlainLayout& layout, const char* from, std::size_t count, FrameBlock& block, std::size_t at) {
  const auto each = [&](auto&& take) { each_number(layout.pixel, layout.big_endian, from, count, take); };
  if (!block.level.empty())
    return each([level = block.level.data() + at](std::size_t i, auto v) { level[i] = static_cast<std::uint16_t>(v); });
  float* const value = block.value.data() + at;
  if (!layout.scaled) return each([value](std::size_t i, auto v) { value[i] = static_cast<float>(v); });
  each([value, scale = layout.scale, shift = layout.shift](std::size_t i, auto v) {
    value[i] = static_cast<float>(scale * static_cast<double>(v) + shift);
  });
}

void check_film_size(const std::string& file, std::int64_t width, std::int64_t height, std::int64_t frames,
                     const FilmChoice& choice) {
  if (width <= 0 || height <= 0 || width > 1'000'000 || height > 1'000'000)
    refuse(file, "states that its frames have {} x {} pixels, which is impossible; copy it again", width, height);
  if (width * height > choice.most_pixels)
    refuse(file, "has frames of {} x {} pixels; at most {} pixels can be read, so cut them", width, height,
           choice.most_pixels);
  if (frames <= 0) refuse(file, "holds no frame; record the film again");
}

std::int64_t frames_there(const ByteSource& bytes, const PlainLayout& layout, std::size_t pixels) {
  const std::uint64_t frame = pixels * bytes_of(layout.pixel);
  if (layout.stride == 0 || bytes.size() < layout.offset || bytes.size() - layout.offset < frame) return 0;
  return static_cast<std::int64_t>((bytes.size() - layout.offset - frame) / layout.stride + 1);
}

void check_layout(const ByteSource& bytes, const FilmInfo& info, const PlainLayout& layout, const FilmChoice& choice) {
  check_film_size(bytes.name(), info.width, info.height, info.frames, choice);
  const std::int64_t there = frames_there(bytes, layout, info.pixels());
  if (there < info.frames)
    refuse(bytes.name(), "is cut short: it declares {} frames of {} x {} pixels and holds {}; copy it again",
           info.frames, info.width, info.height, there);
}

std::optional<double> zero_of_temperatures(std::string_view unit) {
  const std::string word = lower_case(trimmed(unit));
  if (word == "k" || word == "kelvin") return 0;
  constexpr std::array<std::string_view, 7> celsius{"degc",  "celsius",      "degree_celsius", "degrees_celsius",
                                                    "deg_c", "\xc2\xb0\x63", "\xb0\x63"};  // UTF-8, Latin-1
  if (std::ranges::count(celsius, word) > 0) return 273.15;
  return std::nullopt;
}

std::optional<double> zero_stated_in(std::string_view line) {
  for (const auto& [open, close] : {std::pair('[', ']'), std::pair('(', ')')}) {
    const std::size_t begin = line.find(open), end = line.find(close, begin);
    if (end == line.npos || line.find_first_of("0123456789", end) != line.npos) continue;
    if (const auto zero = zero_of_temperatures(line.substr(begin + 1, end - begin - 1))) return zero;
  }
  const std::size_t unit = lower_case(line).find("unit");
  if (unit == line.npos) return std::nullopt;
  const std::size_t sign = line.find_first_of("=:", unit);
  return sign == line.npos ? std::nullopt : zero_of_temperatures(line.substr(sign + 1));
}

void take_choice(FilmInfo& info, const FilmChoice& choice) {
  if (!choice.frame_rate) return;
  if (const auto dropped = frame_intervals(info).dropped; dropped > 0 && !info.time.empty())
    info.remarks.push_back(
        fmt::format("Time stamps say that {} frames are missing; a frame rate is given, so stamps are left aside and "
                    "frames taken as consecutive.",
                    dropped));
  info.frame_rate = *choice.frame_rate;
  info.time.clear();
}

FilmPointer plain_film(Bytes bytes, FilmInfo info, const PlainLayout& layout, const FilmChoice& choice) {
  check_layout(*bytes, info, layout, choice);
  take_choice(info, choice);
  info.floating = layout.scaled || !is_level(layout.pixel);
  if (info.bits == 0 && !info.floating) info.bits = static_cast<int>(8 * bytes_of(layout.pixel));
  return std::make_unique<PlainFilm>(std::move(bytes), std::move(info), layout);
}

void take_shape(FilmInfo& info, const std::string& file, const std::vector<std::int64_t>& shape, NumberType pixel,
                const FilmChoice& choice) {
  check_film_size(file, shape[2], shape[1], shape[0], choice);
  info.frames = shape[0];
  info.height = static_cast<int>(shape[1]);
  info.width = static_cast<int>(shape[2]);
  info.floating = !is_level(pixel);
  if (!info.floating) info.bits = static_cast<int>(8 * bytes_of(pixel));
}

void KnownFilm::read(std::int64_t first, std::size_t count, FrameBlock& block) {
  if (first < 0 || first > info_.frames || count > static_cast<std::uint64_t>(info_.frames - first))
    throw std::out_of_range("frames that the film does not have");
  block.prepare(info_, first, count);
  fill(first, count, block);
}

std::string_view pixel_bytes(const FilmInfo& info, const FrameBlock& block) {
  const std::size_t pixels = block.frames * info.pixels();
  if ((info.floating ? block.value.size() : block.level.size()) != pixels)
    throw std::invalid_argument("frames of another film");
  if (info.floating) return {reinterpret_cast<const char*>(block.value.data()), pixels * sizeof(float)};
  return {reinterpret_cast<const char*>(block.level.data()), pixels * sizeof(std::uint16_t)};
}

FilmWriterPointer create_plain_film(const std::filesystem::path& path, const FilmInfo& info, const FilmForm& form) {
  return std::make_unique<PlainFilmWriter>(path, info, form);
}

std::string film_notes(const FilmInfo& info) {
  std::string text;
  const auto note = [&](const char* key, const auto& value, bool known) {
    if (known) text += fmt::format("{} = {}\n", key, value);
  };
  for (const auto& [key, member] : noted_numbers) note(key, info.*member, info.*member > 0);
  note("bits", info.bits, info.bits > 0);
  note("quantity", info.quantity == FilmQuantity::kelvin ? "K" : "DL", info.quantity != FilmQuantity::unknown);
  for (const auto& [key, member] : noted_texts) note(key, in_one_line(info.*member), !(info.*member).empty());
  return text;
}

void take_notes(std::string_view text, FilmInfo& info) {
  each_note(text, [&](std::string_view noted, std::string_view value) {
    const auto number = to_number(value);
    const double positive = number && *number > 0 ? *number : 0;
    for (const auto& [key, member] : noted_numbers)
      if (key == noted) info.*member = positive;
    for (const auto& [key, member] : noted_texts)
      if (key == noted) info.*member = value;
    if (noted == "bits") info.bits = static_cast<int>(std::min(positive, 16.0));
    if (noted == "quantity" && value == "K") info.quantity = FilmQuantity::kelvin;
    if (noted == "quantity" && value == "DL") info.quantity = FilmQuantity::digital_level;
  });
}

}  // namespace arenite::io
