#include "io/other_recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace arenite::io {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view by_flir = "FLIR's program (Research Studio, ResearchIR, Thermal Studio)";
constexpr std::string_view levels = "as a stack of TIFF, .sfmov or CSV of levels or temperatures";

struct Recording {
  std::string_view ending, what, program, as;
};

constexpr std::array recordings{
    Recording{".seq", "is a FLIR sequence (.seq), whose frames are packed in a form of FLIR's own", by_flir, levels},
    Recording{".csq", "is a packed FLIR sequence (.csq), in a form of FLIR's own", by_flir, levels},
    Recording{".fcf", "is a FLIR public image or sequence (.fcf), in a form of FLIR's own", by_flir, levels},
    Recording{".ats", "is a FLIR ATS film (.ats), in a form of FLIR's own", by_flir, levels},
    Recording{".irb", "is an InfraTec film (.irb), in a form of InfraTec's own", "IRBIS", "as a stack of TIFF or as text, in temperatures"},
    Recording{".ravi", "is an Optris film (.ravi), in a form of Optris' own", "PIX Connect", "as CSV or TIFF, in temperatures"},
    Recording{".is2", "is a Fluke picture (.is2), in a form of Fluke's own", "SmartView", "as CSV, in temperatures"},
    Recording{".is3", "is a Fluke film (.is3), in a form of Fluke's own", "SmartView", "as CSV, in temperatures"},
    Recording{".mp4", "is a video (MPEG-4)", {}, {}},
    Recording{".m4v", "is a video (MPEG-4)", {}, {}},
    Recording{".mov", "is a video (QuickTime)", {}, {}},
    Recording{".h264", "is a video (H.264)", {}, {}},
    Recording{".h265", "is a video (H.265)", {}, {}},
    Recording{".mkv", "is a video (Matroska)", {}, {}},
    Recording{".avi", "is a video (AVI)", {}, {}},
    Recording{".wmv", "is a video (Windows Media)", {}, {}},
};

struct Mark {
  std::size_t at;
  std::string_view bytes, ending;
};

constexpr std::array marks{
    Mark{0, "FFF\0"sv, ".seq"},       Mark{0, "AFF\0"sv, ".seq"},          Mark{0, "\xffIRB"sv, ".irb"},        Mark{4, "ftyp"sv, ".mp4"},
    Mark{4, "moov"sv, ".mov"},        Mark{8, "AVI "sv, ".avi"},           Mark{0, "\x1a\x45\xdf\xa3"sv, ".mkv"}, Mark{0, "\0\0\0\1\x67"sv, ".h264"},
    Mark{0, "\x30\x26\xb2\x75"sv, ".wmv"},
};

const Recording* with_ending(std::string_view ending) {
  const auto* found = std::find_if(recordings.begin(), recordings.end(), [&](const Recording& r) { return r.ending == ending; });
  return found != recordings.end() ? found : nullptr;
}

}  // namespace

std::string other_recording(const std::filesystem::path& path, std::string_view head) {
  std::string ending = path.extension().string();
  for (char& c : ending) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  const Recording* is = with_ending(ending);
  for (const Mark& mark : marks)
    if (is == nullptr && head.size() > mark.at && head.substr(mark.at).starts_with(mark.bytes)) is = with_ending(mark.ending);
  if (is == nullptr) return {};
  if (is->program.empty())
    return fmt::format("{}: compressed colours, of which the swing of a few millikelvin is lost; export the camera's own levels or temperatures, {}", is->what, levels);
  return fmt::format("{}; export it with {} {}", is->what, is->program, is->as);
}

}  // namespace arenite::io
