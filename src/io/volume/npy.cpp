#include <string_view>

#include "io/disk/numpy_header.hpp"
#include "io/volume/numpy_array.hpp"

namespace arenite::io {

constinit const VolumeFormat volumes::npy{
    .name = "npy",
    .sentence = "NumPy (.npy)",
    .states = {{"shape", "used: slices (z) x rows (y) x columns (x)"},
               {"fortran_order, byte order", "used"},
               {"more numbers than the shape says", "left aside, and told"},
               {"type", "whole numbers and bool; floating numbers must be whole"}},
    .is = is_numpy_array,
    .open = [](const Bytes& bytes, const VolumeChoice&) { return open_numpy_array(bytes); }};

}  // namespace arenite::io
