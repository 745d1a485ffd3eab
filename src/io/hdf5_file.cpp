#include "io/hdf5_file.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>

#include "core/error.hpp"
#include "io/sealed_file.hpp"

namespace arenite::io {
namespace {

static_assert(sizeof(hid_t) == sizeof(std::int64_t));

using Close = herr_t (*)(hid_t);

/// Takes over what HDF5 returned; a null handle if the call failed. HDF5's own messages on stderr are silenced.
Hdf5Handle own(hid_t id, Close close) {
  if (id < 0) return nullptr;
  return {new std::int64_t(id), [close](const std::int64_t* held) {
            close(*held);
            delete held;
          }};
}

/// What we build in memory fails only for lack of it or by our own fault.
Hdf5Handle made(hid_t id, Close close) {
  if (id < 0) throw std::runtime_error("HDF5 refused to build a file in memory");
  return own(id, close);
}

void done(herr_t status) {
  if (status < 0) throw std::runtime_error("HDF5 refused to build a file in memory");
}

void silence() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

template <class T> hid_t stored_type();
template <> hid_t stored_type<double>() { return H5T_IEEE_F64LE; }
template <> hid_t stored_type<std::int32_t>() { return H5T_STD_I32LE; }
template <> hid_t stored_type<std::int64_t>() { return H5T_STD_I64LE; }
template <> hid_t stored_type<std::uint64_t>() { return H5T_STD_U64LE; }
template <> hid_t stored_type<std::uint8_t>() { return H5T_STD_U8LE; }
template <class T> hid_t native_type();
template <> hid_t native_type<double>() { return H5T_NATIVE_DOUBLE; }
template <> hid_t native_type<std::int32_t>() { return H5T_NATIVE_INT32; }
template <> hid_t native_type<std::int64_t>() { return H5T_NATIVE_INT64; }
template <> hid_t native_type<std::uint64_t>() { return H5T_NATIVE_UINT64; }
template <> hid_t native_type<std::uint8_t>() { return H5T_NATIVE_UINT8; }

/// UTF-8 text of fixed length; HDF5 knows none of length 0, so an empty one is one NUL, which reading drops.
Hdf5Handle text_type(std::size_t length) {
  auto type = made(H5Tcopy(H5T_C_S1), H5Tclose);
  done(H5Tset_size(*type, length == 0 ? 1 : length));
  done(H5Tset_strpad(*type, H5T_STR_NULLPAD));
  done(H5Tset_cset(*type, H5T_CSET_UTF8));
  return type;
}

std::string padded(std::string_view text) { return text.empty() ? std::string(1, '\0') : std::string(text); }

Hdf5Handle scalar() { return made(H5Screate(H5S_SCALAR), H5Sclose); }

/// Members keep the order in which they were written, and carry no time of writing.
Hdf5Handle group_properties() {
  auto properties = made(H5Pcreate(H5P_GROUP_CREATE), H5Pclose);
  done(H5Pset_obj_track_times(*properties, false));
  done(H5Pset_link_creation_order(*properties, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED));
  done(H5Pset_attr_creation_order(*properties, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED));
  return properties;
}

Hdf5Handle dataset_properties(hsize_t bytes, hsize_t count, bool compress) {
  constexpr hsize_t worth_it = 4096, largest_chunk = 131'072;
  auto properties = made(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  done(H5Pset_obj_track_times(*properties, false));
  if (!compress || bytes < worth_it) return properties;
  const hsize_t chunk = std::min(count, largest_chunk);
  done(H5Pset_chunk(*properties, 1, &chunk));
  done(H5Pset_shuffle(*properties));
  done(H5Pset_deflate(*properties, 2));
  return properties;
}

void write_attribute(hid_t owner, const std::string& name, hid_t stored, hid_t native, const void* value) {
  const auto space = scalar();
  const auto attribute = made(H5Acreate2(owner, name.c_str(), stored, *space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  done(H5Awrite(*attribute, native, value));
}

void write_text_attribute(hid_t owner, const std::string& name, std::string_view text) {
  const auto type = text_type(text.size());
  write_attribute(owner, name, *type, *type, padded(text).data());
}

template <class T>
void write_array(hid_t group, const std::string& name, const std::vector<T>& values, const std::string& unit, bool compress) {
  const hsize_t count = values.size();
  const auto space = made(H5Screate_simple(1, &count, nullptr), H5Sclose);
  const auto properties = dataset_properties(count * sizeof(T), count, compress);
  const auto set = made(H5Dcreate2(group, name.c_str(), stored_type<T>(), *space, H5P_DEFAULT, *properties, H5P_DEFAULT), H5Dclose);
  if (count > 0) done(H5Dwrite(*set, native_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
  write_text_attribute(*set, "unit", unit);
}

std::string without_padding(std::string text) {
  text.resize(text.find_last_not_of('\0') + 1);
  return text;
}

/// HDF5 takes two open files of one name for the same file, so each file in memory has a name of its own.
std::string unused_name() {
  static std::atomic<int> count{0};
  return fmt::format("arenite in memory {}", ++count);
}

Hdf5Handle memory_properties() {
  silence();
  auto properties = made(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  constexpr std::size_t growth = 1 << 20;
  done(H5Pset_fapl_core(*properties, growth, false));
  done(H5Pset_libver_bounds(*properties, H5F_LIBVER_V18, H5F_LIBVER_V18));
  return properties;
}

}  // namespace

Hdf5Group::Hdf5Group(Hdf5Handle id, std::string file, std::string place, bool compress)
    : id_(std::move(id)), file_(std::move(file)), place_(std::move(place)), compress_(compress) {}

Hdf5Group Hdf5Group::create_group(const std::string& name) const {
  auto id = made(H5Gcreate2(*id_, name.c_str(), H5P_DEFAULT, *group_properties(), H5P_DEFAULT), H5Gclose);
  return {std::move(id), file_, place_ + "/" + name, compress_};
}

void Hdf5Group::write(const std::string& name, const std::vector<double>& values, const std::string& unit) const {
  write_array(*id_, name, values, unit, compress_);
}
void Hdf5Group::write(const std::string& name, const std::vector<std::int32_t>& values, const std::string& unit) const {
  write_array(*id_, name, values, unit, compress_);
}
void Hdf5Group::write(const std::string& name, const std::vector<std::int64_t>& values, const std::string& unit) const {
  write_array(*id_, name, values, unit, compress_);
}
void Hdf5Group::write(const std::string& name, const std::vector<std::uint8_t>& values, const std::string& unit) const {
  write_array(*id_, name, values, unit, compress_);
}

void Hdf5Group::write_text(const std::string& name, std::string_view text) const {
  const auto type = text_type(text.size());
  const auto space = scalar();
  const auto properties = dataset_properties(0, 0, false);
  const auto set = made(H5Dcreate2(*id_, name.c_str(), *type, *space, H5P_DEFAULT, *properties, H5P_DEFAULT), H5Dclose);
  done(H5Dwrite(*set, *type, H5S_ALL, H5S_ALL, H5P_DEFAULT, padded(text).data()));
}

void Hdf5Group::set(const std::string& name, double value) const {
  write_attribute(*id_, name, stored_type<double>(), native_type<double>(), &value);
}
void Hdf5Group::set(const std::string& name, std::int64_t value) const {
  write_attribute(*id_, name, stored_type<std::int64_t>(), native_type<std::int64_t>(), &value);
}
void Hdf5Group::set(const std::string& name, std::uint64_t value) const {
  write_attribute(*id_, name, stored_type<std::uint64_t>(), native_type<std::uint64_t>(), &value);
}
void Hdf5Group::set(const std::string& name, std::string_view text) const { write_text_attribute(*id_, name, text); }

bool Hdf5Group::has(const std::string& name) const { return H5Lexists(*id_, name.c_str(), H5P_DEFAULT) > 0; }

Hdf5Group Hdf5Group::group(const std::string& name) const {
  auto id = own(H5Gopen2(*id_, name.c_str(), H5P_DEFAULT), H5Gclose);
  if (!id) refuse(fmt::format("has no group \"{}\"", name));
  return {std::move(id), file_, place_ + "/" + name};
}

std::vector<std::string> Hdf5Group::names() const {
  std::vector<std::string> found;
  const auto note = [](hid_t, const char* name, const H5L_info_t*, void* into) -> herr_t {
    static_cast<std::vector<std::string>*>(into)->emplace_back(name);
    return 0;
  };
  if (H5Literate(*id_, H5_INDEX_CRT_ORDER, H5_ITER_INC, nullptr, note, &found) < 0) refuse("cannot be listed");
  return found;
}

std::vector<std::string> Hdf5Group::attribute_names() const {
  std::vector<std::string> found;
  const auto note = [](hid_t, const char* name, const H5A_info_t*, void* into) -> herr_t {
    static_cast<std::vector<std::string>*>(into)->emplace_back(name);
    return 0;
  };
  if (H5Aiterate2(*id_, H5_INDEX_CRT_ORDER, H5_ITER_INC, nullptr, note, &found) < 0) refuse("cannot be listed");
  return found;
}

namespace {

template <class T>
std::vector<T> read_array(const Hdf5Group& at, hid_t group, const std::string& name) {
  const auto set = own(H5Dopen2(group, name.c_str(), H5P_DEFAULT), H5Dclose);
  if (!set) at.refuse(fmt::format("has no array \"{}\"", name));
  const auto space = own(H5Dget_space(*set), H5Sclose);
  hsize_t count = 0;
  if (!space || H5Sget_simple_extent_ndims(*space) != 1 || H5Sget_simple_extent_dims(*space, &count, nullptr) < 0)
    at.refuse(fmt::format("holds \"{}\", which is not a one-dimensional array", name));
  std::vector<T> values(count);
  if (count > 0 && H5Dread(*set, native_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
    at.refuse(fmt::format("holds an array \"{}\" that cannot be read", name));
  return values;
}

Hdf5Handle open_attribute(const Hdf5Group& at, hid_t owner, const std::string& name) {
  auto attribute = own(H5Aopen(owner, name.c_str(), H5P_DEFAULT), H5Aclose);
  if (!attribute) at.refuse(fmt::format("has no attribute \"{}\"", name));
  return attribute;
}

template <class T>
T read_number(const Hdf5Group& at, hid_t owner, const std::string& name) {
  const auto attribute = open_attribute(at, owner, name);
  const auto space = own(H5Aget_space(*attribute), H5Sclose);
  T value{};
  if (!space || H5Sget_simple_extent_npoints(*space) != 1 || H5Aread(*attribute, native_type<T>(), &value) < 0)
    at.refuse(fmt::format("has an attribute \"{}\" that is not one number", name));
  return value;
}

/// Length of a fixed-length text type; refuses any other type.
std::size_t text_length(const Hdf5Group& at, const Hdf5Handle& type, const std::string& name) {
  if (!type || H5Tget_class(*type) != H5T_STRING || H5Tis_variable_str(*type) != 0)
    at.refuse(fmt::format("holds \"{}\", which is not text", name));
  return H5Tget_size(*type);
}

std::string read_text_attribute(const Hdf5Group& at, hid_t owner, const std::string& name) {
  const auto attribute = open_attribute(at, owner, name);
  const auto type = own(H5Aget_type(*attribute), H5Tclose);
  std::string text(text_length(at, type, name), '\0');
  if (H5Aread(*attribute, *type, text.data()) < 0) at.refuse(fmt::format("has an attribute \"{}\" that cannot be read", name));
  return without_padding(std::move(text));
}

}  // namespace

std::vector<double> Hdf5Group::doubles(const std::string& name) const { return read_array<double>(*this, *id_, name); }
std::vector<std::int32_t> Hdf5Group::int32s(const std::string& name) const { return read_array<std::int32_t>(*this, *id_, name); }
std::vector<std::int64_t> Hdf5Group::int64s(const std::string& name) const { return read_array<std::int64_t>(*this, *id_, name); }
std::vector<std::uint8_t> Hdf5Group::bytes(const std::string& name) const { return read_array<std::uint8_t>(*this, *id_, name); }

std::string Hdf5Group::unit(const std::string& name) const {
  const auto set = own(H5Dopen2(*id_, name.c_str(), H5P_DEFAULT), H5Dclose);
  if (!set) refuse(fmt::format("has no array \"{}\"", name));
  return read_text_attribute(*this, *set, "unit");
}

std::string Hdf5Group::text(const std::string& name) const {
  const auto set = own(H5Dopen2(*id_, name.c_str(), H5P_DEFAULT), H5Dclose);
  if (!set) refuse(fmt::format("has no text \"{}\"", name));
  const auto type = own(H5Dget_type(*set), H5Tclose);
  std::string text(text_length(*this, type, name), '\0');
  if (H5Dread(*set, *type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()) < 0)
    refuse(fmt::format("holds a text \"{}\" that cannot be read", name));
  return without_padding(std::move(text));
}

double Hdf5Group::number(const std::string& name) const { return read_number<double>(*this, *id_, name); }
std::int64_t Hdf5Group::integer(const std::string& name) const { return read_number<std::int64_t>(*this, *id_, name); }
std::uint64_t Hdf5Group::natural(const std::string& name) const { return read_number<std::uint64_t>(*this, *id_, name); }
std::string Hdf5Group::label(const std::string& name) const { return read_text_attribute(*this, *id_, name); }

void Hdf5Group::refuse(const std::string& message) const {
  throw InputError(file_, 0, fmt::format("{} {}; make the file again with \"arenite run\"", place_.empty() ? "/" : place_, message));
}

Hdf5Builder::Hdf5Builder(bool compress) : compress_(compress) {
  const auto access = memory_properties();
  const auto creation = made(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  done(H5Pset_userblock(*creation, seal_size));
  done(H5Pset_obj_track_times(*creation, false));
  done(H5Pset_link_creation_order(*creation, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED));
  done(H5Pset_attr_creation_order(*creation, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED));
  id_ = made(H5Fcreate(unused_name().c_str(), H5F_ACC_TRUNC, *creation, *access), H5Fclose);
}

Hdf5Group Hdf5Builder::root() const {
  return {made(H5Gopen2(*id_, "/", H5P_DEFAULT), H5Gclose), "in memory", "", compress_};
}

std::string Hdf5Builder::bytes() const {
  done(H5Fflush(*id_, H5F_SCOPE_GLOBAL));
  // An image that HDF5 copies for us lacks the user block, so only its size is asked; the memory that the file lives in
  // has the block, and beyond the end of the file room to grow.
  void** memory = nullptr;
  const ssize_t size = H5Fget_file_image(*id_, nullptr, 0);
  done(H5Fget_vfd_handle(*id_, H5P_DEFAULT, reinterpret_cast<void**>(&memory)));
  if (size <= 0) throw std::runtime_error("HDF5 refused to build a file in memory");
  return {static_cast<const char*>(*memory), seal_size + static_cast<std::size_t>(size)};
}

Hdf5Group open_hdf5(std::string bytes, const std::string& file) {
  const auto access = memory_properties();
  done(H5Pset_file_image(*access, bytes.data(), bytes.size()));
  bytes.clear();
  const auto id = own(H5Fopen(unused_name().c_str(), H5F_ACC_RDONLY, *access), H5Fclose);
  auto root = id ? own(H5Gopen2(*id, "/", H5P_DEFAULT), H5Gclose) : nullptr;
  if (!root) throw InputError(file, 0, "is not a readable HDF5 file; make it again with \"arenite run\"");
  return {std::move(root), file, ""};
}

}  // namespace arenite::io
