#pragma once
#include <tiffio.h>
#include <zlib.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include <jpeglib.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/error.hpp"

/// Pictures of every kind, sound and broken, written byte by byte.
namespace arenite::test {

/// What an InputError says; empty if there was none.
inline std::string complaint(const std::function<void()>& act) {
  try {
    act();
  } catch (const InputError& error) { return error.what(); }
  return "";
}

inline std::string big_endian(std::uint32_t v) {
  return {static_cast<char>(v >> 24), static_cast<char>(v >> 16), static_cast<char>(v >> 8), static_cast<char>(v)};
}

inline std::string png_chunk(const std::string& type, const std::string& data) {
  const std::string body = type + data;
  const auto sum = crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
  return big_endian(static_cast<std::uint32_t>(data.size())) + body + big_endian(static_cast<std::uint32_t>(sum));
}

/// The bytes of EXIF that state an orientation.
inline std::string exif(char orientation, bool low_first) {
  using namespace std::string_literals;
  if (low_first) return "II*\0\x8\0\0\0\1\0\x12\1\3\0\1\0\0\0"s + orientation + "\0\0\0\0\0\0\0"s;
  return "MM\0*\0\0\0\x8\0\1\1\x12\0\3\0\0\0\1\0"s + orientation + "\0\0\0\0\0\0"s;
}

enum PngKind : char { grey = 0, colour = 2, palette = 3, grey_alpha = 4, colour_alpha = 6 };

/// A PNG file of rows of packed samples, each without its leading filter byte.
inline std::string png(std::uint32_t width, std::uint32_t height, char bits, PngKind kind,
                       const std::vector<std::string>& rows, const std::string& colours = "") {
  std::string raw;
  for (const std::string& row : rows) raw += '\0' + row;
  uLongf size = compressBound(static_cast<uLong>(raw.size()));
  std::string packed(size, '\0');
  compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(raw.data()),
           static_cast<uLong>(raw.size()));
  packed.resize(size);
  const std::string header =
      big_endian(width) + big_endian(height) + std::string{bits, static_cast<char>(kind), 0, 0, 0};
  return "\x89PNG\r\n\x1a\n" + png_chunk("IHDR", header) + (colours.empty() ? "" : png_chunk("PLTE", colours)) +
         png_chunk("IDAT", packed) + png_chunk("IEND", "");
}

inline std::string grey_png(std::uint32_t width, std::uint32_t height, const std::string& pixels) {
  std::vector<std::string> rows;
  for (std::size_t y = 0; y < height; ++y) rows.push_back(pixels.substr(y * width, width));
  return png(width, height, 8, grey, rows);
}

/// A JPEG file of best quality: 1 (grey), 3 (red, green, blue) or 4 (inks) samples a pixel.
inline std::string jpeg(unsigned width, unsigned height, int samples, const std::string& pixels,
                        bool progressive = false) {
  jpeg_compress_struct to{};
  jpeg_error_mgr errors{};
  to.err = jpeg_std_error(&errors);
  jpeg_create_compress(&to);
  unsigned char* memory = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&to, &memory, &size);
  to.image_width = width;
  to.image_height = height;
  to.input_components = samples;
  to.in_color_space = samples == 1 ? JCS_GRAYSCALE : samples == 3 ? JCS_RGB : JCS_CMYK;
  jpeg_set_defaults(&to);
  jpeg_set_quality(&to, 100, TRUE);
  for (int c = 0; c < to.num_components; ++c) to.comp_info[c].h_samp_factor = to.comp_info[c].v_samp_factor = 1;
  if (progressive) jpeg_simple_progression(&to);
  jpeg_start_compress(&to, TRUE);
  std::string copy = pixels;
  while (to.next_scanline < height) {
    auto* row = reinterpret_cast<JSAMPROW>(copy.data() +
                                           std::size_t{to.next_scanline} * width * static_cast<unsigned>(samples));
    jpeg_write_scanlines(&to, &row, 1);
  }
  jpeg_finish_compress(&to);
  const std::string bytes(reinterpret_cast<const char*>(memory), size);
  jpeg_destroy_compress(&to);
  std::free(memory);
  return bytes;
}

struct TiffPage {
  std::uint32_t width = 0, height = 0;
  std::uint16_t bits = 8, samples = 1, photometric = PHOTOMETRIC_MINISBLACK, format = SAMPLEFORMAT_UINT,
                compression = COMPRESSION_NONE;
  std::uint16_t orientation = ORIENTATION_TOPLEFT;
  std::uint32_t tile = 0;           ///< side of square tiles; 0: strips
  std::vector<std::uint8_t> bytes;  ///< of all rows, or of all tiles one after the other
};

/// Writes a TIFF file with one directory a page, samples in this machine's order.
inline void write_tiff(const std::filesystem::path& path, std::vector<TiffPage> pages) {
  TIFF* tiff = TIFFOpen(path.c_str(), "w");
  for (TiffPage& page : pages) {
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, page.width);
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, page.height);
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, page.bits);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, page.samples);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, page.photometric);
    TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, page.format);
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, page.compression);
    TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(tiff, TIFFTAG_ORIENTATION, page.orientation);
    if (page.photometric == PHOTOMETRIC_PALETTE) {
      std::vector<std::uint16_t> ramp;
      for (std::uint32_t i = 0; i < 1u << page.bits; ++i)
        ramp.push_back(static_cast<std::uint16_t>((i * 10 % 256) << 8));
      TIFFSetField(tiff, TIFFTAG_COLORMAP, ramp.data(), ramp.data(), ramp.data());
    }
    if (page.tile > 0) {
      TIFFSetField(tiff, TIFFTAG_TILEWIDTH, page.tile);
      TIFFSetField(tiff, TIFFTAG_TILELENGTH, page.tile);
      const auto size = static_cast<std::size_t>(TIFFTileSize(tiff));
      for (std::size_t t = 0; t < page.bytes.size() / size; ++t)
        TIFFWriteEncodedTile(tiff, static_cast<std::uint32_t>(t), page.bytes.data() + t * size,
                             static_cast<tmsize_t>(size));
    } else {
      TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, 2);
      const std::size_t row = page.bytes.size() / page.height;
      for (std::uint32_t y = 0; y < page.height; ++y) TIFFWriteScanline(tiff, page.bytes.data() + y * row, y, 0);
    }
    TIFFWriteDirectory(tiff);
  }
  TIFFClose(tiff);
}

}  // namespace arenite::test
