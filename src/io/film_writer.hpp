#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "model/film.hpp"

namespace arenite::io {

/// A film that is written part by part and appears under its name when it is finished, or not at all.
class FilmWriter {
 public:
  virtual ~FilmWriter() = default;
  /// The next frames: levels, or values if the film is floating, of its size.
  virtual void append(const FrameBlock& block) = 0;
  virtual void finish() = 0;
};

/// Names of the formats that can be written: "tiff", "npy", "hdf5", "sfmov", "ptw".
std::vector<std::string> film_formats_to_write();

/// The format that a name's ending asks for (.tif, .tiff, .npy, .h5, .hdf5, .sfmov, .ptw); empty for any other.
std::string film_format_of(const std::filesystem::path& path);

/// A new film; the format of the name's ending unless another is given. `info` says size, kind of pixel and what the film
/// is to say about itself, so far as the format has a place for it; the number of frames is that of the frames appended,
/// and times must be there for as many. TIFF becomes BigTIFF from 4 GiB on. InputError where the format has no place for
/// such pixels (ptw is for levels), or the file cannot be written.
std::unique_ptr<FilmWriter> create_film(const std::filesystem::path& path, const FilmInfo& info, const std::string& format = {});

/// Writes a whole film, some frames at a time.
void write_film(const std::filesystem::path& path, FilmSource& film, const std::string& format = {});

}  // namespace arenite::io
