#include "io/hdf5/foreign.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>

#include "core/mapped.hpp"
#include "core/problems.hpp"

namespace arenite::io {
namespace {

/// Deflate packs at most a thousandfold; a table that is larger was never written.
constexpr double most_packed = 1100;

double product_of(const auto& numbers) {
  double product = 1;
  for (const auto n : numbers) product *= static_cast<double>(n);
  return product;
}

/// Names of the datasets that fit, in rising order.
std::vector<std::string> datasets_in(hid_t file, const ForeignKind& kind) {
  struct Search {
    const ForeignKind& kind;
    std::vector<std::string> found;
  } search{kind, {}};
  const auto note = [](hid_t root, const char* name, const H5O_info_t* info, void* into) -> herr_t {
    if (info->type != H5O_TYPE_DATASET) return 0;
    const auto set = own(H5Dopen2(root, name, H5P_DEFAULT), H5Dclose);
    if (auto& s = *static_cast<Search*>(into); set && s.kind.fits(*set)) s.found.emplace_back(name);
    return 0;
  };
  H5Ovisit2(file, H5_INDEX_NAME, H5_ITER_INC, note, &search, H5O_INFO_BASIC);
  return std::move(search.found);
}

/// Null where there is no attribute of this name that is one value, or a damaged one.
struct Attribute {
  Hdf5Handle id, type;
  Attribute(hid_t at, const char* name) {
    if (H5Aexists(at, name) <= 0) return;
    const auto attribute = own(H5Aopen(at, name, H5P_DEFAULT), H5Aclose), space = attribute ? own(H5Aget_space(*attribute), H5Sclose) : nullptr;
    if (!space || H5Sget_simple_extent_npoints(*space) != 1) return;
    type = own(H5Aget_type(*attribute), H5Tclose);
    if (type) id = attribute;
  }
};

}  // namespace

std::vector<std::int64_t> shape_of(hid_t set) {
  const auto space = own(H5Dget_space(set), H5Sclose);
  const int rank = space ? H5Sget_simple_extent_ndims(*space) : 0;
  if (rank <= 0 || rank > H5S_MAX_RANK) return {};
  std::vector<hsize_t> shape(static_cast<std::size_t>(rank));
  H5Sget_simple_extent_dims(*space, shape.data(), nullptr);
  return mapped(shape, [](hsize_t n) { return static_cast<std::int64_t>(std::min<hsize_t>(n, std::numeric_limits<std::int64_t>::max())); });
}

bool holds(hid_t set, std::initializer_list<H5T_class_t> classes) {
  const auto type = own(H5Dget_type(set), H5Tclose);
  return type && std::ranges::count(classes, H5Tget_class(*type)) > 0;
}

std::string meant_dataset(hid_t file, const std::string& file_name, const std::string& chosen, const ForeignKind& kind) {
  const auto set = chosen.empty() ? nullptr : own(H5Dopen2(file, chosen.c_str(), H5P_DEFAULT), H5Dclose);
  if (set && kind.fits(*set)) return chosen;
  const auto found = datasets_in(file, kind);
  if (set) refuse(file_name, "holds \"{}\", which is no {}; it has: {}", chosen, kind.sentence, fmt::join(found, ", "));
  if (!chosen.empty()) refuse(file_name, "has no dataset \"{}\"; it has: {}", chosen, fmt::join(found, ", "));
  if (found.size() == 1) return found.front();
  if (found.empty()) refuse(file_name, "is an HDF5 file of another program and holds no {}; give a file with one", kind.sentence);
  refuse(file_name, "holds {} datasets that can be meant; choose one with --dataset: {}", found.size(), fmt::join(found, ", "));
}

ForeignDataset::ForeignDataset(Hdf5Handle file, const Bytes& bytes, const std::string& name, double most)
    : file_(std::move(file)),
      set_(own(H5Dopen2(*file_, name.c_str(), H5P_DEFAULT), H5Dclose)),
      file_name_(bytes->name()),
      name_(name) {
  type_ = set_ ? own(H5Dget_type(*set_), H5Tclose) : nullptr;
  const auto creation = set_ ? own(H5Dget_create_plist(*set_), H5Pclose) : nullptr;
  if (!type_ || !creation) refuse("that is damaged; copy the file again");
  shape_ = shape_of(*set_);
  if (product_of(shape_) * bits() / 8 > most_packed * static_cast<double>(bytes->size()))
    refuse("that announces more than a file of this size can hold; copy it again");
  const H5D_layout_t layout = H5Pget_layout(*creation);
  if (H5Pget_external_count(*creation) > 0 || layout == H5D_VIRTUAL) refuse("whose numbers are in other files; copy them into one");
  if (layout != H5D_CHUNKED) return;
  std::vector<hsize_t> chunk(shape_.size());
  if (H5Pget_chunk(*creation, static_cast<int>(chunk.size()), chunk.data()) < 0) refuse("that is damaged; copy the file again");
  if (product_of(chunk) > most) refuse(fmt::format("stored in chunks of {:.0f} numbers; store a few frames a chunk", product_of(chunk)));
}

void ForeignDataset::refuse(const std::string& what) const { arenite::refuse(file_name_, "holds a dataset \"{}\" {}", name_, what); }

std::int64_t ForeignDataset::numbers_in_slab() const {
  std::int64_t numbers = 1;
  for (std::size_t axis = 1; axis < shape_.size(); ++axis) numbers *= shape_[axis];
  return numbers;
}

void ForeignDataset::read(std::int64_t first, std::int64_t count, hid_t type, void* to) const {
  std::vector<hsize_t> start(shape_.size()), size(shape_.begin(), shape_.end());
  start.front() = static_cast<hsize_t>(first);
  size.front() = static_cast<hsize_t>(count);
  const auto there = own(H5Dget_space(*set_), H5Sclose), here = own(H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr), H5Sclose);
  const bool is_there = there && here && H5Sselect_hyperslab(*there, H5S_SELECT_SET, start.data(), nullptr, size.data(), nullptr) >= 0;
  if (!is_there || H5Dread(*set_, type, *here, *there, H5P_DEFAULT, to) < 0)
    refuse(
        "that cannot be read: it is cut short or damaged, or packed in a way that is not known here; copy the file again, or pack it with h5repack -f GZIP=4");
}

double number_attribute(hid_t at, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    const Attribute attribute(at, name);
    double value = 0;
    if (attribute.id && H5Aread(*attribute.id, H5T_NATIVE_DOUBLE, &value) >= 0 && value > 0) return value;
  }
  return 0;
}

std::string text_attribute(hid_t at, const char* name) {
  const Attribute attribute(at, name);
  if (!attribute.id || H5Tget_class(*attribute.type) != H5T_STRING || H5Tis_variable_str(*attribute.type) != 0) return {};
  const std::size_t size = H5Tget_size(*attribute.type);
  if (size == 0 || size > 65536) return {};
  std::string text(size, '\0');
  if (H5Aread(*attribute.id, *attribute.type, text.data()) < 0) return {};
  return text.substr(0, text.find('\0'));
}

Hdf5Handle open_foreign(const Bytes& bytes) {
  if (bytes->path() == nullptr) return open_in_memory(bytes->text(0, bytes->size()), bytes->name());
  auto id = own(H5Fopen(bytes->path()->c_str(), H5F_ACC_RDONLY, *without_lock()), H5Fclose);
  if (!id) refuse(bytes->name(), "is an HDF5 file that is cut short or damaged; copy it again");
  return id;
}

}  // namespace arenite::io
