#pragma once
#include <string>

#include "io/hdf5_reader.hpp"
#include "io/hdf5_writer.hpp"
#include "statistics/numbers.hpp"

/// A tree of numbers as a table in a group: a row a node, parents before what they hold, with `name` (path with dots), `depth`,
/// `kind` (Numbers::Kind), `value` (NaN where it is no number) and `text`.
namespace arenite::io {

void write_numbers(const Hdf5Writer& at, const std::string& name, const Numbers& numbers);

/// Also what version 0.1 wrote, which was JSON. Throws InputError for what is damaged.
Numbers read_numbers(const Hdf5Reader& at, const std::string& name);

}  // namespace arenite::io
