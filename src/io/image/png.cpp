#include <png.h>

#include <algorithm>
#include <bit>
#include <csetjmp>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/problems.hpp"
#include "io/image/image.hpp"
#include "io/image/orientation.hpp"

namespace arenite::io {
namespace {

/// libpng's reader over bytes in memory. libpng leaves a failing call by longjmp, so the functions that call it hold
/// nothing that needs a destructor.
struct PngDecoder {
  std::string_view rest;
  char message[120] = {};
  png_structp png = nullptr;
  png_infop info = nullptr;

  explicit PngDecoder(std::string_view bytes) : rest(bytes) {
    png = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, fail, [](png_structp, png_const_charp) {});
    info = png != nullptr ? png_create_info_struct(png) : nullptr;
    if (info == nullptr) throw std::bad_alloc();
    png_set_read_fn(png, this, take);
  }
  ~PngDecoder() { png_destroy_read_struct(&png, &info, nullptr); }
  PngDecoder(const PngDecoder&) = delete;
  PngDecoder& operator=(const PngDecoder&) = delete;

  [[noreturn]] static void fail(png_structp png, png_const_charp text) {
    auto* self = static_cast<PngDecoder*>(png_get_error_ptr(png));
    const std::string_view all(text);
    all.substr(0, sizeof(self->message) - 1).copy(self->message, sizeof(self->message) - 1);
    png_longjmp(png, 1);
  }
  static void take(png_structp png, png_bytep to, png_size_t count) {
    auto* self = static_cast<PngDecoder*>(png_get_io_ptr(png));
    if (self->rest.size() < count) png_error(png, "it ends too early");
    self->rest.copy(reinterpret_cast<char*>(to), count);
    self->rest.remove_prefix(count);
  }
};

bool read_header(PngDecoder& d) {
  if (setjmp(png_jmpbuf(d.png)) != 0) return false;  // NOLINT: libpng's way
  png_set_user_limits(d.png, 0x7fffffff, 0x7fffffff);
  png_set_keep_unknown_chunks(d.png, PNG_HANDLE_CHUNK_NEVER, nullptr, 0);
  png_read_info(d.png, d.info);
  png_set_packing(d.png);
  if constexpr (std::endian::native == std::endian::little) png_set_swap(d.png);
  png_set_interlace_handling(d.png);
  png_read_update_info(d.png, d.info);
  return true;
}

bool read_rows(PngDecoder& d, png_bytepp rows) {
  if (setjmp(png_jmpbuf(d.png)) != 0) return false;  // NOLINT: libpng's way
  png_read_image(d.png, rows);
  png_read_end(d.png, nullptr);
  return true;
}

[[noreturn]] void refuse_damaged(const PngDecoder& d, const std::string& file) {
  refuse(file, "is a PNG picture that is cut short or damaged ({}); copy it again", std::string_view(d.message));
}

/// What a chunk tRNS says: entries of a palette, or the one grey or colour that is transparent.
void take_clear(const PngDecoder& d, PixelLayout& layout) {
  png_bytep opacity = nullptr;
  png_color_16p colour = nullptr;
  int count = 0;
  if (png_get_tRNS(d.png, d.info, &opacity, &count, &colour) == 0) return;
  if (!layout.palette.empty()) {
    for (int i = 0; opacity != nullptr && i < count; ++i)
      if (opacity[i] != 255) layout.clear.push_back({i, 0, 0});
  } else if (colour != nullptr) {
    if (layout.colour) layout.clear.push_back({colour->red, colour->green, colour->blue});
    else layout.clear.push_back({colour->gray, 0, 0});
  }
}

PixelLayout layout_of(const PngDecoder& d, const std::string& file, Channel channel) {
  PixelLayout layout;
  layout.channel = channel;
  const int type = png_get_color_type(d.png, d.info);
  layout.file = file;
  layout.width = static_cast<int>(png_get_image_width(d.png, d.info));
  layout.height = static_cast<int>(png_get_image_height(d.png, d.info));
  layout.bits = png_get_bit_depth(d.png, d.info) == 16 ? 16 : 8;
  layout.samples = png_get_channels(d.png, d.info);
  layout.colour = (type & PNG_COLOR_MASK_COLOR) != 0 && (type & PNG_COLOR_MASK_PALETTE) == 0;
  layout.opacity = (type & PNG_COLOR_MASK_ALPHA) != 0;
  png_colorp colours = nullptr;
  int count = 0;
  if ((type & PNG_COLOR_MASK_PALETTE) != 0 && png_get_PLTE(d.png, d.info, &colours, &count) != 0)
    for (int i = 0; i < count; ++i) layout.palette.push_back({colours[i].red, colours[i].green, colours[i].blue});
  take_clear(d, layout);
  return layout;
}

int orientation_of(const PngDecoder& d) {
  png_bytep exif = nullptr;
  png_uint_32 size = 0;
  if (png_get_eXIf_1(d.png, d.info, &size, &exif) == 0) return 1;
  return exif_orientation({reinterpret_cast<const char*>(exif), size});
}

Image decode_png(const std::string& bytes, const std::string& file, const ImageChoice& choice) {
  PngDecoder d(bytes);
  if (!read_header(d)) refuse_damaged(d, file);
  check_size(file, png_get_image_width(d.png, d.info), png_get_image_height(d.png, d.info), choice);
  chosen_slice(file, 1, choice);
  const PixelLayout layout = layout_of(d, file, choice.channel);
  const std::size_t stride = std::max<std::size_t>(png_get_rowbytes(d.png, d.info), layout.bytes_a_row());
  std::vector<std::uint8_t> samples(stride * static_cast<std::size_t>(layout.height));
  std::vector<png_bytep> rows;
  for (int y = 0; y < layout.height; ++y) rows.push_back(samples.data() + stride * static_cast<std::size_t>(y));
  if (!read_rows(d, rows.data())) refuse_damaged(d, file);
  return upright(image_of(layout, samples, stride), orientation_of(d));
}

}  // namespace

const PictureFormat pictures::png{
    .name = "png",
    .sentence = "PNG",
    .states = {{"orientation (EXIF)", "the picture is turned upright"},
               {"transparency (alpha, tRNS)", "accepted where every pixel is opaque, else refused"},
               {"size of a pixel (pHYs)",
                "told where dx is not given, or differs; passed over where it is a usual one of screens and printers; "
                "pixels that "
                "are no squares are then refused"}},

    .is = [](std::string_view b) { return b.starts_with("\x89PNG\r\n\x1a\n"); },
    .read = decode_png};

void write_png(const std::filesystem::path& path, const ColourPicture& picture) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(picture.width);
  header.height = static_cast<png_uint_32>(picture.height);
  header.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&header, bytes.data(), &size, 0, picture.rgb.data(), 0, nullptr) == 0)
    throw std::runtime_error(std::string("cannot make a PNG picture: ") + header.message);
  bytes.resize(size);
  write_atomically(path, bytes);
}

}  // namespace arenite::io
