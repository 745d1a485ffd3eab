#include "core/problems.hpp"
#include "io/image/image.hpp"

// jpeglib.h needs these two before it.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>

#include <jerror.h>
#include <jpeglib.h>

#include <csetjmp>
#include <string_view>
#include <vector>

#include "io/image/orientation.hpp"

namespace arenite::io {
namespace {

constexpr int most_scans = 500;  // a progressive picture may repeat itself without end; real ones have about ten

/// libjpeg's reader over bytes in memory. libjpeg leaves a failing call by longjmp, so the functions that call it hold
/// nothing that needs a destructor.
struct JpegDecoder {
  jpeg_decompress_struct jpeg{};
  jpeg_error_mgr errors{};
  jpeg_progress_mgr progress{};
  std::jmp_buf leave{};
  char message[JMSG_LENGTH_MAX] = {};

  explicit JpegDecoder(const std::string& bytes) {
    jpeg.err = jpeg_std_error(&errors);
    errors.error_exit = [](j_common_ptr any) { fail(any); };
    errors.emit_message = warn;
    jpeg.client_data = this;
    if (setjmp(leave) != 0) throw std::bad_alloc();  // NOLINT: libjpeg's way
    jpeg_create_decompress(&jpeg);
    jpeg_mem_src(&jpeg, reinterpret_cast<const unsigned char*>(bytes.data()), static_cast<unsigned long>(bytes.size()));
    progress.progress_monitor = [](j_common_ptr any) {
      if (reinterpret_cast<j_decompress_ptr>(any)->input_scan_number > most_scans) fail(any);
    };
    jpeg.progress = &progress;
  }
  ~JpegDecoder() { jpeg_destroy_decompress(&jpeg); }
  JpegDecoder(const JpegDecoder&) = delete;
  JpegDecoder& operator=(const JpegDecoder&) = delete;

  [[noreturn]] static void fail(j_common_ptr any) {
    auto* self = static_cast<JpegDecoder*>(any->client_data);
    self->errors.format_message(any, self->message);
    std::longjmp(self->leave, 1);  // NOLINT: libjpeg's way
  }
  /// The library fills in damaged data by guessing and warns; only bytes that it may skip without loss are let pass.
  static void warn(j_common_ptr any, int level) {
    if (level < 0 && any->err->msg_code != JWRN_EXTRANEOUS_DATA) fail(any);
  }
};

constexpr int exif_marker = JPEG_APP0 + 1;

int orientation_of(const JpegDecoder& d) {
  using namespace std::string_view_literals;
  constexpr auto beginning = "Exif\0\0"sv;
  for (auto* marker = d.jpeg.marker_list; marker != nullptr; marker = marker->next) {
    const std::string_view data(reinterpret_cast<const char*>(marker->data), marker->data_length);
    if (marker->marker == exif_marker && data.starts_with(beginning))
      return exif_orientation(data.substr(beginning.size()));
  }
  return 1;
}

bool read_header(JpegDecoder& d) {
  if (setjmp(d.leave) != 0) return false;  // NOLINT: libjpeg's way
  jpeg_save_markers(&d.jpeg, exif_marker, 0xffff);
  jpeg_read_header(&d.jpeg, TRUE);
  return true;
}

bool read_rows(JpegDecoder& d, std::uint8_t* samples, std::size_t stride) {
  if (setjmp(d.leave) != 0) return false;  // NOLINT: libjpeg's way
  jpeg_start_decompress(&d.jpeg);
  while (d.jpeg.output_scanline < d.jpeg.output_height) {
    JSAMPROW row = samples + stride * d.jpeg.output_scanline;
    jpeg_read_scanlines(&d.jpeg, &row, 1);
  }
  jpeg_finish_decompress(&d.jpeg);
  return true;
}

[[noreturn]] void refuse_damaged(const JpegDecoder& d, const std::string& file) {
  refuse(file, "is a JPEG picture that is cut short or damaged ({}); copy it again", std::string_view(d.message));
}

Image decode_jpeg(const std::string& bytes, const std::string& file, const ImageChoice& choice) {
  JpegDecoder d(bytes);
  if (!read_header(d)) refuse_damaged(d, file);
  const int orientation = orientation_of(d);  // gone once the picture is read
  check_size(file, d.jpeg.image_width, d.jpeg.image_height, choice);
  chosen_slice(file, 1, choice);
  const bool grey = d.jpeg.jpeg_color_space == JCS_GRAYSCALE;
  if (!grey && d.jpeg.jpeg_color_space != JCS_YCbCr && d.jpeg.jpeg_color_space != JCS_RGB)
    refuse(file, "is a JPEG picture of printing inks; save it in grey or in red, green and blue");
  d.jpeg.out_color_space = grey ? JCS_GRAYSCALE : JCS_RGB;
  PixelLayout layout;
  layout.file = file;
  layout.width = static_cast<int>(d.jpeg.image_width);
  layout.height = static_cast<int>(d.jpeg.image_height);
  layout.samples = grey ? 1 : 3;
  layout.colour = !grey;
  layout.channel = choice.channel;
  std::vector<std::uint8_t> samples(layout.bytes_a_row() * static_cast<std::size_t>(layout.height));
  if (!read_rows(d, samples.data(), layout.bytes_a_row())) refuse_damaged(d, file);
  return upright(image_of(layout, samples, layout.bytes_a_row()), orientation);
}

}  // namespace

/// Four inks and what the decoder had to guess are refused.
const PictureFormat pictures::jpeg{.name = "jpeg",
                                   .sentence = "JPEG",
                                   .states = {{"orientation (EXIF)", "the picture is turned upright"}},
                                   .blurs = true,
                                   .is = [](std::string_view b) { return b.starts_with("\xff\xd8\xff"); },
                                   .read = decode_jpeg};

}  // namespace arenite::io
