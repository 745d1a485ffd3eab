#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/disk/byte_source.hpp"
#include "model/film.hpp"

namespace arenite::io {

/// What is meant of a file, and how large a film may be.
struct FilmChoice {
  std::string dataset = {};               ///< of an HDF5 file; empty: the only one that can be meant
  std::optional<double> frame_rate = {};  ///< Hz, instead of what the film says; its time stamps are then left aside
  std::optional<double> scale = {},
                        offset =
                            {};  ///< K: pixels become scale * number + offset, whatever the film says that they are
  std::int64_t most_pixels = 100'000'000;  ///< in a frame; larger ones are refused before memory is asked for
  bool in_time = true;                     ///< false: slices of a volume, of which names and stamps tell no times
  bool gives_temperatures() const { return scale || offset; }
  bool operator==(const FilmChoice&) const = default;
};

/// A film that is read part by part, in any of the formats (docs/formats.md); raw frames have a sidecar (its name is
/// given, or that of the file beside it). A folder, or a name with *, is a series of such files in the order of the
/// numbers in their names. InputError for anything else.
std::unique_ptr<FilmSource> open_film(const std::filesystem::path& path, const FilmChoice& choice = {});

/// The files of such a series in the order of the numbers in their names. InputError where there are none.
std::vector<std::filesystem::path> files_of_series(const std::filesystem::path& pattern);

/// The same from bytes.
std::unique_ptr<FilmSource> open_film(const Bytes& bytes, const FilmChoice& choice = {});

/// Throws InputError that names what a recording is, and what to export, if it is one of a kind that cannot be read: a
/// camera's own format, or a video.
void refuse_other_recording(const std::filesystem::path& path);

/// Whether this is to be read as a film: a file in one of these formats that is no result of ours, a pattern, or a
/// folder without results.
bool looks_like_film(const std::filesystem::path& path);

/// A film that is written part by part and appears under its name when it is finished, or not at all.
class FilmWriter {
 public:
  virtual ~FilmWriter() = default;
  /// The next frames: levels, or values if the film is floating, of its size.
  virtual void append(const FrameBlock& block) = 0;
  virtual void finish() = 0;
};

/// The formats that can be read, for a sentence: "TIFF or BigTIFF, NumPy .npy, ..".
std::string film_formats();

/// Names of the formats that can be written, "tiff", "npy" .., and the endings that ask for them; all, or those that
/// have a place for temperatures.
std::vector<std::string> film_formats_to_write(bool of_temperatures = false);
std::vector<std::string> film_endings_to_write(bool of_temperatures = false);

/// A new film; the format of the name's ending unless another is given. `info` says size, kind of pixel and what the
/// film is to say about itself, so far as the format has a place for it; the number of frames is that of the frames
/// appended, and times must be there for as many. TIFF is BigTIFF where `info` does not announce fewer than 4 GiB.
/// InputError where the format has no place for such pixels, or the file cannot be written.
std::unique_ptr<FilmWriter> create_film(const std::filesystem::path& path, const FilmInfo& info,
                                        const std::string& format = {});

/// Writes a whole film, some frames at a time; false where `progress`, called with the share that is written, stopped
/// it.
bool write_film(const std::filesystem::path& path, FilmSource& film, const std::string& format = {},
                const std::function<bool(double share)>& progress = {});

/// The load's signal that a camera writes into the first line of a lock-in film (.ptw): one number a frame. Empty for
/// any other file, and for a line in which nothing changes.
std::vector<double> lock_in_line(const std::filesystem::path& film);

/// What the stamps or numbers of a film's frames say.
struct FrameIntervals {
  double interval = 0;            ///< the median time between two frames, s; 1/frame_rate without stamps, 0 if unknown
  double duration = 0;            ///< from the first to the last frame, s; 0 if unknown
  std::int64_t dropped = 0;       ///< frames that are missing where two are further apart than others are
  std::vector<std::int64_t> gap;  ///< frames before which some are missing
};
FrameIntervals frame_intervals(const FilmInfo& info);

}  // namespace arenite::io
