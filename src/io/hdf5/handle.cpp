#include "io/hdf5/handle.hpp"
#include "core/problems.hpp"

#include <fmt/format.h>

#include <atomic>
#include <mutex>
#include <stdexcept>

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

Hdf5Handle without_lock() {
  memory_properties();  // silences HDF5's own messages
  auto access = made(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  done(H5Pset_file_locking(*access, false, true));
  return access;
}

std::string bytes_of_file(hid_t file, std::size_t before) {
  done(H5Fflush(file, H5F_SCOPE_GLOBAL));
  // An image that HDF5 copies for us lacks the user block and has a wrong checksum, so only its size is asked; the memory that the file lives in has
  // the block, and beyond the end of the file room to grow.
  void** memory = nullptr;
  const ssize_t size = H5Fget_file_image(file, nullptr, 0);
  done(H5Fget_vfd_handle(file, H5P_DEFAULT, reinterpret_cast<void**>(&memory)));
  done(size <= 0 ? -1 : 0);
  return {static_cast<const char*>(*memory), before + static_cast<std::size_t>(size)};
}

Hdf5Handle timeless(hid_t kind) {
  auto properties = made(H5Pcreate(kind), H5Pclose);
  done(H5Pset_obj_track_times(*properties, false));
  return properties;
}

void keep_order(hid_t properties) {
  done(H5Pset_link_creation_order(properties, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED));
  done(H5Pset_attr_creation_order(properties, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED));
}

void pack(hid_t properties, const std::vector<hsize_t>& chunk, bool shuffle, unsigned level) {
  done(H5Pset_chunk(properties, static_cast<int>(chunk.size()), chunk.data()));
  if (shuffle) done(H5Pset_shuffle(properties));
  done(H5Pset_deflate(properties, level));
}

Hdf5Handle write_set(hid_t group, const std::string& name, const std::vector<hsize_t>& size, hid_t type, hid_t properties, const void* values) {
  const auto space =
      size.empty() ? made(H5Screate(H5S_SCALAR), H5Sclose) : made(H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr), H5Sclose);
  auto set = made(H5Dcreate2(group, name.c_str(), type, *space, H5P_DEFAULT, properties, H5P_DEFAULT), H5Dclose);
  if (H5Sget_simple_extent_npoints(*space) > 0) done(H5Dwrite(*set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values));
  return set;
}

void write_attribute(hid_t owner, const std::string& name, hid_t type, const void* value) {
  const auto space = made(H5Screate(H5S_SCALAR), H5Sclose);
  const auto attribute = made(H5Acreate2(owner, name.c_str(), type, *space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  done(H5Awrite(*attribute, type, value));
}

std::string unused_name() {
  static std::atomic<int> count{0};
  return fmt::format("arenite in memory {}", ++count);
}

Hdf5Handle open_in_memory(std::string bytes, const std::string& file, const char* refusal) {
  Hdf5Handle id;
  const auto access = memory_properties();
  if (!bytes.empty()) {
    done(H5Pset_libver_bounds(*access, H5F_LIBVER_EARLIEST, H5F_LIBVER_LATEST));  // whoever wrote it
    done(H5Pset_file_image(*access, bytes.data(), bytes.size()));
    bytes = {};  // HDF5 has copied them
    id = own(H5Fopen(unused_name().c_str(), H5F_ACC_RDONLY, *access), H5Fclose);
  }
  if (!id) refuse(file, "{}", refusal);
  return id;
}

}  // namespace arenite::io
