#pragma once
#include <hdf5.h>

#include <cstddef>
#include <string>
#include <vector>

#include "io/hdf5/handle.hpp"

namespace arenite::io {

/// The dimension scale of every axis of a dataset, the first where it has several; a null handle for an axis without.
std::vector<Hdf5Handle> scales_of_axes(hid_t set);

/// Names of a dataset's axes, in the order in which they are stored: HDF5's labels, or else the keys of vigra's and
/// ilastik's axistags, or else the names of their dimension scales, as netCDF and xarray write them. Empty for an axis
/// without one.
std::vector<std::string> names_of_axes(hid_t set);

/// Whether a dataset is a dimension of netCDF without values: only its length counts.
bool is_only_a_length(hid_t set);

/// Which stored axis is that of pictures (frames of a film, slices of a stack), of rows and of columns.
struct AxisOrder {
  std::vector<std::size_t> axis;  ///< pictures, rows, columns; without the first where there are two
  std::string remark;             ///< a sentence on what was turned or guessed; empty where nothing was
};

/// By the names of two or three axes, whatever their case: y, row, lat and the like are rows, x, column, lon columns,
/// time, frame, z and slice pictures. Names that are not known fill up what is left in the order in which they are
/// stored, and the remark says so. InputError where two axes are called the same thing.
AxisOrder order_by_names(const std::vector<std::string>& names, const std::string& file, const std::string& dataset);

}  // namespace arenite::io
