#pragma once
#include <hdf5.h>

#include <string>
#include <vector>

namespace arenite::io {

/// Names of the datasets of an open file that `fits` takes, in rising order, in groups that are nested at most 64 deep.
std::vector<std::string> datasets_in(hid_t file, bool (*fits)(hid_t set));

}  // namespace arenite::io
