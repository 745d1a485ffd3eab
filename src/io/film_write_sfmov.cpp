#include <fmt/format.h>

#include "io/headed_film_writer.hpp"

namespace arenite::io {
namespace {

/// Digits left free for the number of frames, which is known at the end.
constexpr std::size_t count_width = 12;

std::string header(const FilmInfo& info, std::size_t frames) {
  std::string text = fmt::format("HdSize auto\r\nNumDPs {:0{}}\r\nxPixls {}\r\nyPixls {}\r\nDaType {}\r\n", frames, count_width, info.width,
                                 info.height, info.floating ? "Flt32" : "UInt16");
  if (info.bits > 0) text += fmt::format("ADBits {}\r\n", info.bits);
  if (info.frame_rate > 0) text += fmt::format("FRate_0 {}\r\n", info.frame_rate);
  if (info.integration > 0) text += fmt::format("ITime_0 {}\r\n", info.integration * 1e3);
  return text + "DATA\r\n";
}

}  // namespace

FilmWriterPointer create_sfmov_film(const std::filesystem::path& path, const FilmInfo& info) { return create_headed_film(path, info, header); }

}  // namespace arenite::io
