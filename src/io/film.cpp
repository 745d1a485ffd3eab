#include "io/film.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "io/file_marks.hpp"
#include "io/film_formats.hpp"
#include "io/other_recording.hpp"
#include "io/sealed_file.hpp"

namespace arenite::io {
namespace {

struct Format {
  const char* name;
  bool marked;  ///< begins with a mark that nothing else begins with
  bool (*is)(std::string_view head);
  FilmPointer (*open)(const Bytes& bytes, const FilmChoice& choice);
};

/// In the order in which they are tried: text last, for it has no mark.
constexpr Format formats[] = {
    {"ptw", true, is_ptw, open_ptw},
    {"npy", true, is_npy, open_npy},
    {"tiff", true, is_tiff, open_tiff_film},
    {"hdf5", true, is_hdf5, open_hdf5_film},
    {"sfmov", true, is_sfmov, open_sfmov},
    {"hcc", false, is_hcc, open_hcc},
    {"raw", false, is_sidecar, open_sidecar},
    {"text", false, is_text_film, open_text_film},
};

constexpr std::size_t head_size = 65536;

/// The sidecar of raw frames: their name with another ending, or with one more.
std::filesystem::path sidecar_of(const std::filesystem::path& raw) {
  std::error_code error;
  for (const char* ending : {".toml", ".txt"}) {
    auto beside = raw;
    beside.replace_extension(ending);
    for (const auto& path : {beside, std::filesystem::path(raw.string() + ending)})
      if (path != raw && std::filesystem::is_regular_file(path, error) && is_sidecar(open_bytes(path)->text(0, head_size))) return path;
  }
  return {};
}

const Format* format_of(const ByteSource& bytes) {
  const std::string head = bytes.text(0, head_size);
  for (const Format& format : formats)
    if (format.is(head)) return &format;
  return nullptr;
}

}  // namespace

std::vector<std::string> film_formats() {
  std::vector<std::string> names;
  for (const Format& format : formats) names.emplace_back(format.name);
  return names;
}

void refuse_other_recording(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return;
  const Bytes bytes = open_bytes(path);
  const Format* format = format_of(*bytes);
  if (format != nullptr && format->marked) return;
  if (const std::string what = other_recording(path, bytes->text(0, head_size)); !what.empty()) throw InputError(path.string(), 0, what);
}

std::unique_ptr<FilmSource> open_film(const Bytes& bytes, const FilmChoice& choice) {
  if (bytes->size() == 0) throw InputError(bytes->name(), 0, "is empty; copy it again");
  if (const Format* format = format_of(*bytes)) return scaled_film(format->open(bytes, choice), choice);
  throw InputError(bytes->name(), 0, "is no film: neither .ptw, .sfmov, .hcc, .npy, TIFF, HDF5 nor frames as text; "
                                     "describe raw frames in a text beside it, NAME.txt with the lines width = .., height = .. and type = ..");
}

std::unique_ptr<FilmSource> open_film(const std::filesystem::path& path, const FilmChoice& choice) {
  std::error_code error;
  const bool pattern = path.filename().string().find('*') != std::string::npos && !std::filesystem::exists(path, error);
  if (pattern || std::filesystem::is_directory(path, error)) return scaled_film(open_series(path, choice), choice);
  const Bytes bytes = open_bytes(path);
  refuse_other_recording(path);
  if (!sealed_kind(path).empty()) throw InputError(path.string(), 0, "is a result of Arenite, not a film; look at it with \"arenite show\"");
  const Format* format = format_of(*bytes);
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
  if (!sealed_kind(path).empty()) return false;
  return format_of(*open_bytes(path)) != nullptr || !sidecar_of(path).empty();
}

}  // namespace arenite::io
