#include "io/hdf5/group.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/hdf5/handle.hpp"
#include "statistics/numbers.hpp"

namespace arenite::io {
namespace {

constexpr std::size_t most_texts = std::size_t{1} << 28;  // bytes

std::string without_padding(std::string text) {
  text.resize(text.find_last_not_of('\0') + 1);
  return text;
}

/// A quoted text is JSON if it is UTF-8; what else a text may hold is written for the check as a blank.
bool is_utf8(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == '"' || c == '\\') c = ' ';
  return from_json('"' + text + '"').has_value();
}

std::string checked(const Hdf5Reader& at, std::string text, const std::string& name) {
  text = without_padding(std::move(text));
  if (!is_utf8(text)) at.refuse(fmt::format("holds a text \"{}\" that is damaged", name));
  return text;
}

Hdf5Handle open_set(const Hdf5Reader& at, hid_t group, const std::string& name, const char* kind) {
  auto set = own(H5Dopen2(group, name.c_str(), H5P_DEFAULT), H5Dclose);
  if (!set) at.refuse(fmt::format("has no {} \"{}\"", kind, name));
  return set;
}

bool has_shape(hid_t set, int rank, hsize_t* size) {
  const auto space = own(H5Dget_space(set), H5Sclose);
  return space && H5Sget_simple_extent_ndims(*space) == rank && H5Sget_simple_extent_dims(*space, size, nullptr) >= 0;
}

template <class T> std::vector<T> read_values(const Hdf5Reader& at, hid_t set, const std::string& name, hsize_t count) {
  std::vector<T> values(count);
  if (count > 0 && H5Dread(set, native_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
    at.refuse(fmt::format("holds an array \"{}\" that cannot be read", name));
  return values;
}

Hdf5Handle open_attribute(const Hdf5Reader& at, hid_t owner, const std::string& name) {
  auto attribute = own(H5Aopen(owner, name.c_str(), H5P_DEFAULT), H5Aclose);
  if (!attribute) at.refuse(fmt::format("has no attribute \"{}\"", name));
  return attribute;
}

template <class T> T read_number(const Hdf5Reader& at, hid_t owner, const std::string& name) {
  const auto attribute = open_attribute(at, owner, name);
  const auto space = own(H5Aget_space(*attribute), H5Sclose);
  T value{};
  if (!space || H5Sget_simple_extent_npoints(*space) != 1 || H5Aread(*attribute, native_type<T>(), &value) < 0)
    at.refuse(fmt::format("has an attribute \"{}\" that is not one number", name));
  return value;
}

/// Length of a fixed-length text type; refuses any other type.
std::size_t text_length(const Hdf5Reader& at, const Hdf5Handle& type, const std::string& name) {
  if (!type || H5Tget_class(*type) != H5T_STRING || H5Tis_variable_str(*type) != 0) at.refuse(fmt::format("holds \"{}\", which is not text", name));
  return H5Tget_size(*type);
}

std::string read_text_attribute(const Hdf5Reader& at, hid_t owner, const std::string& name) {
  const auto attribute = open_attribute(at, owner, name);
  const auto type = own(H5Aget_type(*attribute), H5Tclose);
  std::string text(text_length(at, type, name), '\0');
  if (H5Aread(*attribute, *type, text.data()) < 0) at.refuse(fmt::format("has an attribute \"{}\" that cannot be read", name));
  return checked(at, std::move(text), name);
}

herr_t noted(const char* name, void* into) {
  static_cast<std::vector<std::string>*>(into)->emplace_back(name);
  return 0;
}

std::vector<std::string> listed(const Hdf5Reader& at, herr_t status, std::vector<std::string> found) {
  if (status < 0 || !std::all_of(found.begin(), found.end(), is_utf8)) at.refuse("cannot be listed");
  return found;
}

/// The file lives as long as one of its groups; HDF5 copies the bytes.
Hdf5Handle open_root(std::string bytes, const std::string& file) {
  const auto access = memory_properties();
  done(H5Pset_file_image(*access, bytes.data(), bytes.size()));
  bytes = {};
  const auto id = own(H5Fopen(unused_name().c_str(), H5F_ACC_RDONLY, *access), H5Fclose);
  auto root = id ? own(H5Gopen2(*id, "/", H5P_DEFAULT), H5Gclose) : nullptr;
  if (!root) refuse(file, "is not a readable HDF5 file; remove it and make it again with \"arenite run\"");
  return root;
}

}  // namespace

Hdf5Reader::Hdf5Reader(std::string bytes, std::string file)
    : turn_(std::make_shared<Hdf5Turn>()),
      id_(open_root(std::move(bytes), file)),
      file_(std::move(file)) {}

Hdf5Reader::Hdf5Reader(Turn turn, Handle group, std::string file, std::string place)
    : turn_(std::move(turn)),
      id_(std::move(group)),
      file_(std::move(file)),
      place_(std::move(place)) {}

bool Hdf5Reader::has(const std::string& name) const { return H5Lexists(*id_, name.c_str(), H5P_DEFAULT) > 0; }

bool Hdf5Reader::has_group(const std::string& name) const { return has(name) && own(H5Gopen2(*id_, name.c_str(), H5P_DEFAULT), H5Gclose) != nullptr; }

bool Hdf5Reader::has_attribute(const std::string& name) const { return H5Aexists(*id_, name.c_str()) > 0; }

Hdf5Reader Hdf5Reader::group(const std::string& name) const {
  auto id = own(H5Gopen2(*id_, name.c_str(), H5P_DEFAULT), H5Gclose);
  if (!id) refuse(fmt::format("has no group \"{}\"", name));
  return {turn_, std::move(id), file_, place_ + "/" + name};
}

std::vector<std::string> Hdf5Reader::names() const {
  std::vector<std::string> found;
  const auto note = [](hid_t, const char* name, const H5L_info_t*, void* into) -> herr_t { return noted(name, into); };
  const auto status = H5Literate(*id_, H5_INDEX_CRT_ORDER, H5_ITER_INC, nullptr, note, &found);
  return listed(*this, status, std::move(found));
}

std::vector<std::string> Hdf5Reader::attribute_names() const {
  std::vector<std::string> found;
  const auto note = [](hid_t, const char* name, const H5A_info_t*, void* into) -> herr_t { return noted(name, into); };
  const auto status = H5Aiterate2(*id_, H5_INDEX_CRT_ORDER, H5_ITER_INC, nullptr, note, &found);
  return listed(*this, status, std::move(found));
}

template <class T> std::vector<T> Hdf5Reader::array(const std::string& name) const {
  const auto set = open_set(*this, *id_, name, "array");
  hsize_t count = 0;
  if (!has_shape(*set, 1, &count)) refuse(fmt::format("holds \"{}\", which is not a one-dimensional array", name));
  return read_values<T>(*this, *set, name, count);
}
template std::vector<double> Hdf5Reader::array(const std::string&) const;
template std::vector<std::int32_t> Hdf5Reader::array(const std::string&) const;
template std::vector<std::int64_t> Hdf5Reader::array(const std::string&) const;
template std::vector<std::uint8_t> Hdf5Reader::array(const std::string&) const;

template <class T> std::vector<T> Hdf5Reader::image(const std::string& name, int rows, int columns) const {
  if constexpr (std::is_same_v<T, double>) {
    const auto single = image<float>(name, rows, columns);
    return {single.begin(), single.end()};
  }
  const auto set = open_set(*this, *id_, name, "array");
  hsize_t size[2] = {0, 0};
  if (!has_shape(*set, 2, size) || size[0] != static_cast<hsize_t>(rows) || size[1] != static_cast<hsize_t>(columns))
    refuse(fmt::format("holds \"{}\", which is not an array of {} rows and {} columns", name, rows, columns));
  return read_values<T>(*this, *set, name, size[0] * size[1]);
}
template std::vector<double> Hdf5Reader::image(const std::string&, int, int) const;
template std::vector<float> Hdf5Reader::image(const std::string&, int, int) const;
template std::vector<std::int32_t> Hdf5Reader::image(const std::string&, int, int) const;
template std::vector<std::uint8_t> Hdf5Reader::image(const std::string&, int, int) const;

std::string Hdf5Reader::unit(const std::string& name) const { return read_text_attribute(*this, *open_set(*this, *id_, name, "array"), "unit"); }

std::string Hdf5Reader::text(const std::string& name) const {
  const auto set = open_set(*this, *id_, name, "text");
  const auto type = own(H5Dget_type(*set), H5Tclose);
  std::string text(text_length(*this, type, name), '\0');
  if (H5Dread(*set, *type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()) < 0) refuse(fmt::format("holds a text \"{}\" that cannot be read", name));
  return checked(*this, std::move(text), name);
}

std::vector<std::string> Hdf5Reader::texts(const std::string& name) const {
  const auto set = open_set(*this, *id_, name, "texts");
  const auto type = own(H5Dget_type(*set), H5Tclose);
  const std::size_t length = text_length(*this, type, name);
  hsize_t count = 0;
  if (!has_shape(*set, 1, &count) || count > most_texts / length) refuse(fmt::format("holds \"{}\", which is not a list of texts", name));
  std::string cells(count * length, '\0');
  if (count > 0 && H5Dread(*set, *type, H5S_ALL, H5S_ALL, H5P_DEFAULT, cells.data()) < 0) refuse(fmt::format("holds texts \"{}\" that cannot be read", name));
  std::vector<std::string> out;
  for (hsize_t k = 0; k < count; ++k) out.push_back(checked(*this, cells.substr(k * length, length), name));
  return out;
}

double Hdf5Reader::number(const std::string& name) const { return read_number<double>(*this, *id_, name); }
std::int64_t Hdf5Reader::integer(const std::string& name) const { return read_number<std::int64_t>(*this, *id_, name); }
std::uint64_t Hdf5Reader::natural(const std::string& name) const { return read_number<std::uint64_t>(*this, *id_, name); }
std::string Hdf5Reader::label(const std::string& name) const { return read_text_attribute(*this, *id_, name); }

void Hdf5Reader::refuse(const std::string& message) const {
  io::refuse(file_, "{} {}; remove the file and make it again with \"arenite run\"", place_.empty() ? "/" : place_, message);
}

}  // namespace arenite::io
