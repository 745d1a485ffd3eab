#include "io/hdf5_handle.hpp"

#include <fmt/format.h>

#include <atomic>
#include <mutex>
#include <stdexcept>

#include "io/hdf5_turn.hpp"

namespace arenite::io {
namespace {

/// Not a recursive mutex: a forked process has another thread number, and could not give back what it holds.
std::mutex speaking;
thread_local int turns = 0;

}  // namespace

Hdf5Turn::Hdf5Turn() {
  if (turns++ == 0) speaking.lock();
}

Hdf5Turn::~Hdf5Turn() {
  if (--turns == 0) speaking.unlock();
}

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

void prepare_hdf5() {
  const Hdf5Turn turn;
  H5open();
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
