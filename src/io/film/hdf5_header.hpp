#pragma once
#include <cstddef>
#include <string>

#include "model/film.hpp"

namespace arenite::io {

/// All of a film but its frames, which follow in one piece. HDF5 makes it in memory, with no times stored, so that the
/// same film gives the same bytes; it never writes to the disk itself, since it cannot be left in peace once a disk is
/// full.
std::string hdf5_header(const FilmInfo& info, std::size_t frames);

}  // namespace arenite::io
