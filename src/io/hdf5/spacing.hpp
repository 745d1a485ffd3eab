#pragma once
#include <string>
#include <vector>

#include "io/disk/byte_source.hpp"

namespace arenite::io {

/// Which dataset of an HDF5 file is asked about.
struct SpacingOf {
  std::string dataset = {};  ///< empty: the only one that can be meant
  bool is_stack = false;     ///< of three dimensions, all of which count; otherwise one picture, or one of a stack
};

/// What an HDF5 file states of the way from number to number of a dataset.
struct StatedSpacing {
  std::vector<double> side = {0, 0, 0};  ///< from picture to picture, row to row and column to column, m; 0: not stated
  std::string by;                        ///< the words that state it, or that were not understood; empty: none
};

/// By an attribute of the dataset, element_size_um (ImageJ's and Fiji's plugin) and its like in other units and words,
/// or by coordinates at equal distances with a unit of length (dimension scales of netCDF and xarray). Nothing where
/// the file is damaged or does not have the dataset: what reads its numbers says so.
StatedSpacing stated_spacing(const Bytes& bytes, const SpacingOf& of);

}  // namespace arenite::io
