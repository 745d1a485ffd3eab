#pragma once
#include <hdf5.h>

#include <cstdint>
#include <string>
#include <vector>

#include "io/film/hdf5_facts.hpp"

namespace arenite::io {

/// All numbers of a dataset that has `count` of them in a line; empty without one.
std::vector<double> numbers_beside(hid_t file, const Bytes& bytes, const std::string& name, std::int64_t count);

/// What datasets beside the film, and attributes of it and of the file, state of each frame, one number a frame: times
/// and numbers of frames, by their names (stated_times.hpp); and sentences on what of it cannot be used.
void look_for_times(hid_t file, hid_t set, const Bytes& bytes, Hdf5Facts& facts);

}  // namespace arenite::io
