#include "io/image/tiff.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/problems.hpp"
#include "io/image/image.hpp"
#include "io/image/orientation.hpp"
#include "io/image/tiff_stack.hpp"

namespace arenite::io {
namespace {

void take_palette(TIFF* tiff, int bits, PixelLayout& layout) {
  std::uint16_t *red = nullptr, *green = nullptr, *blue = nullptr;
  if (bits > 8 || TIFFGetField(tiff, TIFFTAG_COLORMAP, &red, &green, &blue) != 1)
    refuse(layout.file, "has no palette for its indices; save it as greyscale with one value per phase");
  const auto to_byte = [](std::uint16_t v) { return static_cast<std::uint16_t>(v >> 8); };
  for (int i = 0; i < 1 << bits; ++i) layout.palette.push_back({to_byte(red[i]), to_byte(green[i]), to_byte(blue[i])});
}

PixelLayout layout_of(TIFF* tiff, const TiffSource& source, Channel channel) {
  const int bits = tiff_field<std::uint16_t>(tiff, TIFFTAG_BITSPERSAMPLE);
  PixelLayout layout;
  layout.channel = channel;
  layout.file = source.file();
  layout.width = static_cast<int>(tiff_field<std::uint32_t>(tiff, TIFFTAG_IMAGEWIDTH));
  layout.height = static_cast<int>(tiff_field<std::uint32_t>(tiff, TIFFTAG_IMAGELENGTH));
  layout.bits = bits;
  layout.samples = tiff_field<std::uint16_t>(tiff, TIFFTAG_SAMPLESPERPIXEL);
  const auto format = tiff_field<std::uint16_t>(tiff, TIFFTAG_SAMPLEFORMAT);
  layout.is_signed = format == SAMPLEFORMAT_INT;
  layout.is_floating = format == SAMPLEFORMAT_IEEEFP && (bits == 32 || bits == 64);
  if (!layout.is_floating && format != SAMPLEFORMAT_UINT && format != SAMPLEFORMAT_INT && format != SAMPLEFORMAT_VOID)
    source.refuse("holds numbers of an unsupported form; save it with whole numbers, one value per phase");
  if (!layout.is_floating && bits != 1 && bits != 2 && bits != 4 && bits != 8 && bits != 16 && bits != 32)
    source.refuse(fmt::format("has {} bits per sample; save it as greyscale with 8 or 16", bits));
  const auto meaning = tiff_field<std::uint16_t>(tiff, TIFFTAG_PHOTOMETRIC);
  layout.colour = meaning == PHOTOMETRIC_RGB;
  layout.inverted = meaning == PHOTOMETRIC_MINISWHITE;
  if (meaning > PHOTOMETRIC_PALETTE) source.refuse("is in colour; save it as greyscale with one value per phase");
  if (meaning == PHOTOMETRIC_PALETTE) take_palette(tiff, bits, layout);
  const int needed = layout.colour ? 3 : 1;
  layout.opacity = layout.samples == needed + 1;
  if (layout.samples < needed || layout.samples > needed + 1 ||
      (layout.samples > 1 && (bits < 8 || layout.is_signed || layout.is_floating)))
    source.refuse(
        fmt::format("has {} samples per pixel; save it as greyscale with one value per phase", layout.samples));
  if (layout.samples > 1 && tiff_field<std::uint16_t>(tiff, TIFFTAG_PLANARCONFIG) != PLANARCONFIG_CONTIG)
    source.refuse("stores its colours in separate planes; save it as greyscale with one value per phase");
  return layout;
}

Image read_page(TIFF* tiff, const TiffSource& source, const ImageChoice& choice) {
  check_size(source.file(), tiff_field<std::uint32_t>(tiff, TIFFTAG_IMAGEWIDTH),
             tiff_field<std::uint32_t>(tiff, TIFFTAG_IMAGELENGTH), choice);
  const PixelLayout layout = layout_of(tiff, source, choice.channel);
  Image image = empty_image(layout);
  each_block(tiff, source, [&](const TiffBlock& block) {
    for (std::size_t r = 0; r < block.rows; ++r)
      (layout.is_floating ? take_floating_row : take_row)(layout, block.row(r), block.x, block.y + r, block.columns,
                                                          image);
  });
  return upright(std::move(image), tiff_field<std::uint16_t>(tiff, TIFFTAG_ORIENTATION));
}

/// Images without a directory of their own cannot be chosen.
void refuse_images_behind(TIFF* tiff, const TiffSource& source) {
  const char* text = nullptr;
  if (TIFFNumberOfDirectories(tiff) != 1 || TIFFGetField(tiff, TIFFTAG_IMAGEDESCRIPTION, &text) != 1 || text == nullptr)
    return;
  const TiffStack stack = stack_in(text, tiff_field<std::uint32_t>(tiff, TIFFTAG_IMAGEWIDTH),
                                   tiff_field<std::uint32_t>(tiff, TIFFTAG_IMAGELENGTH));
  if (stack.images() > 1)
    source.refuse(fmt::format("holds one picture, but {} describes {} images; save the one that is meant by itself",
                              stack.by, stack.images()));
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
  if (!source.complaint.empty()) return 1;
  source.complaint = text;
  const std::string_view no_line = " at scanline 4294967295";  // what libtiff says of a strip of which no line was read
  if (const std::size_t at = source.complaint.find(no_line); at != std::string::npos)
    source.complaint.erase(at, no_line.size());
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

Image decode_tiff(const std::string& bytes, const std::string& file, const ImageChoice& choice) {
  TiffSource source(bytes_kept(bytes, file));
  const Tiff tiff = open_tiff(source);
  if (!tiff) source.refuse_damaged();
  refuse_images_behind(tiff.get(), source);
  const auto slice = chosen_slice(file, std::int64_t{TIFFNumberOfDirectories(tiff.get())}, choice);
  if (TIFFSetDirectory(tiff.get(), static_cast<tdir_t>(slice)) != 1) source.refuse_damaged();
  return read_page(tiff.get(), source, choice);
}

/// Every sample of less than a byte as a byte of its own, row after row.
std::vector<std::uint8_t> unpacked(const TiffBlock& block, unsigned bits) {
  const unsigned most = (1u << bits) - 1;
  std::vector<std::uint8_t> bytes;
  bytes.reserve(block.rows * block.columns);
  for (std::size_t r = 0; r < block.rows; ++r)
    for (std::size_t x = 0; x < block.columns; ++x) {
      const unsigned first = static_cast<unsigned>(x * bits % 8);
      bytes.push_back(
          static_cast<std::uint8_t>(static_cast<unsigned>(block.row(r)[x * bits / 8]) >> (8 - bits - first) & most));
    }
  return bytes;
}

}  // namespace

const PictureFormat pictures::tiff{.name = "tiff",
                                   .sentence = "TIFF",
                                   .states = {{"orientation", "the picture is turned upright"},
                                              {"floating numbers", "taken where all are whole"},
                                              {"more images than directories (ImageJ)", "refused"},
                                              {"size of a pixel (resolution, unit of ImageJ)",
                                               "told where dx is not given, or differs; passed over where it is a "
                                               "usual one of screens and printers; pixels that "
                                               "are no squares are then refused"}},

                                   .is = is_tiff,
                                   .read = decode_tiff};

void TiffSource::refuse(const std::string& message) const { throw InputError(file(), 0, message); }

void TiffSource::refuse_damaged() const {
  refuse("is a TIFF picture that is cut short or damaged" + (complaint.empty() ? "" : " (" + complaint + ")") +
         "; copy it again");
}

Tiff open_tiff(TiffSource& source, std::int64_t most_at_once) {
  const TiffOptions options = options_with(complain, &source);
  TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), most_at_once);
  // "m": no mapping into memory, for the bytes come through us.
  return {
      TIFFClientOpenExt(
          "picture", "rm", &source, read_bytes, [](thandle_t, void*, tmsize_t) -> tmsize_t { return 0; }, seek,
          [](thandle_t) { return 0; }, [](thandle_t h) -> toff_t { return static_cast<TiffSource*>(h)->bytes->size(); },
          nullptr, nullptr, options.get()),
      TIFFClose};
}

void each_block(TIFF* tiff, const TiffSource& source, const std::function<void(const TiffBlock& block)>& see) {
  const bool tiled = TIFFIsTiled(tiff) != 0;
  const std::size_t width = tiff_field<std::uint32_t>(tiff, TIFFTAG_IMAGEWIDTH),
                    height = tiff_field<std::uint32_t>(tiff, TIFFTAG_IMAGELENGTH);
  const std::size_t wide = tiled ? tiff_field<std::uint32_t>(tiff, TIFFTAG_TILEWIDTH) : width;
  const std::size_t high =
      tiled ? tiff_field<std::uint32_t>(tiff, TIFFTAG_TILELENGTH)
            : std::min<std::size_t>(std::max<std::uint32_t>(1, tiff_field<std::uint32_t>(tiff, TIFFTAG_ROWSPERSTRIP)),
                                    height);
  const std::size_t bits = std::size_t{tiff_field<std::uint16_t>(tiff, TIFFTAG_BITSPERSAMPLE)} *
                           tiff_field<std::uint16_t>(tiff, TIFFTAG_SAMPLESPERPIXEL);
  const tmsize_t stride = tiled ? TIFFTileRowSize(tiff) : TIFFScanlineSize(tiff);
  // A tile may be larger than the page, but not by much: else a few bytes ask for any memory.
  const bool fits = wide > 0 && high > 0 && wide <= width + 4096 && high <= height + 4096;
  if (!fits || static_cast<std::size_t>(std::max<tmsize_t>(stride, 0)) < (wide * bits + 7) / 8) source.refuse_damaged();
  std::vector<std::uint8_t> samples(static_cast<std::size_t>(stride) * high);
  for (std::size_t y = 0; y < height; y += high)
    for (std::size_t x = 0; x < width; x += wide) {
      const std::size_t rows = std::min(high, height - y);
      const auto wanted = static_cast<tmsize_t>(tiled ? high : rows) * stride;
      const tmsize_t got =
          tiled ? TIFFReadTile(tiff, samples.data(), static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), 0, 0)
                : TIFFReadEncodedStrip(tiff, static_cast<std::uint32_t>(y / high), samples.data(), wanted);
      if (got != wanted) source.refuse_damaged();
      const TiffBlock block{x, y, std::min(wide, width - x), rows, static_cast<std::size_t>(stride), samples.data()};
      if (bits >= 8) {
        see(block);
        continue;
      }
      const auto bytes = unpacked(block, static_cast<unsigned>(bits));
      see({x, y, block.columns, rows, block.columns, bytes.data()});
    }
}

Tiff create_tiff(const std::filesystem::path& path, bool large) {
  return {TIFFOpenExt(path.c_str(), large ? "wl8" : "wl", options_with(say_nothing, nullptr).get()), TIFFClose};
}

}  // namespace arenite::io
