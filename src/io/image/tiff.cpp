#include "io/image/tiff.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <vector>

#include "core/problems.hpp"
#include "io/image/image.hpp"

namespace arenite::io {
namespace {

void take_palette(TIFF* tiff, int bits, PixelLayout& layout) {
  std::uint16_t *red = nullptr, *green = nullptr, *blue = nullptr;
  if (bits > 8 || TIFFGetField(tiff, TIFFTAG_COLORMAP, &red, &green, &blue) != 1)
    refuse(layout.file, "has no palette for its indices; save it as greyscale with one value a phase");
  const auto to_byte = [](std::uint16_t v) { return static_cast<std::uint16_t>(v >> 8); };
  for (int i = 0; i < 1 << bits; ++i) layout.palette.push_back({to_byte(red[i]), to_byte(green[i]), to_byte(blue[i])});
}

PixelLayout layout_of(TIFF* tiff, const TiffSource& source, int bits, Channel channel) {
  PixelLayout layout;
  layout.channel = channel;
  layout.file = source.file();
  layout.width = static_cast<int>(tiff_field<std::uint32_t>(tiff, TIFFTAG_IMAGEWIDTH));
  layout.height = static_cast<int>(tiff_field<std::uint32_t>(tiff, TIFFTAG_IMAGELENGTH));
  layout.bits = std::max(bits, 8);
  layout.samples = tiff_field<std::uint16_t>(tiff, TIFFTAG_SAMPLESPERPIXEL);
  const auto format = tiff_field<std::uint16_t>(tiff, TIFFTAG_SAMPLEFORMAT);
  layout.is_signed = format == SAMPLEFORMAT_INT;
  if (format != SAMPLEFORMAT_UINT && format != SAMPLEFORMAT_INT && format != SAMPLEFORMAT_VOID)
    source.refuse("holds numbers with fractions; save it with whole numbers, one value a phase");
  if (bits != 1 && bits != 2 && bits != 4 && bits != 8 && bits != 16 && bits != 32)
    source.refuse(fmt::format("has {} bits a sample; save it as greyscale with 8 or 16", bits));
  const auto meaning = tiff_field<std::uint16_t>(tiff, TIFFTAG_PHOTOMETRIC);
  layout.colour = meaning == PHOTOMETRIC_RGB;
  layout.inverted = meaning == PHOTOMETRIC_MINISWHITE;
  if (meaning > PHOTOMETRIC_PALETTE) source.refuse("is in colour; save it as greyscale with one value a phase");
  if (meaning == PHOTOMETRIC_PALETTE) take_palette(tiff, bits, layout);
  const int needed = layout.colour ? 3 : 1;
  layout.opacity = layout.samples == needed + 1;
  if (layout.samples < needed || layout.samples > needed + 1 || (layout.samples > 1 && (bits < 8 || layout.is_signed)))
    source.refuse(fmt::format("has {} samples a pixel; save it as greyscale with one value a phase", layout.samples));
  if (layout.samples > 1 && tiff_field<std::uint16_t>(tiff, TIFFTAG_PLANARCONFIG) != PLANARCONFIG_CONTIG)
    source.refuse("holds its colours one after the other; save it as greyscale with one value a phase");
  if (tiff_field<std::uint16_t>(tiff, TIFFTAG_ORIENTATION) != ORIENTATION_TOPLEFT)
    source.refuse("is stored turned or mirrored; save it upright (orientation 1)");
  return layout;
}

/// Gives every sample of less than a byte a byte of its own.
void unpack(const std::uint8_t* packed, int bits, PixelLayout& layout, std::vector<std::uint8_t>& row) {
  const unsigned most = (1u << bits) - 1;
  for (int x = 0; x < layout.width; ++x) {
    const unsigned bit = static_cast<unsigned>(x) * static_cast<unsigned>(bits);
    unsigned value = static_cast<unsigned>(packed[bit / 8]) >> (8 - static_cast<unsigned>(bits) - bit % 8) & most;
    if (layout.inverted) value = most - value;
    row[static_cast<std::size_t>(x)] = static_cast<std::uint8_t>(value);
  }
}

/// Rows [first, first + count) of a picture in strips or tiles, `stride` bytes each.
struct Band {
  int first = 0, count = 0;
  std::size_t stride = 0;
  std::vector<std::uint8_t> bytes;
};

void read_tiles(TIFF* tiff, const TiffSource& source, int width, int y, Band& band) {
  const auto tile_width = tiff_field<std::uint32_t>(tiff, TIFFTAG_TILEWIDTH);
  const auto across = static_cast<std::size_t>(TIFFTileRowSize(tiff));
  std::vector<std::uint8_t> tile(static_cast<std::size_t>(TIFFTileSize(tiff)));
  for (std::uint32_t x = 0, column = 0; x < static_cast<std::uint32_t>(width); x += tile_width, ++column) {
    if (TIFFReadTile(tiff, tile.data(), x, static_cast<std::uint32_t>(y), 0, 0) < 0) source.refuse_damaged();
    for (int r = 0; r < band.count; ++r)
      std::memcpy(band.bytes.data() + static_cast<std::size_t>(r) * band.stride + column * across, tile.data() + static_cast<std::size_t>(r) * across, across);
  }
}

Band make_band(TIFF* tiff, const TiffSource& source, const PixelLayout& layout, int bits, const ImageChoice& choice) {
  Band band;
  const std::size_t needed = (layout.bytes_a_row() * static_cast<std::size_t>(bits) / static_cast<std::size_t>(layout.bits)) + 1;
  if (TIFFIsTiled(tiff) == 0) {
    band.count = 1;
    band.stride = std::max(needed, static_cast<std::size_t>(TIFFScanlineSize(tiff)));
  } else {
    const auto wide = tiff_field<std::uint32_t>(tiff, TIFFTAG_TILEWIDTH), high = tiff_field<std::uint32_t>(tiff, TIFFTAG_TILELENGTH);
    if (wide == 0 || high == 0 || TIFFTileSize(tiff) <= 0) source.refuse_damaged();
    check_size(source.file(), std::int64_t{wide} + layout.width, high, choice);
    if (TIFFTileRowSize(tiff) * 8 < tmsize_t{wide} * layout.samples * bits || wide * static_cast<unsigned>(bits) % 8 != 0) source.refuse_damaged();
    band.count = static_cast<int>(high);
    const auto tiles = (static_cast<std::uint32_t>(layout.width) + wide - 1) / wide;
    band.stride = std::max(needed, tiles * static_cast<std::size_t>(TIFFTileRowSize(tiff)));
  }
  band.bytes.resize(band.stride * static_cast<std::size_t>(band.count));
  return band;
}

Image read_page(TIFF* tiff, const TiffSource& source, const ImageChoice& choice) {
  check_size(source.file(), tiff_field<std::uint32_t>(tiff, TIFFTAG_IMAGEWIDTH), tiff_field<std::uint32_t>(tiff, TIFFTAG_IMAGELENGTH), choice);
  const int bits = tiff_field<std::uint16_t>(tiff, TIFFTAG_BITSPERSAMPLE);
  PixelLayout layout = layout_of(tiff, source, bits, choice.channel);
  Band band = make_band(tiff, source, layout, bits, choice);
  Image image = empty_image(layout);
  std::vector<std::uint8_t> row(static_cast<std::size_t>(layout.width));
  PixelLayout unpacked = layout;
  unpacked.inverted = false;
  for (int y = 0; y < layout.height; ++y) {
    if (TIFFIsTiled(tiff) != 0) {
      if (y % band.count == 0) read_tiles(tiff, source, layout.width, y, band);
    } else if (TIFFReadScanline(tiff, band.bytes.data(), static_cast<std::uint32_t>(y)) < 0) {
      source.refuse_damaged();
    }
    const std::uint8_t* samples = band.bytes.data() + static_cast<std::size_t>(y % band.count) * band.stride;
    if (bits >= 8) {
      take_row(layout, samples, y, image);
    } else {
      unpack(samples, bits, layout, row);
      take_row(unpacked, row.data(), y, image);
    }
  }
  return image;
}

tmsize_t read_bytes(thandle_t handle, void* to, tmsize_t count) {
  auto& source = *static_cast<TiffSource*>(handle);
  const std::size_t there = source.bytes->read(source.at, static_cast<std::size_t>(count), to);
  source.at += there;
  return static_cast<tmsize_t>(there);
}

toff_t seek(thandle_t handle, toff_t offset, int whence) {
  auto& source = *static_cast<TiffSource*>(handle);
  source.at = offset + (whence == SEEK_CUR ? source.at : whence == SEEK_END ? source.bytes->size() : 0);
  return source.at;
}

int complain(TIFF*, void* user, const char*, const char* format, va_list arguments) {
  auto& source = *static_cast<TiffSource*>(user);
  char text[200] = {};
  std::vsnprintf(text, sizeof(text), format, arguments);
  if (source.complaint.empty()) source.complaint = text;
  return 1;
}

using TiffOptions = std::unique_ptr<TIFFOpenOptions, void (*)(TIFFOpenOptions*)>;

int say_nothing(TIFF*, void*, const char*, const char*, va_list) { return 1; }

TiffOptions options_with(TIFFErrorHandlerExtR on_error, TiffSource* to) {
  TiffOptions options(TIFFOpenOptionsAlloc(), TIFFOpenOptionsFree);
  TIFFOpenOptionsSetErrorHandlerExtR(options.get(), on_error, to);
  TIFFOpenOptionsSetWarningHandlerExtR(options.get(), say_nothing, nullptr);
  return options;
}

}  // namespace

Image read_tiff(const std::string& bytes, const std::string& file, const ImageChoice& choice) {
  TiffSource source(bytes_kept(bytes, file));
  const Tiff tiff = open_tiff(source);
  if (!tiff) source.refuse_damaged();
  const auto slice = chosen_slice(file, std::int64_t{TIFFNumberOfDirectories(tiff.get())}, choice);
  if (TIFFSetDirectory(tiff.get(), static_cast<tdir_t>(slice)) != 1) source.refuse_damaged();
  return read_page(tiff.get(), source, choice);
}

void TiffSource::refuse(const std::string& message) const { throw InputError(file(), 0, message); }

void TiffSource::refuse_damaged() const {
  refuse("is a TIFF picture that is cut short or damaged" + (complaint.empty() ? "" : " (" + complaint + ")") + "; copy it again");
}

Tiff open_tiff(TiffSource& source, std::int64_t most_at_once) {
  const TiffOptions options = options_with(complain, &source);
  TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), most_at_once);
  // "m": no mapping into memory, for the bytes come through us.
  return {TIFFClientOpenExt(
              "picture", "rm", &source, read_bytes, [](thandle_t, void*, tmsize_t) -> tmsize_t { return 0; }, seek, [](thandle_t) { return 0; },
              [](thandle_t h) -> toff_t { return static_cast<TiffSource*>(h)->bytes->size(); }, nullptr, nullptr, options.get()),
          TIFFClose};
}

Tiff create_tiff(const std::filesystem::path& path, bool large) {
  return {TIFFOpenExt(path.c_str(), large ? "wl8" : "wl", options_with(say_nothing, nullptr).get()), TIFFClose};
}

}  // namespace arenite::io
