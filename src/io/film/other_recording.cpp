#include "io/film/other_recording.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>

#include "core/text.hpp"

namespace arenite::io {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view by_flir = "FLIR's program (Research Studio, ResearchIR, Thermal Studio)";
constexpr std::string_view levels = "as a stack of TIFF, .sfmov or CSV of levels or temperatures";

/// A recording that cannot be read as a film, known by its ending, or by the bytes at a place of its beginning.
struct Recording {
  std::string_view ending, what, program = {}, as = {};
  std::size_t at = 0;
  std::string_view mark = {};
};

constexpr Recording recordings[] = {
    {".seq", "is a FLIR sequence (.seq), whose frames are packed in FLIR's proprietary format", by_flir, levels, 1,
     "FF\0"sv},  // FFF and AFF
    {".csq", "is a packed FLIR sequence (.csq), in FLIR's proprietary format", by_flir, levels},
    {".fcf", "is a FLIR public image or sequence (.fcf), in FLIR's proprietary format", by_flir, levels},
    {".ats", "is a FLIR ATS film (.ats), in FLIR's proprietary format", by_flir, levels},
    {".irb", "is an InfraTec film (.irb), in InfraTec's proprietary format", "IRBIS",
     "as a stack of TIFF or as text, in temperatures", 0, "\xffIRB"sv},
    {".ravi", "is an Optris film (.ravi), in Optris' proprietary format", "PIX Connect",
     "as CSV or TIFF, in temperatures"},
    {".is2", "is a Fluke picture (.is2), in Fluke's proprietary format", "SmartView", "as CSV, in temperatures"},
    {".is3", "is a Fluke film (.is3), in Fluke's proprietary format", "SmartView", "as CSV, in temperatures"},
    {".mp4", "is a video (MPEG-4)", {}, {}, 4, "ftyp"sv},
    {".m4v", "is a video (MPEG-4)"},
    {".mov", "is a video (QuickTime)", {}, {}, 4, "moov"sv},
    {".h264", "is a video (H.264)", {}, {}, 0, "\0\0\0\1\x67"sv},
    {".h265", "is a video (H.265)"},
    {".mkv", "is a video (Matroska)", {}, {}, 0, "\x1a\x45\xdf\xa3"sv},
    {".avi", "is a video (AVI)", {}, {}, 8, "AVI "sv},
    {".wmv", "is a video (Windows Media)", {}, {}, 0, "\x30\x26\xb2\x75"sv},
};

}  // namespace

std::string other_recording(const std::filesystem::path& path, std::string_view head) {
  const std::string ending = lower_case(path.extension().string());
  const auto* is = std::ranges::find(recordings, ending, &Recording::ending);
  if (is == std::end(recordings))
    is = std::ranges::find_if(recordings, [&](const Recording& r) {
      return !r.mark.empty() && head.size() > r.at && head.substr(r.at).starts_with(r.mark);
    });
  if (is == std::end(recordings)) return {};
  if (is->program.empty())
    return fmt::format(
        "{}: compressed colours, in which an amplitude of a few millikelvin is lost; export the camera's own levels or "
        "temperatures, {}",
        is->what, levels);
  return fmt::format("{}; export it with {} {}", is->what, is->program, is->as);
}

}  // namespace arenite::io
