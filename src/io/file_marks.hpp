#pragma once
#include <string_view>

// Beginnings by which formats of pictures and of films alike are known.
namespace arenite::io {

/// TIFF and BigTIFF, of either byte order.
bool is_tiff(std::string_view head);

/// HDF5, before which 512, 1024, 2048 .. bytes of the user's may stand.
bool is_hdf5(std::string_view head);

}  // namespace arenite::io
