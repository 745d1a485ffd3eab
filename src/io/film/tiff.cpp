#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/text.hpp"
#include "io/film/formats.hpp"
#include "io/film/stated_times.hpp"
#include "io/film/tiff_images.hpp"
#include "io/image/tiff.hpp"

namespace arenite::io {
namespace {

struct Page {
  std::uint32_t width = 0, height = 0;
  NumberType pixel = NumberType::u16;
  bool in_bits = false;  ///< eight pixels a byte: a picture of two values
  bool operator==(const Page&) const = default;
};

int bits_of(TIFF* tiff) { return tiff_field<std::uint16_t>(tiff, TIFFTAG_BITSPERSAMPLE); }

NumberType pixel_of(TIFF* tiff, const TiffSource& source) {
  const int bits = bits_of(tiff), format = tiff_field<std::uint16_t>(tiff, TIFFTAG_SAMPLEFORMAT);
  const bool whole = format == SAMPLEFORMAT_UINT || format == SAMPLEFORMAT_VOID;
  using enum NumberType;
  if (whole && bits == 1) return u8;
  if (whole && (bits == 8 || bits == 16 || bits == 32)) return bits == 8 ? u8 : bits == 16 ? u16 : u32;
  if (format == SAMPLEFORMAT_INT && (bits == 16 || bits == 32)) return bits == 16 ? i16 : i32;
  if (format == SAMPLEFORMAT_IEEEFP && (bits == 32 || bits == 64)) return bits == 32 ? f32 : f64;
  source.refuse(
      fmt::format("has {} bits per pixel in an unsupported form; save it with 1, 8 or 16 bits or floating", bits));
}

Page page_of(TIFF* tiff, const TiffSource& source) {
  Page page{tiff_field<std::uint32_t>(tiff, TIFFTAG_IMAGEWIDTH), tiff_field<std::uint32_t>(tiff, TIFFTAG_IMAGELENGTH),
            pixel_of(tiff, source), bits_of(tiff) == 1};
  if (tiff_field<std::uint16_t>(tiff, TIFFTAG_SAMPLESPERPIXEL) != 1 ||
      tiff_field<std::uint16_t>(tiff, TIFFTAG_PHOTOMETRIC) != PHOTOMETRIC_MINISBLACK)
    source.refuse("is not a grey film; save it with one number per pixel, black for the smallest");
  if (tiff_field<std::uint16_t>(tiff, TIFFTAG_ORIENTATION) != ORIENTATION_TOPLEFT)
    source.refuse("is stored rotated or mirrored; save it upright (orientation 1)");
  return page;
}

std::string text_of(TIFF* tiff, ttag_t tag) {
  const char* text = nullptr;
  return TIFFGetField(tiff, tag, &text) == 1 && text != nullptr ? text : "";
}

class TiffFilm : public KnownFilm {
 public:
  TiffFilm(const Bytes& bytes, const FilmChoice& choice)
      : source_(bytes),
        tiff_(open_tiff(source_, std::max<std::int64_t>(std::int64_t{1} << 24, choice.most_pixels * 16))) {
    if (!tiff_) source_.refuse_damaged();
    page_ = page_of(tiff_.get(), source_);
    layout_.pixel = page_.pixel;
    check_film_size(source_.file(), page_.width, page_.height, 1, choice);
    const std::string notes = text_of(tiff_.get(), TIFFTAG_IMAGEDESCRIPTION);
    const TiffStack stack = stack_in(notes, page_.width, page_.height);
    if (page_.in_bits && stack.images() > 1 && TIFFNumberOfDirectories(tiff_.get()) == 1)
      source_.refuse("describes images behind its first page with one bit per pixel; save it with 8 bits");
    images_.emplace(tiff_.get(), source_, stack, bytes_an_image(), choice.dataset);
    take_shape(info_, source_.file(), {images_->frames(), page_.height, page_.width}, page_.pixel, choice);
    take_notes(notes, info_);
    info_.remarks = images_->remarks();
    take_calibration(stack, choice);
    take_times(stack, notes, choice.frame_rate.has_value());
    take_choice(info_, choice);
    FrameBlock last;  // what is cut short lacks it
    read(info_.frames - 1, 1, last);
  }

  void fill(std::int64_t first, std::size_t count, FrameBlock& block) override {
    for (std::size_t i = 0; i < count; ++i) {
      const std::int64_t image = images_->image(first + static_cast<std::int64_t>(i));
      if (images_->behind() > 0) read_image_behind(image, i * info_.pixels(), block);
      else turn_to(image), read_page(i * info_.pixels(), block);
    }
  }

 private:
  std::uint64_t bytes_an_image() const { return std::uint64_t{page_.width} * page_.height * bytes_of(page_.pixel); }

  void turn_to(std::int64_t page) {
    if (TIFFSetSubDirectory(tiff_.get(), images_->directory(page)) != 1) source_.refuse_damaged();
    if (page > 0 && page_of(tiff_.get(), source_) != page_)
      source_.refuse(
          fmt::format("has pages of different size or type (pages 0 and {}); save a film of equal frames", page));
  }

  void take_calibration(const TiffStack& stack, const FilmChoice& choice) {
    const auto zero = zero_of_temperatures(stack.number_unit);
    if (zero) info_.quantity = FilmQuantity::kelvin;
    else if (!stack.number_unit.empty() && lower_case(stack.number_unit) != "gray value")
      info_.remarks.push_back(fmt::format("{} states that its numbers stand for values in \"{}\", which is not used.",
                                          stack.by, stack.number_unit));
    if (!zero || choice.gives_temperatures()) return;
    layout_.scale = stack.number_step;
    layout_.shift = stack.number_zero + *zero;
    layout_.scaled = layout_.scale != 1 || layout_.shift != 0;
    if (layout_.scaled) info_.floating = true, info_.bits = 0;
  }

  void take_times(const TiffStack& stack, const std::string& notes, bool rate_given) {
    if (stack.interval > 0 && info_.frame_rate == 0) info_.frame_rate = 1 / stack.interval;
    if (stack.shown_per_second > 0 && info_.frame_rate == 0)
      info_.remarks.push_back(
          fmt::format("{} shows it at {:.6g} frames/s, which need not be the camera's rate and is not used.", stack.by,
                      stack.shown_per_second));
    if (!stack.unknown_unit.empty())
      info_.remarks.push_back(
          fmt::format("Its times are in \"{}\", a unit that is not known; they are left aside.", stack.unknown_unit));
    const FrameWords first = words_of_frame(notes);
    const bool by_camera = stack.by.empty();  // ImageJ's fps is the rate at which it plays a film
    if (by_camera && info_.frame_rate == 0) info_.frame_rate = first.rate;
    const bool by_pages = images_->behind() == 0,
               has_words = first.number >= 0 || !first.not_understood.empty() || !first.unknown_rate.empty();
    if (by_pages && (std::isfinite(first.time) || (has_words && by_camera))) read_words(rate_given);
    else take_stamps(info_, images_->times());
    if (by_pages && info_.time.empty() && info_.number.empty()) tell_date_times();
  }

  void read_words(bool rate_given) {
    std::vector<FrameWords> words;
    for (std::int64_t i = 0; i < info_.frames; ++i) {
      turn_to(images_->image(i));
      words.push_back(words_of_frame(text_of(tiff_.get(), TIFFTAG_IMAGEDESCRIPTION)));
    }
    take_words(info_, words, rate_given);
  }

  /// The tag counts whole seconds, which are no times of the frames of a camera.
  void tell_date_times() {
    turn_to(images_->image(0));
    const std::string first = text_of(tiff_.get(), TIFFTAG_DATETIME);
    turn_to(images_->image(info_.frames - 1));
    const std::string last = text_of(tiff_.get(), TIFFTAG_DATETIME);
    if (!first.empty() && !last.empty() && first != last)
      info_.remarks.push_back(
          fmt::format("Its pages state when they were taken in whole seconds (DateTime, {} to {}), which is not used.",
                      first, last));
  }

  void read_page(std::size_t at, FrameBlock& frames) {
    each_block(tiff_.get(), source_, [&](const TiffBlock& block) {
      for (std::size_t r = 0; r < block.rows; ++r)
        take_pixels(layout_, reinterpret_cast<const char*>(block.row(r)), block.columns, frames,
                    at + (block.y + r) * page_.width + block.x);
    });
  }

  /// As the bytes are stored, which libtiff turns round in pages.
  void read_image_behind(std::int64_t image, std::size_t at, FrameBlock& frames) {
    const std::uint64_t size = bytes_an_image();
    const std::string stored = source_.bytes->text(images_->behind() + static_cast<std::uint64_t>(image) * size, size);
    if (stored.size() != size) source_.refuse_damaged();
    PlainLayout layout = layout_;
    layout.big_endian = TIFFIsBigEndian(tiff_.get()) != 0;
    take_pixels(layout, stored.data(), info_.pixels(), frames, at);
  }

  TiffSource source_;
  Tiff tiff_;
  std::optional<TiffImages> images_;
  Page page_;
  PlainLayout layout_;
};

/// A page a frame, one strip each; 64-bit places where the film may outgrow those of 32 bits.
class TiffFilmWriter : public FilmWriter {
 public:
  TiffFilmWriter(const std::filesystem::path& path, const FilmInfo& info)
      : file_(path),
        name_(path.string()),
        info_(info),
        frame_size_(info.pixels() * (info.floating ? sizeof(float) : sizeof(std::uint16_t))) {
    constexpr std::int64_t most = 0xffffffff, most_a_directory = 4096;
    const bool small =
        info.frames > 0 && info.frames <= most / (static_cast<std::int64_t>(frame_size_) + most_a_directory);
    tiff_ = create_tiff(file_.beside(), !small);
    if (!tiff_) refuse();
  }

  void append(const FrameBlock& block) override {
    const std::string_view bytes = pixel_bytes(info_, block);
    for (std::size_t i = 0; i < block.frames; ++i) {
      describe_page();
      const auto size = static_cast<tmsize_t>(frame_size_);
      const tmsize_t written =
          TIFFWriteRawStrip(tiff_.get(), 0, const_cast<char*>(bytes.data() + i * frame_size_), size);
      if (written != size || TIFFWriteDirectory(tiff_.get()) != 1) refuse();
      ++frames_;
    }
  }

  void finish() override {
    if (TIFFFlush(tiff_.get()) != 1) refuse();
    tiff_.reset();
    file_.commit();
  }

 private:
  [[noreturn]] void refuse() const {
    arenite::refuse(name_, "cannot be written as TIFF; check that the disk has space");
  }

  void describe_page() {
    TIFF* const tiff = tiff_.get();
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(info_.width));
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(info_.height));
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, info_.floating ? 32 : 16);
    TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, info_.floating ? SAMPLEFORMAT_IEEEFP : SAMPLEFORMAT_UINT);
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_NONE);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, static_cast<std::uint32_t>(info_.height));
    std::string notes = frames_ == 0 ? film_notes(info_) : "";
    if (frames_ < info_.time.size()) notes += fmt::format("time = {:.9f}\n", info_.time[frames_]);
    if (!notes.empty()) TIFFSetField(tiff, TIFFTAG_IMAGEDESCRIPTION, notes.c_str());
  }

  AtomicFile file_;
  std::string name_;
  FilmInfo info_;
  std::size_t frame_size_;  ///< bytes
  Tiff tiff_{nullptr, TIFFClose};
  std::size_t frames_ = 0;
};

}  // namespace

/// TIFF and BigTIFF: a page a frame, grey, 1, 8 or 16 bits or floating.
const FilmFormat films::tiff{
    .name = "tiff",
    .sentence = "TIFF or BigTIFF",
    .states =
        {{"number of images (ImageJ, OME, tifffile)",
          "used, also where one directory stands for all; refused where the file holds fewer, told where it "
          "holds more"},
         {"channels", "one is chosen (--dataset \"channel 2\")"},
         {"slices beside frames", "refused"},
         {"frame interval (ImageJ's finterval, OME's TimeIncrement)", "is the frame rate"},
         {"rate at which ImageJ plays it (fps)", "told, not used"},
         {"ImageJ's calibration by a straight line, to a unit of temperature", "used; told of another unit"},
         {"times of frames (OME's DeltaT)", "used"},
         {"\"time = 33.3 ms\", \"frame 12\", {\"timestamp_s\": 0.4} in the descriptions of pages",
          "used, as in frames of text"},
         {"\"frame rate = 0.1 kHz\", \"fps: 30\", \"Frame interval [ms]: 33\" in the description of the first page",
          "used where no time is stated and no rate is given; told where it is not understood"},
         {"dates and times of pages (DateTime), in whole seconds", "told, not used"},
         {"orientation other than upright", "refused"},
         {"frames of NaN, of one number, or the frame before once more", "left out as lost, and named"}},

    .endings = {".tif", ".tiff"},
    .marked = true,
    .has_datasets = true,
    .is = is_tiff,
    .open = [](const Bytes& bytes, const FilmChoice& choice) -> FilmPointer {
      return std::make_unique<TiffFilm>(bytes, choice);
    },
    .create = [](const auto& path, const FilmInfo& info) -> FilmWriterPointer {
      return std::make_unique<TiffFilmWriter>(path, info);
    }};

}  // namespace arenite::io
