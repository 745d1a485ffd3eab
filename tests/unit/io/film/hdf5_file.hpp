#pragma once
#include <hdf5.h>

#include <memory>
#include <string>
#include <vector>

#include "io/film/film.hpp"
#include "support/temporary_folder.hpp"

namespace arenite::io {

/// A file of HDF5's own making.
struct Hdf5File {
  test::TemporaryFolder folder;
  hid_t file = H5Fcreate((folder / "a.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);

  template <class T>
  hid_t write(const char* name, const std::vector<hsize_t>& shape, hid_t stored, hid_t type,
              const std::vector<T>& values) {
    const hid_t space = H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr);
    const hid_t set = H5Dcreate2(file, name, stored, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    if (!values.empty()) H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    H5Sclose(space);
    return set;
  }
  static void state(hid_t at, const char* name, hid_t type, const void* value) {
    const hid_t space = H5Screate(H5S_SCALAR), attribute = H5Acreate2(at, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(attribute, type, value);
    H5Aclose(attribute);
    H5Sclose(space);
  }
  static void state(hid_t at, const char* name, double value) { state(at, name, H5T_NATIVE_DOUBLE, &value); }
  /// Of any length, as h5py writes it.
  static void state(hid_t at, const char* name, const char* text) {
    const hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, H5T_VARIABLE);
    state(at, name, type, &text);
    H5Tclose(type);
  }
  /// Names of all axes, as h5py writes them.
  static void label(hid_t set, const std::vector<const char*>& names) {
    const hsize_t count = names.size();
    const hid_t type = H5Tcopy(H5T_C_S1), space = H5Screate_simple(1, &count, nullptr);
    H5Tset_size(type, H5T_VARIABLE);
    const hid_t attribute = H5Acreate2(set, "DIMENSION_LABELS", type, space, H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(attribute, type, names.data());
    H5Aclose(attribute), H5Sclose(space), H5Tclose(type);
  }
  /// A scale for each axis, of these names, as netCDF has them.
  void scale(hid_t set, const std::vector<std::string>& names) {
    const hsize_t count = names.size();
    const hid_t type = H5Tvlen_create(H5T_STD_REF_OBJ), space = H5Screate_simple(1, &count, nullptr);
    std::vector<hobj_ref_t> reference(count);
    std::vector<hvl_t> list;
    for (std::size_t axis = 0; axis < count; ++axis) {
      const hid_t of_axis = write<double>(names[axis].c_str(), {1}, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, {0});
      state(of_axis, "NAME", "This is a netCDF dimension but not a netCDF variable.         4");
      H5Dclose(of_axis);
      H5Rcreate(&reference[axis], file, names[axis].c_str(), H5R_OBJECT, -1);
      list.push_back({1, &reference[axis]});
    }
    const hid_t attribute = H5Acreate2(set, "DIMENSION_LIST", type, space, H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(attribute, type, list.data());
    H5Aclose(attribute), H5Sclose(space), H5Tclose(type);
  }
  std::unique_ptr<FilmSource> open() {
    H5Fclose(file);
    return open_film(folder / "a.h5");
  }
};

}  // namespace arenite::io
