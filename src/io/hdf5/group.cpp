#include "io/hdf5/group.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <string>
#include <vector>

#include "core/problems.hpp"
#include "core/text.hpp"
#include "io/disk/store_file.hpp"
#include "io/hdf5/handle.hpp"

namespace arenite::io {
namespace {

constexpr std::size_t most_texts = std::size_t{1} << 28;  // bytes

std::string checked(const Hdf5Group& at, std::string text, const std::string& name) {
  text.resize(text.find_last_not_of('\0') + 1);  // padding
  if (!is_utf8(text)) at.refuse(fmt::format("holds a text \"{}\" that is damaged", name));
  return text;
}

Hdf5Handle open_set(const Hdf5Group& at, hid_t group, const std::string& name, const char* kind) {
  auto set = own(H5Dopen2(group, name.c_str(), H5P_DEFAULT), H5Dclose);
  if (!set) at.refuse(fmt::format("has no {} \"{}\"", kind, name));
  return set;
}

bool has_shape(hid_t set, int rank, hsize_t* size) {
  const auto space = own(H5Dget_space(set), H5Sclose);
  return space && H5Sget_simple_extent_ndims(*space) == rank && H5Sget_simple_extent_dims(*space, size, nullptr) >= 0;
}

template <class T> std::vector<T> read_values(const Hdf5Group& at, hid_t set, const std::string& name, hsize_t count) {
  std::vector<T> values(count);
  if (count > 0 && H5Dread(set, number_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
    at.refuse(fmt::format("holds an array \"{}\" that cannot be read", name));
  return values;
}

Hdf5Handle open_attribute(const Hdf5Group& at, hid_t owner, const std::string& name) {
  auto attribute = own(H5Aopen(owner, name.c_str(), H5P_DEFAULT), H5Aclose);
  if (!attribute) at.refuse(fmt::format("has no attribute \"{}\"", name));
  return attribute;
}

template <class T> void transfer_number(const Hdf5Group& at, hid_t owner, const std::string& name, T& value) {
  if (!at.reads()) return write_number(owner, name, value);
  const auto attribute = open_attribute(at, owner, name);
  const auto space = own(H5Aget_space(*attribute), H5Sclose);
  if (!space || H5Sget_simple_extent_npoints(*space) != 1 || H5Aread(*attribute, number_type<T>(), &value) < 0)
    at.refuse(fmt::format("has an attribute \"{}\" that is not one number", name));
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
  if (H5Aread(*attribute, *type, text.data()) < 0)
    at.refuse(fmt::format("has an attribute \"{}\" that cannot be read", name));
  return checked(at, std::move(text), name);
}

/// Cells of fixed length of the texts of a dataset: one, or a list of them.
struct Cells {
  std::string bytes;
  std::size_t length = 1;
};
Cells read_cells(const Hdf5Group& at, hid_t group, const std::string& name, bool one) {
  const auto set = open_set(at, group, name, one ? "text" : "texts");
  const auto type = own(H5Dget_type(*set), H5Tclose);
  Cells cells{{}, text_length(at, type, name)};
  hsize_t count = 1;
  if (!has_shape(*set, one ? 0 : 1, &count) || count > most_texts / cells.length)
    at.refuse(fmt::format("holds \"{}\", which is not {}", name, one ? "one text" : "a list of texts"));
  cells.bytes.assign(count * cells.length, '\0');
  if (count > 0 && H5Dread(*set, *type, H5S_ALL, H5S_ALL, H5P_DEFAULT, cells.bytes.data()) < 0)
    at.refuse(fmt::format("holds a text \"{}\" that cannot be read", name));
  return cells;
}

Hdf5Handle dataset_properties(hsize_t bytes, hsize_t count, bool compress) {
  constexpr hsize_t worth_it = 4096, largest_chunk = 131'072;
  auto properties = timeless(H5P_DATASET_CREATE);
  if (compress && bytes >= worth_it) pack(*properties, {std::min(count, largest_chunk)}, true, 2);
  return properties;
}

template <class Info, class Iterate>
std::vector<std::string> listed(const Hdf5Group& at, hid_t group, Iterate iterate) {
  std::vector<std::string> found;
  const auto note = [](hid_t, const char* name, const Info*, void* into) -> herr_t {
    static_cast<std::vector<std::string>*>(into)->emplace_back(name);
    return 0;
  };
  const bool is_whole = iterate(group, H5_INDEX_CRT_ORDER, H5_ITER_INC, nullptr, note, &found) >= 0;
  if (!is_whole || !std::all_of(found.begin(), found.end(), is_utf8)) at.refuse("cannot be listed");
  return found;
}

Hdf5Handle open_root(std::string bytes, const std::string& file) {
  constexpr const char* refusal = "is not a readable HDF5 file; remove it and make it again with \"arenite run\"";
  const auto id = open_in_memory(std::move(bytes), file, refusal);
  auto root = own(H5Gopen2(*id, "/", H5P_DEFAULT), H5Gclose);
  if (!root) refuse(file, refusal);
  return root;
}

Hdf5Handle new_root() {
  const auto access = memory_properties();
  const auto creation = timeless(H5P_FILE_CREATE);
  done(H5Pset_userblock(*creation, header_size));
  keep_order(*creation);
  const auto file = made(H5Fcreate(unused_name().c_str(), H5F_ACC_TRUNC, *creation, *access), H5Fclose);
  return made(H5Gopen2(*file, "/", H5P_DEFAULT), H5Gclose);
}

Hdf5Handle new_group(hid_t in, const std::string& name) {
  const auto properties = timeless(H5P_GROUP_CREATE);
  keep_order(*properties);
  return made(H5Gcreate2(in, name.c_str(), H5P_DEFAULT, *properties, H5P_DEFAULT), H5Gclose);
}

}  // namespace

Hdf5Group::Hdf5Group(bool compress) : turn_(std::make_shared<Hdf5Turn>()), id_(new_root()), compress_(compress) {}

Hdf5Group::Hdf5Group(std::string bytes, std::string file)
    : turn_(std::make_shared<Hdf5Turn>()),
      id_(open_root(std::move(bytes), file)),
      reads_(true),
      file_(std::move(file)) {}

Hdf5Group Hdf5Group::group(const std::string& name) const {
  Hdf5Group inner = *this;
  inner.id_ = reads_ ? own(H5Gopen2(*id_, name.c_str(), H5P_DEFAULT), H5Gclose) : new_group(*id_, name);
  if (!inner.id_) refuse(fmt::format("has no group \"{}\"", name));
  inner.place_ += "/" + name;
  return inner;
}

bool Hdf5Group::has(const std::string& name) const { return H5Lexists(*id_, name.c_str(), H5P_DEFAULT) > 0; }

bool Hdf5Group::has_group(const std::string& name) const {
  return has(name) && own(H5Gopen2(*id_, name.c_str(), H5P_DEFAULT), H5Gclose) != nullptr;
}

bool Hdf5Group::has_attribute(const std::string& name) const { return H5Aexists(*id_, name.c_str()) > 0; }

std::vector<std::string> Hdf5Group::names() const { return listed<H5L_info_t>(*this, *id_, H5Literate); }
std::vector<std::string> Hdf5Group::attribute_names() const { return listed<H5A_info_t>(*this, *id_, H5Aiterate2); }

std::string Hdf5Group::unit(const std::string& name) const {
  return read_text_attribute(*this, *open_set(*this, *id_, name, "array"), "unit");
}

void Hdf5Group::operator()(const std::string& name, double& value) const { transfer_number(*this, *id_, name, value); }
void Hdf5Group::integer(const std::string& name, std::int64_t& value) const {
  transfer_number(*this, *id_, name, value);
}
void Hdf5Group::seed(const std::string& name, std::uint64_t& value) const { transfer_number(*this, *id_, name, value); }

void Hdf5Group::operator()(const std::string& name, std::string& text) const {
  if (reads_) text = read_text_attribute(*this, *id_, name);
  else write_text(*id_, name, text);
}

void Hdf5Group::note(const std::string& name, std::string_view text) const {
  if (!reads_) write_text(*id_, name, text);
}

template <class T>
void Hdf5Group::array(const std::string& name, std::vector<T>& values, const std::string& unit) const {
  hsize_t count = values.size();
  if (reads_) {
    const auto set = open_set(*this, *id_, name, "array");
    if (!has_shape(*set, 1, &count)) refuse(fmt::format("holds \"{}\", which is not a one-dimensional array", name));
    values = read_values<T>(*this, *set, name, count);
  } else {
    const auto properties = dataset_properties(count * sizeof(T), count, compress_);
    write_text(*write_set(*id_, name, {count}, number_type<T>(), *properties, values.data()), "unit", unit);
  }
}
template void Hdf5Group::array(const std::string&, std::vector<double>&, const std::string&) const;
template void Hdf5Group::array(const std::string&, std::vector<std::int32_t>&, const std::string&) const;
template void Hdf5Group::array(const std::string&, std::vector<std::int64_t>&, const std::string&) const;
template void Hdf5Group::array(const std::string&, std::vector<std::uint8_t>&, const std::string&) const;

/// Written in chunks of some rows, lightly deflated: an image of a million nodes is written in a moment.
template <class T>
void Hdf5Group::image(const std::string& name, std::vector<T>& values, Shape shape, const std::string& unit) const {
  constexpr hsize_t values_per_chunk = 1 << 16;
  std::vector<hsize_t> size{static_cast<hsize_t>(shape.rows), static_cast<hsize_t>(shape.columns)};
  if (shape.layers > 0) size.insert(size.begin(), static_cast<hsize_t>(shape.layers));
  const hsize_t count = std::accumulate(size.begin(), size.end(), hsize_t{1}, std::multiplies<>());
  if constexpr (std::is_same_v<T, double>) {  // faster than HDF5's own conversion
    std::vector<float> single(values.begin(), values.end());
    image(name, single, shape, unit);
    if (reads_) values.assign(single.begin(), single.end());
  } else if (reads_) {
    const auto set = open_set(*this, *id_, name, "array");
    std::vector<hsize_t> found(size.size(), 0);
    if (!has_shape(*set, static_cast<int>(size.size()), found.data()) || found != size)
      refuse(fmt::format("holds \"{}\", which is not an array of {}{} rows and {} columns", name,
                         shape.layers > 0 ? fmt::format("{} layers, ", shape.layers) : "", shape.rows, shape.columns));
    values = read_values<T>(*this, *set, name, count);
  } else {
    const auto properties = timeless(H5P_DATASET_CREATE);
    if (compress_ && count > 0) {
      std::vector<hsize_t> chunk = size;
      chunk[chunk.size() - 2] = std::clamp<hsize_t>(values_per_chunk / size.back(), 1, chunk[chunk.size() - 2]);
      if (shape.layers > 0) chunk[0] = std::clamp<hsize_t>(values_per_chunk / (chunk[1] * chunk[2]), 1, size[0]);
      pack(*properties, chunk, sizeof(T) > 1, 1);
    }
    write_text(*write_set(*id_, name, size, number_type<T>(), *properties, values.data()), "unit", unit);
  }
}
template void Hdf5Group::image(const std::string&, std::vector<double>&, Shape, const std::string&) const;
template void Hdf5Group::image(const std::string&, std::vector<float>&, Shape, const std::string&) const;
template void Hdf5Group::image(const std::string&, std::vector<std::int32_t>&, Shape, const std::string&) const;
template void Hdf5Group::image(const std::string&, std::vector<std::uint8_t>&, Shape, const std::string&) const;

void Hdf5Group::text(const std::string& name, std::string& text) const {
  if (reads_) text = checked(*this, read_cells(*this, *id_, name, true).bytes, name);
  else write_set(*id_, name, {}, *text_type(text.size()), *timeless(H5P_DATASET_CREATE), text.c_str());
}

void Hdf5Group::texts(const std::string& name, std::vector<std::string>& texts) const {
  if (reads_) {
    const Cells cells = read_cells(*this, *id_, name, false);
    texts.clear();
    for (std::size_t at = 0; at < cells.bytes.size(); at += cells.length)
      texts.push_back(checked(*this, cells.bytes.substr(at, cells.length), name));
    return;
  }
  std::size_t length = 1;
  for (const auto& text : texts) length = std::max(length, text.size());
  std::string cells(length * texts.size(), '\0');
  for (std::size_t k = 0; k < texts.size(); ++k) texts[k].copy(cells.data() + k * length, length);
  write_set(*id_, name, {texts.size()}, *text_type(length), *dataset_properties(cells.size(), texts.size(), compress_),
            cells.data());
}

void Hdf5Group::refuse(const std::string& message) const {
  arenite::refuse(file_, "{} {}; remove the file and make it again with \"arenite run\"", place_.empty() ? "/" : place_,
                  message);
}

std::string Hdf5Group::bytes() const {
  const auto file = made(H5Iget_file_id(*id_), H5Fclose);
  return bytes_of_file(*file, header_size);
}

}  // namespace arenite::io
