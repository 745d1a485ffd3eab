#include "io/hdf5_handle.hpp"

#include <fmt/format.h>

#include <atomic>
#include <stdexcept>

namespace arenite::io {

Hdf5Handle own(hid_t id, herr_t (*close)(hid_t)) {
  if (id < 0) return nullptr;
  return {new std::int64_t(id), [close](const std::int64_t* held) {
            close(*held);
            delete held;
          }};
}

Hdf5Handle made(hid_t id, herr_t (*close)(hid_t)) {
  done(id < 0 ? -1 : 0);
  return own(id, close);
}

void done(herr_t status) {
  if (status < 0) throw std::runtime_error("HDF5 refused to build a file in memory");
}

Hdf5Handle memory_properties() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  auto properties = made(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  constexpr std::size_t growth = 1 << 20;
  done(H5Pset_fapl_core(*properties, growth, false));
  done(H5Pset_libver_bounds(*properties, H5F_LIBVER_V18, H5F_LIBVER_V18));
  return properties;
}

std::string unused_name() {
  static std::atomic<int> count{0};
  return fmt::format("arenite in memory {}", ++count);
}

}  // namespace arenite::io
