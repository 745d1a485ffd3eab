#include "io/film/film.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/problems.hpp"
#include "core/text.hpp"
#include "io/disk/file.hpp"
#include "io/disk/store_file.hpp"
#include "io/film/formats.hpp"
#include "io/film/other_recording.hpp"

namespace arenite::io {
namespace {

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
        if (const FilmFormat* format = format_of(*open_bytes(path)); format != nullptr && !format->sidecar.empty())
          return path;
  }
  return {};
}

struct CanBeWritten {
  bool of_temperatures = false;
  bool operator()(const FilmFormat& format) const {
    return format.create != nullptr && !(of_temperatures && format.levels_only);
  }
};

}  // namespace

std::string film_formats() { return list_of(words_of(films::all, &FilmFormat::sentence)); }

std::vector<std::string> film_formats_to_write(bool of_temperatures) {
  return words_of(films::all, &FilmFormat::name, CanBeWritten{of_temperatures});
}

std::vector<std::string> film_endings_to_write(bool of_temperatures) {
  return words_of(
      films::all, [](const FilmFormat& f) { return f.endings[0]; }, CanBeWritten{of_temperatures});
}

void refuse_other_recording(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return;
  const Bytes bytes = open_bytes(path);
  const FilmFormat* format = format_of(*bytes);
  if (format != nullptr && format->marked) return;
  if (const std::string what = other_recording(path, bytes->text(0, head_size)); !what.empty())
    throw InputError(path.string(), 0, what);
}

std::unique_ptr<FilmSource> open_film(const Bytes& bytes, const FilmChoice& choice) {
  if (bytes->size() == 0) refuse(bytes->name(), "is empty; copy it again");
  const FilmFormat* format = format_of(*bytes);
  if (format == nullptr) {
    refuse_compressed(bytes->text(0, head_size), bytes->name());
    const auto sidecars =
        words_of(films::all, &FilmFormat::sidecar, [](const FilmFormat& known) { return !known.sidecar.empty(); });
    refuse(bytes->name(), "is not a film in a known format ({}); {}", film_formats(), list_of(sidecars));
  }
  FilmPointer film = format->open(bytes, choice);
  film->is_of(format->name);
  return scaled_film(std::move(film), choice);
}

std::unique_ptr<FilmSource> open_film(const std::filesystem::path& path, const FilmChoice& choice) {
  std::error_code error;
  const bool pattern = path.filename().string().find('*') != std::string::npos && !std::filesystem::exists(path, error);
  if (pattern || std::filesystem::is_directory(path, error)) return open_series(path, choice);
  const Bytes bytes = open_bytes(path);
  refuse_other_recording(path);
  if (!stored_kind(path).empty()) refuse(path.string(), "is a result of Arenite, not a film; use \"arenite show\"");
  const FilmFormat* format = format_of(*bytes);
  const std::filesystem::path sidecar =
      format != nullptr && format->marked ? std::filesystem::path() : sidecar_of(path);
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

std::unique_ptr<FilmWriter> create_film(const std::filesystem::path& path, const FilmInfo& info,
                                        const std::string& format) {
  const FilmFormat* known = format.empty() ? format_ending(films::all, path) : format_named(films::all, format);
  if (known == nullptr || !CanBeWritten{}(*known))
    refuse(path.string(), "has no film format that can be written; the formats are {} (name it so, or {})",
           list_of(film_formats_to_write()), list_of(film_endings_to_write()));
  if (known->levels_only && info.floating)
    refuse(path.string(), "cannot hold temperatures: a {} film is of levels; write {}", known->endings[0],
           list_of(film_endings_to_write(true)));
  return known->create(path, info);
}

std::vector<double> lock_in_line(const std::filesystem::path& film) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(film, error)) return {};
  const Bytes bytes = open_bytes(film);
  const FilmFormat* format = format_of(*bytes);
  return format != nullptr && format->lock_in_line != nullptr ? format->lock_in_line(*bytes) : std::vector<double>();
}

bool write_film(const std::filesystem::path& path, FilmSource& film, const std::string& format,
                const std::function<bool(double share)>& progress) {
  const FilmInfo& info = film.info();
  const auto writer = create_film(path, info, format);
  constexpr std::size_t most_pixels = std::size_t{1} << 22;
  const auto at_once =
      static_cast<std::int64_t>(std::max<std::size_t>(1, most_pixels / std::max<std::size_t>(1, info.pixels())));
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
  const bool counted = info.time.size() < 2 && info.number.size() > 1;
  const std::vector<double> at = counted ? std::vector<double>(info.number.begin(), info.number.end()) : info.time;
  if (at.size() < 2) {
    times.interval = set;
    times.duration = set * static_cast<double>(std::max<std::int64_t>(info.frames - 1, 0));
    return times;
  }
  std::vector<double> step(at.size() - 1);
  for (std::size_t i = 0; i < step.size(); ++i) step[i] = at[i + 1] - at[i];
  std::vector<double> sorted = step;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>((sorted.size() - 1) / 2);  // of two the smaller
  std::nth_element(sorted.begin(), middle, sorted.end());
  const double usual = *middle;
  double even = 0, sum = 0;  // stamps are rounded, their mean is not
  for (const double s : step)
    if (s < 1.5 * usual) sum += s, ++even;
  const double unit = counted ? 1 : sum / even;
  for (std::size_t i = 0; i < step.size(); ++i) {
    if (step[i] < 1.5 * unit) continue;
    times.dropped += std::max<std::int64_t>(std::llround(std::min(step[i] / unit, 1e15)) - 1, 0);
    times.gap.push_back(static_cast<std::int64_t>(i) + 1);
  }
  times.interval = counted ? set : usual;
  times.duration = (at.back() - at.front()) * (counted ? set : 1);
  return times;
}

}  // namespace arenite::io
