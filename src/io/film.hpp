#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/byte_source.hpp"
#include "model/film.hpp"

namespace arenite::io {

/// What is meant of a file, and how large a film may be.
struct FilmChoice {
  std::string dataset = {};                  ///< of an HDF5 file; empty: the only one that can be meant
  std::optional<double> frame_rate = {};     ///< Hz, instead of what the film says; its time stamps are then left aside
  std::optional<double> scale = {}, offset = {};  ///< K: pixels become scale * number + offset, whatever the film says that they are
  std::int64_t most_pixels = 100'000'000;    ///< in a frame; larger ones are refused before memory is asked for
};

/// Names of the formats that can be read, for help texts. The content decides, not the name.
std::vector<std::string> film_formats();

/// A film that is read part by part: Cedip .ptw, FLIR .sfmov, Telops .hcc, .npy, TIFF with a page a frame, HDF5, frames
/// of numbers as text, raw frames with a sidecar (the sidecar's name or that of the file beside it). A folder, or a name
/// with *, is a series of such files in the order of the numbers in their names. InputError for anything else.
std::unique_ptr<FilmSource> open_film(const std::filesystem::path& path, const FilmChoice& choice = {});

/// The same from bytes.
std::unique_ptr<FilmSource> open_film(const Bytes& bytes, const FilmChoice& choice = {});

/// Throws InputError that names what a recording is, and what to export, if it is one of a kind that cannot be read: a camera's own format, or
/// a video.
void refuse_other_recording(const std::filesystem::path& path);

/// Whether this is to be read as a film: a file in one of these formats that is no result of ours, a pattern, or a folder
/// without results.
bool looks_like_film(const std::filesystem::path& path);

}  // namespace arenite::io
