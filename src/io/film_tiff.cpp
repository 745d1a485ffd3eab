#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <unordered_set>
#include <vector>

#include "core/error.hpp"
#include "io/film_formats.hpp"
#include "io/film_notes.hpp"
#include "io/film_times.hpp"
#include "io/plain_film.hpp"
#include "io/tiff_handle.hpp"

namespace arenite::io {
namespace {

std::uint64_t number(std::string_view bytes, std::size_t at, std::size_t size, bool big_endian) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < size && at + i < bytes.size(); ++i) {
    const auto byte = static_cast<std::uint64_t>(static_cast<unsigned char>(bytes[at + i]));
    value |= byte << 8 * (big_endian ? size - 1 - i : i);
  }
  return value;
}

/// Where the directories of all pages begin: the chain is followed once, so that any page is reached at once after.
std::vector<std::uint64_t> page_places(const TiffSource& source) {
  const ByteSource& bytes = *source.bytes;
  const std::string head = bytes.text(0, 16);
  const bool swap = head[0] == 'M', large = number(head, 2, 2, swap) == 43;
  const std::size_t count_size = large ? 8 : 2, entry = large ? 20 : 12, link = large ? 8 : 4;
  std::vector<std::uint64_t> places;
  std::unordered_set<std::uint64_t> seen;
  for (std::uint64_t at = number(head, large ? 8 : 4, link, swap); at != 0;) {
    if (!seen.insert(at).second) source.refuse(fmt::format("is a TIFF film whose pages run in a circle after page {}; write it again", places.size()));
    const std::uint64_t entries = number(bytes.text(at, count_size), 0, count_size, swap);
    const std::uint64_t end = at + count_size + entries * entry;
    if (entries > 4096 || end + link > bytes.size() || end < at) source.refuse_damaged();
    places.push_back(at);
    at = number(bytes.text(end, link), 0, link, swap);
  }
  return places;
}

struct Page {
  std::uint32_t width = 0, height = 0;
  Sample sample = Sample::u16;
  bool operator==(const Page&) const = default;
};

Sample sample_of(TIFF* tiff, const TiffSource& source) {
  const int bits = tiff_field<std::uint16_t>(tiff, TIFFTAG_BITSPERSAMPLE), format = tiff_field<std::uint16_t>(tiff, TIFFTAG_SAMPLEFORMAT);
  const bool whole = format == SAMPLEFORMAT_UINT || format == SAMPLEFORMAT_VOID;
  if (whole && bits == 8) return Sample::u8;
  if (whole && bits == 16) return Sample::u16;
  if (whole && bits == 32) return Sample::u32;
  if (format == SAMPLEFORMAT_INT && bits == 16) return Sample::i16;
  if (format == SAMPLEFORMAT_INT && bits == 32) return Sample::i32;
  if (format == SAMPLEFORMAT_IEEEFP && bits == 32) return Sample::f32;
  if (format == SAMPLEFORMAT_IEEEFP && bits == 64) return Sample::f64;
  source.refuse(fmt::format("has {} bits a pixel in a form that is no film's; save it with 8 or 16 bits or floating", bits));
}

Page page_of(TIFF* tiff, const TiffSource& source) {
  Page page{tiff_field<std::uint32_t>(tiff, TIFFTAG_IMAGEWIDTH), tiff_field<std::uint32_t>(tiff, TIFFTAG_IMAGELENGTH), sample_of(tiff, source)};
  if (tiff_field<std::uint16_t>(tiff, TIFFTAG_SAMPLESPERPIXEL) != 1 || tiff_field<std::uint16_t>(tiff, TIFFTAG_PHOTOMETRIC) != PHOTOMETRIC_MINISBLACK)
    source.refuse("is not a grey film; save it with one number a pixel, black for the smallest");
  if (tiff_field<std::uint16_t>(tiff, TIFFTAG_ORIENTATION) != ORIENTATION_TOPLEFT)
    source.refuse("is stored turned or mirrored; save it upright (orientation 1)");
  return page;
}

std::string description_of(TIFF* tiff) {
  const char* text = nullptr;
  return TIFFGetField(tiff, TIFFTAG_IMAGEDESCRIPTION, &text) == 1 && text != nullptr ? text : "";
}

class TiffFilm : public FilmSource {
 public:
  TiffFilm(const Bytes& bytes, const FilmChoice& choice)
      : source_(bytes), tiff_(open_tiff(source_, std::max<std::int64_t>(std::int64_t{1} << 24, choice.most_pixels * 16))) {
    if (!tiff_) source_.refuse_damaged();
    places_ = page_places(source_);
    if (places_.empty()) source_.refuse("holds no frame; record the film again");
    turn_to(0);
    page_ = page_of(tiff_.get(), source_);
    check_film_size(source_.file(), page_.width, page_.height, static_cast<std::int64_t>(places_.size()), choice);
    layout_.sample = page_.sample;
    info_.format = "tiff";
    info_.width = static_cast<int>(page_.width);
    info_.height = static_cast<int>(page_.height);
    info_.frames = static_cast<std::int64_t>(places_.size());
    info_.floating = !is_level(page_.sample);
    if (!info_.floating) info_.bits = static_cast<int>(8 * bytes_of(page_.sample));
    const std::string notes = description_of(tiff_.get());
    take_notes(notes, info_);
    if (!choice.frame_rate && std::isfinite(noted_time(notes))) read_stamps();
    take_choice(info_, choice);
    FrameBlock last;  // what is cut short lacks it
    read(info_.frames - 1, 1, last);
  }

  const FilmInfo& info() const override { return info_; }

  void read(std::int64_t first, std::size_t count, FrameBlock& block) override {
    prepare(info_, first, count, block);
    for (std::size_t i = 0; i < count; ++i) {
      turn_to(first + static_cast<std::int64_t>(i));
      read_page(i * info_.pixels(), block);
    }
  }

 private:
  void turn_to(std::int64_t page) {
    if (TIFFSetSubDirectory(tiff_.get(), places_[static_cast<std::size_t>(page)]) != 1) source_.refuse_damaged();
    if (page > 0 && page_of(tiff_.get(), source_) != page_)
      source_.refuse(fmt::format("has pages of different size or type (pages 0 and {}); save a film of equal frames", page));
  }

  void read_stamps() {
    std::vector<double> stamp;
    for (std::int64_t i = 0; i < info_.frames; ++i) {
      turn_to(i);
      stamp.push_back(noted_time(description_of(tiff_.get())));
    }
    take_stamps(info_, std::move(stamp));
  }

  void take(const char* from, std::size_t at, std::size_t count, FrameBlock& block) const {
    take_pixels(layout_, from, count, info_.floating ? nullptr : block.level.data() + at, info_.floating ? block.value.data() + at : nullptr);
  }

  void read_page(std::size_t at, FrameBlock& block) {
    const std::size_t width = page_.width, row = width * bytes_of(page_.sample);
    if (TIFFIsTiled(tiff_.get()) != 0) return read_tiles(at, block);
    const std::size_t rows = std::min<std::size_t>(std::max<std::uint32_t>(1, tiff_field<std::uint32_t>(tiff_.get(), TIFFTAG_ROWSPERSTRIP)), page_.height);
    buffer_.assign(rows * row, 0);
    for (std::size_t y = 0, strip = 0; y < page_.height; y += rows, ++strip) {
      const std::size_t n = std::min(rows, page_.height - y);
      const auto wanted = static_cast<tmsize_t>(n * row);
      if (TIFFReadEncodedStrip(tiff_.get(), static_cast<std::uint32_t>(strip), buffer_.data(), wanted) != wanted) source_.refuse_damaged();
      take(buffer_.data(), at + y * width, n * width, block);
    }
  }

  void read_tiles(std::size_t at, FrameBlock& block) {
    const std::size_t wide = tiff_field<std::uint32_t>(tiff_.get(), TIFFTAG_TILEWIDTH), high = tiff_field<std::uint32_t>(tiff_.get(), TIFFTAG_TILELENGTH);
    const std::size_t size = bytes_of(page_.sample);
    const tmsize_t tile = TIFFTileSize(tiff_.get());
    if (wide == 0 || high == 0 || wide > std::size_t{page_.width} + 65536 || high > std::size_t{page_.height} + 65536 ||
        tile != static_cast<tmsize_t>(wide * high * size))
      source_.refuse_damaged();
    buffer_.resize(static_cast<std::size_t>(tile));
    for (std::size_t y = 0; y < page_.height; y += high)
      for (std::size_t x = 0; x < page_.width; x += wide) {
        if (TIFFReadTile(tiff_.get(), buffer_.data(), static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), 0, 0) != tile) source_.refuse_damaged();
        for (std::size_t r = 0; r < std::min(high, page_.height - y); ++r)
          take(buffer_.data() + r * wide * size, at + (y + r) * page_.width + x, std::min(wide, page_.width - x), block);
      }
  }

  TiffSource source_;
  Tiff tiff_;
  std::vector<std::uint64_t> places_;
  Page page_;
  PlainLayout layout_;
  FilmInfo info_;
  std::vector<char> buffer_;
};

}  // namespace

FilmPointer open_tiff_film(const Bytes& bytes, const FilmChoice& choice) { return std::make_unique<TiffFilm>(bytes, choice); }

}  // namespace arenite::io
