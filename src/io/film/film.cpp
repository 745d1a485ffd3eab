#include "io/film/film.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/median.hpp"
#include "core/problems.hpp"
#include "core/text.hpp"
#include "io/disk/store_file.hpp"
#include "io/film/formats.hpp"

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
    Mark{0, "FFF\0"sv, ".seq"},
    Mark{0, "AFF\0"sv, ".seq"},
    Mark{0, "\xffIRB"sv, ".irb"},
    Mark{4, "ftyp"sv, ".mp4"},
    Mark{4, "moov"sv, ".mov"},
    Mark{8, "AVI "sv, ".avi"},
    Mark{0, "\x1a\x45\xdf\xa3"sv, ".mkv"},
    Mark{0, "\0\0\0\1\x67"sv, ".h264"},
    Mark{0, "\x30\x26\xb2\x75"sv, ".wmv"},
};

const Recording* with_ending(std::string_view ending) {
  const auto* found = std::find_if(recordings.begin(), recordings.end(), [&](const Recording& r) { return r.ending == ending; });
  return found != recordings.end() ? found : nullptr;
}

constexpr std::size_t head_size = 65536;

const FilmFormat* format_of(const ByteSource& bytes) {
  const std::string head = bytes.text(0, head_size);
  return first_format(films::all, [&](const FilmFormat& format) { return format.is(head); });
}

/// The sidecar of raw frames: their name with another ending, or with one more.
std::filesystem::path sidecar_of(const std::filesystem::path& raw) {
  std::error_code error;
  for (const char* ending : {".toml", ".txt"}) {
    auto beside = raw;
    beside.replace_extension(ending);
    for (const auto& path : {beside, std::filesystem::path(raw.string() + ending)})
      if (path != raw && std::filesystem::is_regular_file(path, error))
        if (const FilmFormat* format = format_of(*open_bytes(path)); format != nullptr && !format->sidecar.empty()) return path;
  }
  return {};
}

bool can_be_written(const FilmFormat& format) { return format.create != nullptr; }

}  // namespace

std::string film_formats() { return list_of(words_of(films::all, &FilmFormat::sentence)); }

std::vector<std::string> film_formats_to_write(bool of_temperatures) {
  return words_of(films::all, &FilmFormat::name, [&](const FilmFormat& f) { return can_be_written(f) && !(of_temperatures && f.levels_only); });
}

std::vector<std::string> film_endings_to_write(bool of_temperatures) {
  return words_of(
      films::all, [](const FilmFormat& f) { return f.endings[0]; },
      [&](const FilmFormat& f) { return can_be_written(f) && !(of_temperatures && f.levels_only); });
}

void refuse_other_recording(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return;
  const Bytes bytes = open_bytes(path);
  const FilmFormat* format = format_of(*bytes);
  if (format != nullptr && format->marked) return;
  if (const std::string what = other_recording(path, bytes->text(0, head_size)); !what.empty()) throw InputError(path.string(), 0, what);
}

std::unique_ptr<FilmSource> open_film(const Bytes& bytes, const FilmChoice& choice) {
  if (bytes->size() == 0) refuse(bytes->name(), "is empty; copy it again");
  const FilmFormat* format = format_of(*bytes);
  if (format == nullptr) {
    const auto sidecars = words_of(films::all, &FilmFormat::sidecar, [](const FilmFormat& known) { return !known.sidecar.empty(); });
    refuse(bytes->name(), "is not a film in a known format ({}); {}", film_formats(), list_of(sidecars));
  }
  FilmPointer film = format->open(bytes, choice);
  film->is_of(format->name);
  return scaled_film(std::move(film), choice);
}

std::unique_ptr<FilmSource> open_film(const std::filesystem::path& path, const FilmChoice& choice) {
  std::error_code error;
  const bool pattern = path.filename().string().find('*') != std::string::npos && !std::filesystem::exists(path, error);
  if (pattern || std::filesystem::is_directory(path, error)) return scaled_film(open_series(path, choice), choice);
  const Bytes bytes = open_bytes(path);
  refuse_other_recording(path);
  if (!stored_kind(path).empty()) refuse(path.string(), "is a result of Arenite, not a film; look at it with \"arenite show\"");
  const FilmFormat* format = format_of(*bytes);
  const std::filesystem::path sidecar = format != nullptr && format->marked ? std::filesystem::path() : sidecar_of(path);
  return open_film(sidecar.empty() ? bytes : open_bytes(sidecar), choice);
}

bool looks_like_film(const std::filesystem::path& path) {
  std::error_code error;
  const auto is_ours = [](const auto& entry) { return entry.path().extension() == ".h5"; };
  if (std::filesystem::is_directory(path, error)) {
    const std::filesystem::directory_iterator entries(path, error), end;
    return std::none_of(entries, end, is_ours);
  }
  if (!std::filesystem::is_regular_file(path, error)) return path.filename().string().find('*') != std::string::npos;
  if (!stored_kind(path).empty()) return false;
  return format_of(*open_bytes(path)) != nullptr || !sidecar_of(path).empty();
}

std::string other_recording(const std::filesystem::path& path, std::string_view head) {
  const Recording* is = with_ending(lower_case(path.extension().string()));
  for (const Mark& mark : marks)
    if (is == nullptr && head.size() > mark.at && head.substr(mark.at).starts_with(mark.bytes)) is = with_ending(mark.ending);
  if (is == nullptr) return {};
  if (is->program.empty())
    return fmt::format("{}: compressed colours, in which an amplitude of a few millikelvin is lost; export the camera's own levels or temperatures, {}",
                       is->what, levels);
  return fmt::format("{}; export it with {} {}", is->what, is->program, is->as);
}

std::unique_ptr<FilmWriter> create_film(const std::filesystem::path& path, const FilmInfo& info, const std::string& format) {
  const FilmFormat* known = format.empty() ? format_ending(films::all, path) : format_named(films::all, format);
  if (known == nullptr || !can_be_written(*known))
    refuse(path.string(), "asks for no format that films are written in; they are {} (name it so, or {})", list_of(film_formats_to_write()),
           list_of(film_endings_to_write()));
  if (known->levels_only && info.floating)
    refuse(path.string(), "cannot hold temperatures: a {} film is of levels; write {}", known->endings[0], list_of(film_endings_to_write(true)));
  return known->create(path, info);
}

std::vector<double> lock_in_line(const std::filesystem::path& film) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(film, error)) return {};
  const Bytes bytes = open_bytes(film);
  const FilmFormat* format = format_of(*bytes);
  return format != nullptr && format->lock_in_line != nullptr ? format->lock_in_line(*bytes) : std::vector<double>();
}

bool write_film(const std::filesystem::path& path, FilmSource& film, const std::string& format, const std::function<bool(double share)>& progress) {
  const FilmInfo& info = film.info();
  const auto writer = create_film(path, info, format);
  constexpr std::size_t most_pixels = std::size_t{1} << 22;
  const auto at_once = static_cast<std::int64_t>(std::max<std::size_t>(1, most_pixels / std::max<std::size_t>(1, info.pixels())));
  FrameBlock block;
  for (std::int64_t i = 0; i < info.frames; i += at_once) {
    film.read(i, static_cast<std::size_t>(std::min(at_once, info.frames - i)), block);
    writer->append(block);
    if (progress && !progress(static_cast<double>(i) / static_cast<double>(info.frames))) return false;
  }
  writer->finish();
  return true;
}

FrameIntervals frame_intervals(const FilmInfo& info) {
  FrameIntervals times;
  const double set = info.frame_rate > 0 ? 1 / info.frame_rate : 0;
  if (info.time.size() < 2) {
    times.interval = set;
    times.duration = set * static_cast<double>(std::max<std::int64_t>(info.frames - 1, 0));
    return times;
  }
  std::vector<double> step(info.time.size() - 1);
  for (std::size_t i = 0; i < step.size(); ++i) step[i] = info.time[i + 1] - info.time[i];
  times.interval = median(step);
  times.duration = info.time.back() - info.time.front();
  const double unit = set > 0 ? set : times.interval;
  for (std::size_t i = 0; i < step.size(); ++i) {
    times.dropped += std::max<std::int64_t>(std::llround(std::min(step[i] / unit, 1e15)) - 1, 0);
    if (step[i] > 1.5 * times.interval) times.gap.push_back(static_cast<std::int64_t>(i) + 1);
  }
  return times;
}

}  // namespace arenite::io
