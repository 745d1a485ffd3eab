#pragma once
#include <bit>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>

#include "io/film.hpp"

namespace arenite::io {

/// How a pixel is stored.
enum class Sample : std::uint8_t { u8, i8, u16, i16, u32, i32, u64, i64, f32, f64 };
std::size_t bytes_of(Sample sample);
inline bool is_level(Sample sample) { return sample == Sample::u8 || sample == Sample::u16; }

/// Where the pixels of a film lie: frame i begins at offset + i stride.
struct PlainLayout {
  std::uint64_t offset = 0, stride = 0;  ///< bytes
  Sample sample = Sample::u16;
  bool big_endian = false;
  bool scaled = false;                   ///< a pixel is scale * number + shift, floating
  double scale = 1, shift = 0;
};

/// InputError unless a film of this size can be meant: pixels and frames there, not too many pixels in a frame.
void check_film_size(const std::string& file, std::int64_t width, std::int64_t height, std::int64_t frames,
                     const FilmChoice& choice);

/// How many whole frames a file of this layout holds.
std::int64_t frames_there(const ByteSource& bytes, const PlainLayout& layout, std::size_t pixels);

/// InputError unless the film's size can be meant and the file is long enough for its frames.
void check_layout(const ByteSource& bytes, const FilmInfo& info, const PlainLayout& layout, const FilmChoice& choice);

/// Takes the frame rate that was chosen, if one was.
void take_choice(FilmInfo& info, const FilmChoice& choice);

/// A film whose pixels lie as they are in a file, checked.
std::unique_ptr<FilmSource> plain_film(Bytes bytes, FilmInfo info, const PlainLayout& layout, const FilmChoice& choice);

/// Makes `count` pixels of their bytes into levels or values, whichever `block` is for.
void take_pixels(const PlainLayout& layout, const char* from, std::size_t count, std::uint16_t* level, float* value);

/// The same for any numbers in doubles.
void take_numbers(const PlainLayout& layout, const char* from, std::size_t count, double* value);
/// And for whole ones; those above the largest std::int64_t become that.
void take_numbers(const PlainLayout& layout, const char* from, std::size_t count, std::int64_t* value);

/// Throws std::out_of_range unless the film has these frames, and gives the block its size.
void prepare(const FilmInfo& info, std::int64_t first, std::size_t count, FrameBlock& block);

/// A number of this type at a place of some bytes, lowest byte first; 0 beyond their end.
template <class T>
T number_at(std::string_view bytes, std::size_t at) {
  static_assert(std::endian::native == std::endian::little);
  T value{};
  if (at <= bytes.size() && bytes.size() - at >= sizeof(T)) std::memcpy(&value, bytes.data() + at, sizeof(T));
  return value;
}

}  // namespace arenite::io
