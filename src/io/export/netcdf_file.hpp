#pragma once
#include <hdf5_hl.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/mapped.hpp"
#include "io/hdf5/handle.hpp"

namespace arenite::io {

/// A netCDF-4 file in memory, which is HDF5 whose dimensions are named.
class NetcdfFile {
 public:
  NetcdfFile() {
    const auto access = memory_properties(), creation = timeless(H5P_FILE_CREATE);
    done(H5Pset_link_creation_order(*creation, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED));
    file_ = made(H5Fcreate(unused_name().c_str(), H5F_ACC_TRUNC, *creation, *access), H5Fclose);
  }

  struct About {
    std::string units, long_name;
  };

  /// A dimension with its coordinate.
  template <class T> void dimension(const std::string& name, const std::vector<T>& values, const About& about) {
    const auto set = put(name, {name}, values, about);
    done(H5DSset_scale(*set, name.c_str()));
    scale_[name] = set;
  }

  /// An array over dimensions that are there.
  template <class T>
  void variable(const std::string& name, const std::vector<std::string>& dimensions, const std::vector<T>& values,
                const About& about) {
    const auto set = put(name, dimensions, values, about);
    for (std::size_t d = 0; d < dimensions.size(); ++d)
      done(H5DSattach_scale(*set, *scale_.at(dimensions[d]), static_cast<unsigned>(d)));
  }

  void variable(const std::string& name, const std::string& dimension, const std::vector<std::string>& values,
                const About& about) {
    auto texts = mapped(values, [](const auto& value) { return value.c_str(); });
    const auto type = text_type(std::nullopt), set = put(name, {dimension}, *type, texts.size(), false, texts.data());
    attribute(*set, "long_name", about.long_name);
    done(H5DSattach_scale(*set, *scale_.at(dimension), 0));
  }

  void attribute(const std::string& name, const std::string& text) const { attribute(*file_, name, text); }
  void attribute(const std::string& name, double value) const { write_number(*file_, name, value); }

  std::string bytes() const { return bytes_of_file(*file_); }

 private:
  static void attribute(hid_t owner, const std::string& name, const std::string& text) {
    const auto type = text_type(std::nullopt);
    const char* pointer = text.c_str();
    write_attribute(owner, name, *type, static_cast<const void*>(&pointer));
  }

  Hdf5Handle put(const std::string& name, const std::vector<std::string>& dimensions, hid_t type, std::size_t count,
                 bool compress, const void* values) {
    const auto size = mapped<hsize_t>(dimensions, [&](const auto& d) { return d == name ? count : size_.at(d); });
    if (dimensions.front() == name) size_[name] = count;
    const auto properties = timeless(H5P_DATASET_CREATE);
    done(H5Pset_attr_creation_order(*properties, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED));
    if (compress && count * 8 >= 4096) {
      std::vector<hsize_t> chunk = size;
      chunk.back() = std::min<hsize_t>(chunk.back(), 131'072);
      if (chunk.size() > 1) chunk.front() = std::clamp<hsize_t>(131'072 / chunk.back(), 1, chunk.front());
      pack(*properties, chunk, true, 2);
    }
    return write_set(*file_, name, size, type, *properties, values);
  }

  template <class T>
  Hdf5Handle put(const std::string& name, const std::vector<std::string>& dimensions, const std::vector<T>& values,
                 const About& about) {
    const auto set = put(name, dimensions, number_type<T>(), values.size(), true, values.data());
    if (!about.units.empty()) attribute(*set, "units", about.units);
    if (!about.long_name.empty()) attribute(*set, "long_name", about.long_name);
    return set;
  }

  Hdf5Handle file_;
  std::map<std::string, Hdf5Handle> scale_;
  std::map<std::string, hsize_t> size_;
};

}  // namespace arenite::io
