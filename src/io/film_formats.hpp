#pragma once
#include <memory>
#include <string_view>

#include "io/film.hpp"

// One a format, each in a file of its name; the list is in film.cpp. `head` is the beginning of the file.
namespace arenite::io {

using FilmPointer = std::unique_ptr<FilmSource>;

/// Cedip/FLIR: a main header, then frames with headers of their own, whose stamps give the times. A lock-in film holds
/// the lock-in signal in the first line of its frames, which is left out.
bool is_ptw(std::string_view head);
FilmPointer open_ptw(const Bytes& bytes, const FilmChoice& choice);

/// FLIR ResearchIR: lines "key value", the word DATA, then frames.
bool is_sfmov(std::string_view head);
FilmPointer open_sfmov(const Bytes& bytes, const FilmChoice& choice);

/// Telops: every frame with a header that begins with "TC" and says size, scale and time.
bool is_hcc(std::string_view head);
FilmPointer open_hcc(const Bytes& bytes, const FilmChoice& choice);

/// NumPy: frames x height x width (or one frame), numbers of 1 to 8 bytes.
bool is_npy(std::string_view head);
FilmPointer open_npy(const Bytes& bytes, const FilmChoice& choice);

/// TIFF and BigTIFF: a page a frame, grey, 8 or 16 bits or floating.
FilmPointer open_tiff_film(const Bytes& bytes, const FilmChoice& choice);

/// HDF5: a dataset of frames x height x width, perhaps with times beside it and attributes.
FilmPointer open_hdf5_film(const Bytes& bytes, const FilmChoice& choice);

/// Raw frames, described by a text of lines "key = value" beside them, without sections: a film's recipe is none.
bool is_sidecar(std::string_view head);
FilmPointer open_sidecar(const Bytes& bytes, const FilmChoice& choice);

/// Numbers as text, a line a row; frames are parted by empty lines or lines that are no numbers.
bool is_text_film(std::string_view head);
FilmPointer open_text_film(const Bytes& bytes, const FilmChoice& choice);

/// A film whose numbers are told to be temperatures, if the choice says so; the film itself otherwise.
FilmPointer scaled_film(FilmPointer film, const FilmChoice& choice);

/// Files of one frame or more each, one after the other; a file is opened when its frames are read.
FilmPointer open_series(const std::filesystem::path& pattern, const FilmChoice& choice);

}  // namespace arenite::io
