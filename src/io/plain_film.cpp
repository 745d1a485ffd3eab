#include "io/plain_film.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <type_traits>

#include "core/error.hpp"

namespace arenite::io {
namespace {

template <class T>
T swapped(T value) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  std::reverse(bytes, bytes + sizeof(T));
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

template <class T, class Out>
void convert(const char* from, std::size_t count, bool swap, Out&& out) {
  for (std::size_t i = 0; i < count; ++i) {
    T value;
    std::memcpy(&value, from + i * sizeof(T), sizeof(T));
    out(i, swap ? swapped(value) : value);
  }
}

/// Calls `out` with place and number of every pixel.
template <class Out>
void each_pixel(const PlainLayout& layout, const char* from, std::size_t count, Out&& out) {
  switch (layout.sample) {
    case Sample::u8: return convert<std::uint8_t>(from, count, false, out);
    case Sample::i8: return convert<std::int8_t>(from, count, false, out);
    case Sample::u16: return convert<std::uint16_t>(from, count, layout.big_endian, out);
    case Sample::i16: return convert<std::int16_t>(from, count, layout.big_endian, out);
    case Sample::u32: return convert<std::uint32_t>(from, count, layout.big_endian, out);
    case Sample::i32: return convert<std::int32_t>(from, count, layout.big_endian, out);
    case Sample::u64: return convert<std::uint64_t>(from, count, layout.big_endian, out);
    case Sample::i64: return convert<std::int64_t>(from, count, layout.big_endian, out);
    case Sample::f32: return convert<float>(from, count, layout.big_endian, out);
    case Sample::f64: return convert<double>(from, count, layout.big_endian, out);
  }
}

class PlainFilm : public FilmSource {
 public:
  PlainFilm(Bytes bytes, FilmInfo info, const PlainLayout& layout) : bytes_(std::move(bytes)), info_(std::move(info)), layout_(layout) {}
  const FilmInfo& info() const override { return info_; }

  void read(std::int64_t first, std::size_t count, FrameBlock& block) override {
    prepare(info_, first, count, block);
    const std::size_t pixels = info_.pixels(), frame = pixels * bytes_of(layout_.sample);
    const bool as_is = layout_.sample == Sample::u16 && !layout_.big_endian && !info_.floating;
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
      for (std::size_t k = 0; k < n; ++k) {
        const char* from = buffer_.data() + k * layout_.stride;
        take_pixels(layout_, from, pixels, info_.floating ? nullptr : block.level.data() + (i + k) * pixels,
                    info_.floating ? block.value.data() + (i + k) * pixels : nullptr);
      }
    }
  }

 private:
  static constexpr std::size_t most_at_once = std::size_t{4} << 20;  // bytes in the buffer, if a frame is smaller

  void take(std::uint64_t at, std::size_t count, char* to, std::int64_t frame) const {
    if (bytes_->read(at, count, to) != count)
      throw InputError(bytes_->name(), 0, fmt::format("became shorter while frame {} was read; copy it again", frame));
  }

  Bytes bytes_;
  FilmInfo info_;
  PlainLayout layout_;
  std::vector<char> buffer_;
};

}  // namespace

std::size_t bytes_of(Sample sample) {
  switch (sample) {
    case Sample::u8:
    case Sample::i8: return 1;
    case Sample::u16:
    case Sample::i16: return 2;
    case Sample::u32:
    case Sample::i32:
    case Sample::f32: return 4;
    case Sample::u64:
    case Sample::i64:
    case Sample::f64: return 8;
  }
  return 0;
}

void take_pixels(const PlainLayout& layout, const char* from, std::size_t count, std::uint16_t* level, float* value) {
  if (level != nullptr) return each_pixel(layout, from, count, [&](std::size_t i, auto v) { level[i] = static_cast<std::uint16_t>(v); });
  if (layout.scaled)
    return each_pixel(layout, from, count, [&](std::size_t i, auto v) {
      value[i] = static_cast<float>(layout.scale * static_cast<double>(v) + layout.shift);
    });
  each_pixel(layout, from, count, [&](std::size_t i, auto v) { value[i] = static_cast<float>(v); });
}

void take_numbers(const PlainLayout& layout, const char* from, std::size_t count, double* value) {
  each_pixel(layout, from, count, [&](std::size_t i, auto v) { value[i] = static_cast<double>(v); });
}

void take_numbers(const PlainLayout& layout, const char* from, std::size_t count, std::int64_t* value) {
  constexpr auto most = std::numeric_limits<std::int64_t>::max();
  each_pixel(layout, from, count, [&](std::size_t i, auto v) {
    if constexpr (std::is_same_v<decltype(v), std::uint64_t>) value[i] = static_cast<std::int64_t>(std::min<std::uint64_t>(v, most));
    else if constexpr (std::is_integral_v<decltype(v)>) value[i] = static_cast<std::int64_t>(v);
  });
}

void check_film_size(const std::string& file, std::int64_t width, std::int64_t height, std::int64_t frames, const FilmChoice& choice) {
  if (width <= 0 || height <= 0 || width > 1'000'000 || height > 1'000'000)
    throw InputError(file, 0, fmt::format("says that its frames have {} x {} pixels, which cannot be; copy it again", width, height));
  if (width * height > choice.most_pixels)
    throw InputError(file, 0, fmt::format("has frames of {} x {} pixels; at most {} pixels can be read, so cut them",
                                          width, height, choice.most_pixels));
  if (frames <= 0) throw InputError(file, 0, "holds no frame; record the film again");
}

std::int64_t frames_there(const ByteSource& bytes, const PlainLayout& layout, std::size_t pixels) {
  const std::uint64_t frame = pixels * bytes_of(layout.sample);
  if (layout.stride == 0 || bytes.size() < layout.offset || bytes.size() - layout.offset < frame) return 0;
  return static_cast<std::int64_t>((bytes.size() - layout.offset - frame) / layout.stride + 1);
}

void check_layout(const ByteSource& bytes, const FilmInfo& info, const PlainLayout& layout, const FilmChoice& choice) {
  check_film_size(bytes.name(), info.width, info.height, info.frames, choice);
  const std::int64_t there = frames_there(bytes, layout, info.pixels());
  if (there < info.frames)
    throw InputError(bytes.name(), 0, fmt::format("is cut short: it announces {} frames of {} x {} pixels and holds {}; copy it again",
                                                  info.frames, info.width, info.height, there));
}

void take_choice(FilmInfo& info, const FilmChoice& choice) {
  if (!choice.frame_rate) return;
  info.frame_rate = *choice.frame_rate;
  info.time.clear();
}

std::unique_ptr<FilmSource> plain_film(Bytes bytes, FilmInfo info, const PlainLayout& layout, const FilmChoice& choice) {
  check_layout(*bytes, info, layout, choice);
  take_choice(info, choice);
  info.floating = layout.scaled || !is_level(layout.sample);
  if (info.bits == 0 && !info.floating) info.bits = static_cast<int>(8 * bytes_of(layout.sample));
  return std::make_unique<PlainFilm>(std::move(bytes), std::move(info), layout);
}

void prepare(const FilmInfo& info, std::int64_t first, std::size_t count, FrameBlock& block) {
  if (first < 0 || first > info.frames || count > static_cast<std::uint64_t>(info.frames - first))
    throw std::out_of_range("frames that the film does not have");
  block.first = first;
  block.frames = count;
  block.level.resize(info.floating ? 0 : count * info.pixels());
  block.value.resize(info.floating ? count * info.pixels() : 0);
}

}  // namespace arenite::io
