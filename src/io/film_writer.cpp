#include "io/film_writer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "core/error.hpp"
#include "io/film_writers.hpp"

namespace arenite::io {
namespace {

struct Format {
  const char* name;
  std::vector<std::string> endings;
  FilmWriterPointer (*create)(const std::filesystem::path& path, const FilmInfo& info);
};

const std::vector<Format>& formats() {
  static const std::vector<Format> list{{"tiff", {".tif", ".tiff"}, create_tiff_film},
                                        {"npy", {".npy"}, create_npy_film},
                                        {"hdf5", {".h5", ".hdf5"}, create_hdf5_film},
                                        {"sfmov", {".sfmov"}, create_sfmov_film},
                                        {"ptw", {".ptw"}, create_ptw_film}};
  return list;
}

}  // namespace

std::vector<std::string> film_formats_to_write() {
  std::vector<std::string> names;
  for (const Format& format : formats()) names.emplace_back(format.name);
  return names;
}

std::string film_format_of(const std::filesystem::path& path) {
  for (const Format& format : formats())
    if (std::find(format.endings.begin(), format.endings.end(), path.extension().string()) != format.endings.end()) return format.name;
  return {};
}

std::unique_ptr<FilmWriter> create_film(const std::filesystem::path& path, const FilmInfo& info, const std::string& format) {
  const std::string name = format.empty() ? film_format_of(path) : format;
  for (const Format& known : formats())
    if (known.name == name) return known.create(path, info);
  throw InputError(path.string(), 0, fmt::format("asks for no format that films are written in; they are {} (name it so, or .tif, .npy, .h5, .sfmov, .ptw)",
                                                 fmt::join(film_formats_to_write(), ", ")));
}

void write_film(const std::filesystem::path& path, FilmSource& film, const std::string& format) {
  const FilmInfo& info = film.info();
  const auto writer = create_film(path, info, format);
  constexpr std::size_t most_pixels = std::size_t{1} << 22;
  const auto at_once = static_cast<std::int64_t>(std::max<std::size_t>(1, most_pixels / std::max<std::size_t>(1, info.pixels())));
  FrameBlock block;
  for (std::int64_t i = 0; i < info.frames; i += at_once) {
    film.read(i, static_cast<std::size_t>(std::min(at_once, info.frames - i)), block);
    writer->append(block);
  }
  writer->finish();
}

std::string_view pixel_bytes(const FilmInfo& info, const FrameBlock& block) {
  const std::size_t pixels = block.frames * info.pixels();
  if ((info.floating ? block.value.size() : block.level.size()) != pixels) throw std::invalid_argument("frames of another film");
  if (info.floating) return {reinterpret_cast<const char*>(block.value.data()), pixels * sizeof(float)};
  return {reinterpret_cast<const char*>(block.level.data()), pixels * sizeof(std::uint16_t)};
}

}  // namespace arenite::io
