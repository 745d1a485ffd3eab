#include "io/hdf5_foreign.hpp"

#include <algorithm>
#include <limits>

#include "core/error.hpp"

namespace arenite::io {

Hdf5Handle open_foreign(std::string bytes, const std::string& file) {
  Hdf5Handle id;
  const auto access = memory_properties();
  if (!bytes.empty()) {
    done(H5Pset_libver_bounds(*access, H5F_LIBVER_EARLIEST, H5F_LIBVER_LATEST));  // whoever wrote it
    done(H5Pset_file_image(*access, bytes.data(), bytes.size()));
    id = own(H5Fopen(unused_name().c_str(), H5F_ACC_RDONLY, *access), H5Fclose);
  }
  if (!id) throw InputError(file, 0, "is an HDF5 file that is cut short or damaged; copy it again");
  return id;
}

std::vector<std::int64_t> shape_of(hid_t set) {
  const auto space = own(H5Dget_space(set), H5Sclose);
  const int rank = space ? H5Sget_simple_extent_ndims(*space) : 0;
  if (rank <= 0 || rank > H5S_MAX_RANK) return {};
  std::vector<hsize_t> shape(static_cast<std::size_t>(rank));
  H5Sget_simple_extent_dims(*space, shape.data(), nullptr);
  std::vector<std::int64_t> result;
  for (const hsize_t n : shape) result.push_back(static_cast<std::int64_t>(std::min<hsize_t>(n, std::numeric_limits<std::int64_t>::max())));
  return result;
}

std::vector<std::string> datasets_in(hid_t file, bool (*fits)(hid_t set)) {
  struct Search {
    bool (*fits)(hid_t set);
    std::vector<std::string> found;
  } search{fits, {}};
  const auto note = [](hid_t root, const char* name, const H5O_info_t* info, void* into) -> herr_t {
    if (info->type != H5O_TYPE_DATASET) return 0;
    const auto set = own(H5Dopen2(root, name, H5P_DEFAULT), H5Dclose);
    if (auto& s = *static_cast<Search*>(into); set && s.fits(*set)) s.found.emplace_back(name);
    return 0;
  };
  H5Ovisit2(file, H5_INDEX_NAME, H5_ITER_INC, note, &search, H5O_INFO_BASIC);
  return std::move(search.found);
}

}  // namespace arenite::io
