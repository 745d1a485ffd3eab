#pragma once
#include <string>
#include <vector>

#include "io/hdf5_handle.hpp"

// What is asked of HDF5 files of other programs, whether they hold a picture or a film.
namespace arenite::io {

/// A file in memory; `file` names it in the InputError of one that is damaged.
Hdf5Handle open_foreign(std::string bytes, const std::string& file);

/// Lengths of a dataset's axes; empty for one without.
std::vector<std::int64_t> shape_of(hid_t set);

/// Names of the datasets that `fits` takes, in rising order.
std::vector<std::string> datasets_in(hid_t file, bool (*fits)(hid_t set));

}  // namespace arenite::io
