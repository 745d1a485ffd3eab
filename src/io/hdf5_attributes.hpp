#pragma once
#include <initializer_list>
#include <string>

#include "io/hdf5_handle.hpp"
#include "io/hdf5_numbers.hpp"

namespace arenite::io {

/// A plain number, or a text of this many bytes, that is there as a whole.
inline bool is_whole(hid_t attribute, std::size_t bytes) { return H5Aget_storage_size(attribute) == bytes; }

/// The first of these attributes that is one number.
inline double number_attribute(hid_t at, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    if (H5Aexists(at, name) <= 0) continue;
    const auto attribute = own(H5Aopen(at, name, H5P_DEFAULT), H5Aclose);
    const auto space = attribute ? own(H5Aget_space(*attribute), H5Sclose) : Hdf5Handle{};
    const auto type = attribute ? own(H5Aget_type(*attribute), H5Tclose) : Hdf5Handle{};
    double value = 0;
    if (!space || !type || !sample_of(*type).known || !is_whole(*attribute, bytes_of(sample_of(*type).sample))) continue;
    if (H5Sget_simple_extent_npoints(*space) == 1 && H5Aread(*attribute, H5T_NATIVE_DOUBLE, &value) >= 0 && value > 0) return value;
  }
  return 0;
}

/// An attribute that is a text of fixed length.
inline std::string text_attribute(hid_t at, const char* name) {
  if (H5Aexists(at, name) <= 0) return {};
  const auto attribute = own(H5Aopen(at, name, H5P_DEFAULT), H5Aclose);
  const auto type = attribute ? own(H5Aget_type(*attribute), H5Tclose) : Hdf5Handle{};
  const auto space = attribute ? own(H5Aget_space(*attribute), H5Sclose) : Hdf5Handle{};
  if (!type || !space || H5Tget_class(*type) != H5T_STRING || H5Tis_variable_str(*type) != 0 || H5Sget_simple_extent_npoints(*space) != 1) return {};
  const std::size_t size = H5Tget_size(*type);
  if (size == 0 || size > 65536 || !is_whole(*attribute, size)) return {};
  std::string text(size, '\0');
  if (H5Aread(*attribute, *type, text.data()) < 0) return {};
  return text.substr(0, text.find('\0'));
}

}  // namespace arenite::io
