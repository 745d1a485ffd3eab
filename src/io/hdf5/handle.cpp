#include "io/hdf5/handle.hpp"
#include "core/mapped.hpp"
#include "core/problems.hpp"

#include <fmt/core.h>
#include <pthread.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <limits>
#include <mutex>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace arenite::io {
namespace {

/// Not a recursive mutex: a forked process has another thread number, and could not give back what it holds.
std::mutex speaking;
thread_local int turns = 0;

void take_turn() {
  if (turns == 0) speaking.lock();
}
void give_turn() {
  if (turns == 0) speaking.unlock();
}
[[maybe_unused]] const int at_fork = ::pthread_atfork(take_turn, give_turn, give_turn);

/// Null where there is no attribute of this name, or a damaged one.
struct Attribute {
  Hdf5Handle id, space, type;
  Attribute(hid_t at, const char* name) {
    if (H5Aexists(at, name) > 0) id = own(H5Aopen(at, name, H5P_DEFAULT), H5Aclose);
    if (id) space = own(H5Aget_space(*id), H5Sclose), type = own(H5Aget_type(*id), H5Tclose);
  }
  /// Of its values; 0 for more than `most`.
  std::size_t count(std::size_t most) const {
    const hssize_t values = space && type ? H5Sget_simple_extent_npoints(*space) : 0;
    return values > 0 && static_cast<std::size_t>(values) <= most ? static_cast<std::size_t>(values) : 0;
  }
};

constexpr std::size_t longest_text = 65536;

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

std::string bytes_of_file(hid_t file, std::size_t before) {
  done(H5Fflush(file, H5F_SCOPE_GLOBAL));
  // An image that HDF5 copies for us lacks the user block and has a wrong checksum, so only its size is asked; the
  // memory that the file lives in has the block, and beyond the end of the file room to grow.
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

Hdf5Handle write_set(hid_t group, const std::string& name, const std::vector<hsize_t>& size, hid_t type,
                     hid_t properties, const void* values) {
  const auto space = size.empty()
                         ? made(H5Screate(H5S_SCALAR), H5Sclose)
                         : made(H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr), H5Sclose);
  auto set = made(H5Dcreate2(group, name.c_str(), type, *space, H5P_DEFAULT, properties, H5P_DEFAULT), H5Dclose);
  if (H5Sget_simple_extent_npoints(*space) > 0) done(H5Dwrite(*set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values));
  return set;
}

void write_attribute(hid_t owner, const std::string& name, hid_t type, const void* value) {
  const auto space = made(H5Screate(H5S_SCALAR), H5Sclose);
  const auto attribute = made(H5Acreate2(owner, name.c_str(), type, *space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  done(H5Awrite(*attribute, type, value));
}

Hdf5Handle text_type(std::optional<std::size_t> length) {
  auto type = made(H5Tcopy(H5T_C_S1), H5Tclose);
  done(H5Tset_size(*type, length ? std::max<std::size_t>(1, *length) : H5T_VARIABLE));
  if (length) done(H5Tset_strpad(*type, H5T_STR_NULLPAD));
  done(H5Tset_cset(*type, H5T_CSET_UTF8));
  return type;
}

void write_text(hid_t owner, const std::string& name, std::string_view text) {
  write_attribute(owner, name, *text_type(text.size()), std::string(text).c_str());
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

std::vector<std::int64_t> shape_of(hid_t set) {
  const auto space = own(H5Dget_space(set), H5Sclose);
  const int rank = space ? H5Sget_simple_extent_ndims(*space) : 0;
  if (rank <= 0 || rank > H5S_MAX_RANK) return {};
  std::vector<hsize_t> shape(static_cast<std::size_t>(rank));
  H5Sget_simple_extent_dims(*space, shape.data(), nullptr);
  return mapped(shape, [](hsize_t n) {
    return static_cast<std::int64_t>(std::min<hsize_t>(n, std::numeric_limits<std::int64_t>::max()));
  });
}

std::optional<Hdf5Number> number_of(hid_t type) {
  using enum NumberType;
  const std::tuple<hid_t, hid_t, NumberType> known[] = {
      {H5T_STD_U8LE, H5T_STD_U8BE, u8},     {H5T_STD_I8LE, H5T_STD_I8BE, i8},    {H5T_STD_U16LE, H5T_STD_U16BE, u16},
      {H5T_STD_I16LE, H5T_STD_I16BE, i16},  {H5T_STD_U32LE, H5T_STD_U32BE, u32}, {H5T_STD_I32LE, H5T_STD_I32BE, i32},
      {H5T_STD_U64LE, H5T_STD_U64BE, u64},  {H5T_STD_I64LE, H5T_STD_I64BE, i64}, {H5T_IEEE_F32LE, H5T_IEEE_F32BE, f32},
      {H5T_IEEE_F64LE, H5T_IEEE_F64BE, f64}};
  const auto base = H5Tget_class(type) == H5T_ENUM ? own(H5Tget_super(type), H5Tclose) : nullptr;
  const hid_t it = base ? *base : type;
  for (const auto& [low_first, high_first, number] : known) {
    if (H5Tequal(it, low_first) > 0) return Hdf5Number{number, false};
    if (H5Tequal(it, high_first) > 0) return Hdf5Number{number, true};
  }
  return std::nullopt;
}

bool is_of_matlab(hid_t set) { return H5Aexists(set, "MATLAB_class") > 0; }

std::optional<double> stated_number(hid_t at, const char* name) {
  const StatedNumbers stated = stated_numbers(at, name);
  return stated.value.size() == 1 ? std::optional(stated.value.front()) : std::nullopt;
}

double number_attribute(hid_t at, std::initializer_list<const char*> names) {
  for (const char* name : names)
    if (const auto value = stated_number(at, name); value && *value > 0) return *value;
  return 0;
}

StatedNumbers stated_numbers(hid_t at, const char* name, std::size_t most) {
  const Attribute attribute(at, name);
  const std::size_t count = attribute.count(most);
  const auto number = count > 0 ? number_of(*attribute.type) : std::nullopt;
  if (!number || H5Aget_storage_size(*attribute.id) != count * bytes_of(number->type)) return {};
  StatedNumbers stated{std::vector<double>(count), number->type != NumberType::f32 && number->type != NumberType::f64};
  if (H5Aread(*attribute.id, H5T_NATIVE_DOUBLE, stated.value.data()) < 0) return {};
  return stated;
}

std::string text_attribute(hid_t at, const char* name) {
  std::vector<std::string> texts = texts_attribute(at, name);
  return texts.size() == 1 ? std::move(texts.front()) : std::string();
}

std::vector<std::string> texts_attribute(hid_t at, const char* name) {
  const Attribute attribute(at, name);
  const std::size_t count = attribute.count(most_listed);
  if (count == 0 || H5Tget_class(*attribute.type) != H5T_STRING) return {};
  std::vector<std::string> texts;
  if (H5Tis_variable_str(*attribute.type) > 0) {
    std::vector<char*> held(count, nullptr);
    if (H5Aread(*attribute.id, *attribute.type, held.data()) < 0) return {};
    for (char* text : held) {
      texts.emplace_back(text == nullptr ? "" : std::string(text, ::strnlen(text, longest_text)));
      H5free_memory(text);
    }
    return texts;
  }
  const std::size_t size = H5Tget_size(*attribute.type);
  if (size == 0 || size > longest_text || H5Aget_storage_size(*attribute.id) != count * size) return {};
  std::string all(count * size, '\0');
  if (H5Aread(*attribute.id, *attribute.type, all.data()) < 0) return {};
  for (std::size_t i = 0; i < count; ++i) texts.emplace_back(all.substr(i * size, size).c_str());
  return texts;
}

}  // namespace arenite::io
