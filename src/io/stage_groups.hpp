#pragma once
#include "io/hdf5_reader.hpp"
#include "io/hdf5_writer.hpp"
#include "model/result.hpp"

namespace arenite::io {

/// A stage's result as groups below `at`, and back: what stage files and checkpoints have in common. Reading throws
/// InputError where a group is incomplete or its indices point nowhere.
void write_result(const Hdf5Writer& at, const StageResult& result);
StageResult read_result(const Hdf5Reader& at);

}  // namespace arenite::io
