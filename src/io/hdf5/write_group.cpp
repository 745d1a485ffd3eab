#include "io/hdf5/group.hpp"

#include <algorithm>

#include "io/disk/store_file.hpp"
#include "io/hdf5/handle.hpp"

namespace arenite::io {
namespace {

/// UTF-8 text of fixed length; HDF5 knows none of length 0, so an empty one is one NUL, which reading drops.
Hdf5Handle text_type(std::size_t length) {
  auto type = made(H5Tcopy(H5T_C_S1), H5Tclose);
  done(H5Tset_size(*type, length == 0 ? 1 : length));
  done(H5Tset_strpad(*type, H5T_STR_NULLPAD));
  done(H5Tset_cset(*type, H5T_CSET_UTF8));
  return type;
}

std::string padded(std::string_view text) { return text.empty() ? std::string(1, '\0') : std::string(text); }

/// Members keep the order in which they were written, and carry no time of writing.
Hdf5Handle group_properties() {
  auto properties = timeless(H5P_GROUP_CREATE);
  keep_order(*properties);
  return properties;
}

Hdf5Handle dataset_properties(hsize_t bytes, hsize_t count, bool compress) {
  constexpr hsize_t worth_it = 4096, largest_chunk = 131'072;
  auto properties = timeless(H5P_DATASET_CREATE);
  if (!compress || bytes < worth_it) return properties;
  pack(*properties, {std::min(count, largest_chunk)}, true, 2);
  return properties;
}

void write_text_attribute(hid_t owner, const std::string& name, std::string_view text) {
  const auto type = text_type(text.size());
  write_attribute(owner, name, *type, *type, padded(text).data());
}

/// The file; it stays open as long as a group of it is.
Hdf5Handle new_root() {
  const auto access = memory_properties();
  const auto creation = timeless(H5P_FILE_CREATE);
  done(H5Pset_userblock(*creation, header_size));
  keep_order(*creation);
  const auto file = made(H5Fcreate(unused_name().c_str(), H5F_ACC_TRUNC, *creation, *access), H5Fclose);
  return made(H5Gopen2(*file, "/", H5P_DEFAULT), H5Gclose);
}

}  // namespace

Hdf5Writer::Hdf5Writer(bool compress) : turn_(std::make_shared<Hdf5Turn>()), id_(new_root()), compress_(compress) {}

Hdf5Writer::Hdf5Writer(Turn turn, Handle group, bool compress) : turn_(std::move(turn)), id_(std::move(group)), compress_(compress) {}

Hdf5Writer Hdf5Writer::create_group(const std::string& name) const {
  auto id = made(H5Gcreate2(*id_, name.c_str(), H5P_DEFAULT, *group_properties(), H5P_DEFAULT), H5Gclose);
  return {turn_, std::move(id), compress_};
}

template <class T> void Hdf5Writer::write(const std::string& name, const std::vector<T>& values, const std::string& unit) const {
  const hsize_t count = values.size();
  const auto properties = dataset_properties(count * sizeof(T), count, compress_);
  write_text_attribute(*write_set(*id_, name, {count}, stored_type<T>(), native_type<T>(), *properties, values.data()), "unit", unit);
}
template void Hdf5Writer::write(const std::string&, const std::vector<double>&, const std::string&) const;
template void Hdf5Writer::write(const std::string&, const std::vector<std::int32_t>&, const std::string&) const;
template void Hdf5Writer::write(const std::string&, const std::vector<std::int64_t>&, const std::string&) const;
template void Hdf5Writer::write(const std::string&, const std::vector<std::uint8_t>&, const std::string&) const;

/// Chunks of some rows, lightly deflated: an image of a million nodes is written in a moment.
template <class T> void Hdf5Writer::write_image(const std::string& name, const std::vector<T>& values, Shape shape, const std::string& unit) const {
  if constexpr (std::is_same_v<T, double>)  // faster than HDF5's own conversion
    return write_image(name, std::vector<float>(values.begin(), values.end()), shape, unit);
  constexpr hsize_t values_per_chunk = 1 << 16;
  const auto rows = static_cast<hsize_t>(shape.rows), columns = static_cast<hsize_t>(shape.columns);
  const auto properties = timeless(H5P_DATASET_CREATE);
  if (compress_ && rows * columns > 0) pack(*properties, {std::clamp<hsize_t>(values_per_chunk / columns, 1, rows), columns}, sizeof(T) > 1, 1);
  write_text_attribute(*write_set(*id_, name, {rows, columns}, stored_type<T>(), native_type<T>(), *properties, values.data()), "unit", unit);
}
template void Hdf5Writer::write_image(const std::string&, const std::vector<double>&, Shape, const std::string&) const;
template void Hdf5Writer::write_image(const std::string&, const std::vector<float>&, Shape, const std::string&) const;
template void Hdf5Writer::write_image(const std::string&, const std::vector<std::int32_t>&, Shape, const std::string&) const;
template void Hdf5Writer::write_image(const std::string&, const std::vector<std::uint8_t>&, Shape, const std::string&) const;

void Hdf5Writer::write_text(const std::string& name, std::string_view text) const {
  const auto type = text_type(text.size());
  write_set(*id_, name, {}, *type, *type, *timeless(H5P_DATASET_CREATE), padded(text).data());
}

void Hdf5Writer::write_texts(const std::string& name, const std::vector<std::string>& texts) const {
  std::size_t length = 1;
  for (const auto& text : texts) length = std::max(length, text.size());
  std::string cells(length * texts.size(), '\0');
  for (std::size_t k = 0; k < texts.size(); ++k) texts[k].copy(cells.data() + k * length, length);
  const hsize_t count = texts.size();
  const auto type = text_type(length);
  write_set(*id_, name, {count}, *type, *type, *dataset_properties(cells.size(), count, compress_), cells.data());
}

void Hdf5Writer::set(const std::string& name, double value) const { write_number(*id_, name, value); }
void Hdf5Writer::set(const std::string& name, std::int64_t value) const { write_number(*id_, name, value); }
void Hdf5Writer::set(const std::string& name, std::uint64_t value) const { write_number(*id_, name, value); }
void Hdf5Writer::set(const std::string& name, std::string_view text) const { write_text_attribute(*id_, name, text); }

std::string Hdf5Writer::bytes() const {
  const auto file = made(H5Iget_file_id(*id_), H5Fclose);
  return bytes_of_file(*file, header_size);
}

}  // namespace arenite::io
