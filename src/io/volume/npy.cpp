#include "io/volume/numpy_array.hpp"

#include <string_view>

namespace arenite::io {

constinit const VolumeFormat volumes::npy{
    .name = "npy",
    .sentence = "NumPy (.npy)",
    .states = {{"shape", "used: slices (z) x rows (y) x columns (x)"},
               {"fortran_order, byte order", "used"},
               {"type", "whole numbers and bool; floating numbers must be whole"}},
    .is = [](std::string_view head) { return head.starts_with("\x93NUMPY"); },
    .open = [](const Bytes& bytes, const VolumeChoice&) { return open_numpy_array(bytes); }};

}  // namespace arenite::io
