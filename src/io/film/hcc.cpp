#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "core/problems.hpp"
#include "io/film/formats.hpp"

namespace arenite::io {
namespace {

/// What calibration of a frame says: 2 is temperatures, 3 and 4 radiances, the others levels.
constexpr int temperatures = 2, radiances = 3, radiances_in_band = 4;

constexpr std::size_t needed = 256;

std::string header_of(const ByteSource& bytes, std::uint64_t at, std::int64_t frame) {
  std::string header = bytes.text(at, needed);
  if (header.size() < needed || !header.starts_with("TC"))
    refuse(bytes.name(), "has no header before frame {}; copy it again", frame);
  return header;
}

/// Times after the first frame, s, or numbers where there are none: whole seconds are taken off first, so that their
/// tenths of microseconds stay.
void read_stamps(const ByteSource& bytes, std::string_view first, std::uint64_t stride, FilmInfo& info) {
  const double seconds = number_at<std::uint32_t>(first, 100);
  std::vector<double> stamp;
  std::vector<std::int64_t> number;
  for (std::int64_t i = 0; i < info.frames; ++i) {
    const std::string header = header_of(bytes, static_cast<std::uint64_t>(i) * stride, i);
    for (const auto& [at, size, what] : {std::tuple{4, 2, "size"}, {32, 4, "size"}, {12, 5, "scale"}, {28, 1, "scale"}})
      if (header.compare(at, size, first, at, size) != 0)
        refuse(bytes.name(), "has another {} from frame {} on; cut it there", what, i);
    number.push_back(number_at<std::uint32_t>(header, 8));
    stamp.push_back((static_cast<double>(number_at<std::uint32_t>(header, 100)) - seconds) +
                    1e-7 * number_at<std::uint32_t>(header, 104));
  }
  take_stamps(info, std::move(stamp));
  if (info.time.empty() && number.back() > number.front()) take_numbers(info, std::move(number));
}

void take_scale(std::string_view header, FilmInfo& info, PlainLayout& layout) {
  const int mode = number_at<std::uint8_t>(header, 28);
  layout.scaled = mode == temperatures || mode == radiances || mode == radiances_in_band;
  layout.scale = std::ldexp(1.0, number_at<std::int8_t>(header, 16));
  layout.shift = number_at<float>(header, 12);
  if (!layout.scaled) info.quantity = FilmQuantity::digital_level;
  else if (mode == temperatures)
    info.remarks.emplace_back(
        "The camera converted its levels to temperatures; the file does not state whether in kelvin or degrees "
        "Celsius, which does not affect amplitudes.");
  else info.remarks.emplace_back("The camera converted its levels to radiances.");
}

bool is_hcc(std::string_view head) {
  return head.starts_with("TC") && number_at<std::uint16_t>(head, 4) >= needed &&
         number_at<std::uint16_t>(head, 32) > 0 && number_at<std::uint16_t>(head, 34) > 0;
}

FilmPointer open_hcc(const Bytes& bytes, const FilmChoice& choice) {
  const std::string header = header_of(*bytes, 0, 0);
  FilmInfo info;
  info.width = number_at<std::uint16_t>(header, 32);
  info.height = number_at<std::uint16_t>(header, 34);
  info.frame_rate = 1e-3 * number_at<std::uint32_t>(header, 44);
  info.integration = 1e-8 * number_at<std::uint32_t>(header, 24);
  info.bits = std::min<int>(number_at<std::uint8_t>(header, 225), 16);
  if (const auto serial = number_at<std::uint32_t>(header, 248); serial != 0)
    info.camera = fmt::format("Telops {}", serial);
  check_film_size(bytes->name(), info.width, info.height, 1, choice);
  PlainLayout layout;
  layout.offset = number_at<std::uint16_t>(header, 4);
  if (layout.offset < needed)
    refuse(bytes->name(), "states that its headers have {} bytes, too few; copy it again", layout.offset);
  layout.stride = layout.offset + 2 * info.pixels();
  take_scale(header, info, layout);
  if (!std::isfinite(layout.shift)) refuse(bytes->name(), "has a scale that is not a number; copy it again");
  info.frames = static_cast<std::int64_t>((bytes->size() + layout.stride - 1) /
                                          layout.stride);  // a part of one is a film cut short
  check_layout(*bytes, info, layout, choice);
  read_stamps(*bytes, header, layout.stride, info);
  return plain_film(bytes, std::move(info), layout, choice);
}

}  // namespace

/// Telops: every frame with a header that begins with "TC" and says size, scale and time.
const FilmFormat films::hcc{
    .name = "hcc",
    .sentence = "Telops .hcc",
    .states = {{"time stamps", "used"},
               {"frame numbers", "used where stamps cannot be"},
               {"scale of temperatures or radiances", "used"},
               {"frames of one number, or the frame before once more", "left out as lost, and named"}},
    .is = is_hcc,
    .open = open_hcc};

}  // namespace arenite::io
