#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_set>
#include <vector>

#include "io/film/formats.hpp"
#include "io/image/tiff.hpp"

namespace arenite::io {
namespace {

std::uint64_t number(std::string_view bytes, std::size_t at, std::size_t size, bool big_endian) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < size; ++i) value |= std::uint64_t{number_at<std::uint8_t>(bytes, at + i)} << 8 * (big_endian ? size - 1 - i : i);
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
  NumberType pixel = NumberType::u16;
  bool operator==(const Page&) const = default;
};

NumberType pixel_of(TIFF* tiff, const TiffSource& source) {
  const int bits = tiff_field<std::uint16_t>(tiff, TIFFTAG_BITSPERSAMPLE), format = tiff_field<std::uint16_t>(tiff, TIFFTAG_SAMPLEFORMAT);
  const bool whole = format == SAMPLEFORMAT_UINT || format == SAMPLEFORMAT_VOID;
  using enum NumberType;
  if (whole && (bits == 8 || bits == 16 || bits == 32)) return bits == 8 ? u8 : bits == 16 ? u16 : u32;
  if (format == SAMPLEFORMAT_INT && (bits == 16 || bits == 32)) return bits == 16 ? i16 : i32;
  if (format == SAMPLEFORMAT_IEEEFP && (bits == 32 || bits == 64)) return bits == 32 ? f32 : f64;
  source.refuse(fmt::format("has {} bits a pixel in a form that is no film's; save it with 8 or 16 bits or floating", bits));
}

Page page_of(TIFF* tiff, const TiffSource& source) {
  Page page{tiff_field<std::uint32_t>(tiff, TIFFTAG_IMAGEWIDTH), tiff_field<std::uint32_t>(tiff, TIFFTAG_IMAGELENGTH), pixel_of(tiff, source)};
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

class TiffFilm : public KnownFilm {
 public:
  TiffFilm(const Bytes& bytes, const FilmChoice& choice)
      : source_(bytes),
        tiff_(open_tiff(source_, std::max<std::int64_t>(std::int64_t{1} << 24, choice.most_pixels * 16))) {
    if (!tiff_) source_.refuse_damaged();
    places_ = page_places(source_);
    if (places_.empty()) source_.refuse("holds no frame; record the film again");
    turn_to(0);
    page_ = page_of(tiff_.get(), source_);
    layout_.pixel = page_.pixel;
    info_.format = "tiff";
    take_shape(info_, source_.file(), {static_cast<std::int64_t>(places_.size()), page_.height, page_.width}, page_.pixel, choice);
    const std::string notes = description_of(tiff_.get());
    take_notes(notes, info_);
    if (!choice.frame_rate && std::isfinite(noted_time(notes))) read_stamps();
    take_choice(info_, choice);
    FrameBlock last;  // what is cut short lacks it
    read(info_.frames - 1, 1, last);
  }

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

  /// Tile by tile; a strip is one as wide as the page, of which the last may be lower.
  void read_page(std::size_t at, FrameBlock& block) {
    TIFF* const tiff = tiff_.get();
    const bool tiled = TIFFIsTiled(tiff) != 0;
    const std::size_t width = page_.width, height = page_.height, size = bytes_of(page_.pixel);
    const std::size_t wide = tiled ? tiff_field<std::uint32_t>(tiff, TIFFTAG_TILEWIDTH) : width;
    const std::size_t high = tiled ? tiff_field<std::uint32_t>(tiff, TIFFTAG_TILELENGTH)
                                   : std::min<std::size_t>(std::max<std::uint32_t>(1, tiff_field<std::uint32_t>(tiff, TIFFTAG_ROWSPERSTRIP)), height);
    if (wide == 0 || high == 0 || wide > width + 65536 || high > height + 65536) source_.refuse_damaged();
    if (tiled && TIFFTileSize(tiff) != static_cast<tmsize_t>(wide * high * size)) source_.refuse_damaged();
    buffer_.resize(wide * high * size);
    for (std::size_t y = 0; y < height; y += high)
      for (std::size_t x = 0; x < width; x += wide) {
        const std::size_t rows = std::min(high, height - y);
        const auto wanted = static_cast<tmsize_t>((tiled ? high : rows) * wide * size);
        const tmsize_t got = tiled ? TIFFReadTile(tiff, buffer_.data(), static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), 0, 0)
                                   : TIFFReadEncodedStrip(tiff, static_cast<std::uint32_t>(y / high), buffer_.data(), wanted);
        if (got != wanted) source_.refuse_damaged();
        for (std::size_t r = 0; r < rows; ++r)
          take_pixels(layout_, buffer_.data() + r * wide * size, std::min(wide, width - x), block, at + (y + r) * width + x);
      }
  }

  TiffSource source_;
  Tiff tiff_;
  std::vector<std::uint64_t> places_;
  Page page_;
  PlainLayout layout_;
  std::vector<char> buffer_;
};

enum Type : std::uint16_t { ascii = 2, short_ = 3, long_ = 4, long8 = 16 };

struct Entry {
  std::uint16_t tag;
  Type type;
  std::uint64_t value = 0;
  std::string text = {};  ///< with its zero
};

/// A directory at this place of the file, whose texts lie right behind it. Entries come in the order of their tags.
std::string directory_bytes(const std::vector<Entry>& entries, bool large, std::uint64_t at, bool last) {
  const auto place = [large](std::string& out, std::uint64_t value) {
    large ? append<std::uint64_t>(out, value) : append<std::uint32_t>(out, static_cast<std::uint32_t>(value));
  };
  const std::uint64_t tail = at + (large ? 8 + 20 * entries.size() + 8 : 2 + 12 * entries.size() + 4);
  std::string out, texts;
  large ? append<std::uint64_t>(out, entries.size()) : append<std::uint16_t>(out, static_cast<std::uint16_t>(entries.size()));
  for (const Entry& entry : entries) {
    append<std::uint16_t>(out, entry.tag);
    append<std::uint16_t>(out, entry.type);
    place(out, entry.text.empty() ? 1 : entry.text.size());
    if (entry.text.empty()) {
      place(out, entry.value);
    } else if (const std::size_t inside = large ? 8 : 4; entry.text.size() <= inside) {
      out += entry.text + std::string(inside - entry.text.size(), '\0');
    } else {
      place(out, tail + texts.size());
      texts += entry.text;
    }
  }
  if ((tail + texts.size()) % 2 != 0) texts += '\0';  // directories begin at even places
  place(out, last ? 0 : tail + texts.size());
  return out + texts;
}

constexpr std::uint64_t start = 16;

/// All pixels one after the other, then the directories of all pages: whether they need 64 bits is known by then.
struct Places {
  std::uint64_t frame, directories;  ///< bytes of one frame; where directories begin
  bool large;
};
Places places_of(const FilmInfo& info, std::uint64_t frames) {
  const std::uint64_t frame = info.pixels() * (info.floating ? 4 : 2), pixels = frame * frames, at = start + pixels + pixels % 2;
  constexpr std::uint64_t most_a_page = 4096;
  const std::uint64_t announced = static_cast<std::uint64_t>(std::max<std::int64_t>(info.frames, 0));
  return {frame, at, at > 0xffffffffU || std::max(frames, announced) * (frame + most_a_page) > 0xffffffffU};
}

std::string tiff_header(const FilmInfo& info, std::size_t frames) {
  const Places places = places_of(info, frames);
  std::string out = "II";
  append<std::uint16_t>(out, places.large ? 43 : 42);
  append<std::uint32_t>(out, places.large ? 8 : static_cast<std::uint32_t>(places.directories));
  append<std::uint64_t>(out, places.large ? places.directories : 0);
  return out;
}

void write_directories(const FilmInfo& info, std::size_t frames, AtomicFile& file) {
  auto [size, at, large] = places_of(info, frames);
  if (size * frames % 2 != 0) file.write(std::string(1, '\0'));
  for (std::size_t i = 0; i < frames; ++i) {
    std::string notes = i == 0 ? film_notes(info) : "";
    if (i < info.time.size()) notes += fmt::format("time = {:.9f}\n", info.time[i]);
    const auto width = static_cast<std::uint64_t>(info.width), height = static_cast<std::uint64_t>(info.height);
    const Type of_place = large ? long8 : long_;
    std::vector<Entry> entries{{256, long_, width},
                               {257, long_, height},
                               {258, short_, info.floating ? 32U : 16U},
                               {259, short_, 1},   // not compressed
                               {262, short_, 1}};  // black is the smallest
    if (!notes.empty()) entries.push_back({270, ascii, 0, notes + '\0'});
    entries.insert(entries.end(), {{273, of_place, start + i * size},  // one strip
                                   {277, short_, 1},
                                   {278, long_, height},
                                   {279, of_place, size},
                                   {339, short_, info.floating ? 3U : 1U}});
    const std::string bytes = directory_bytes(entries, large, at, i + 1 == frames);
    file.write(bytes);
    at += bytes.size();
  }
}

}  // namespace

FilmPointer open_tiff_film(const Bytes& bytes, const FilmChoice& choice) { return std::make_unique<TiffFilm>(bytes, choice); }

FilmWriterPointer create_tiff_film(const std::filesystem::path& path, const FilmInfo& info) {
  return create_plain_film(path, info, {tiff_header, nullptr, write_directories});
}

}  // namespace arenite::io
