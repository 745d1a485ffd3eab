#include "io/hdf5/dataset_search.hpp"

#include <set>
#include <utility>

#include "io/hdf5/handle.hpp"

namespace arenite::io {
namespace {

/// Looks through groups from where they are: by its whole name each would be sought from the root again. What hangs in
/// two groups is found once.
struct DatasetSearch {
  static constexpr std::size_t deepest = 64, most_objects = 1'000'000;
  bool (*fits)(hid_t set);
  std::vector<std::string> found = {};
  std::set<haddr_t> seen = {};
  std::string place = {};
  std::size_t depth = 0;

  void look_in(hid_t group) {
    const auto look = [](hid_t in, const char* name, const H5L_info_t* link, void* search) -> herr_t {
      if (link->type == H5L_TYPE_HARD) static_cast<DatasetSearch*>(search)->look_at(in, name);
      return 0;
    };
    H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, look, this);
  }

  void look_at(hid_t in, const char* name) {
    const auto object = own(H5Oopen(in, name, H5P_DEFAULT), H5Oclose);
    H5O_info_t info;
    if (!object || seen.size() >= most_objects || H5Oget_info2(*object, &info, H5O_INFO_BASIC) < 0 ||
        !seen.insert(info.addr).second)
      return;
    if (info.type == H5O_TYPE_DATASET && fits(*object)) found.push_back(place + name);
    if (info.type != H5O_TYPE_GROUP || depth == deepest) return;
    const std::size_t before = place.size();
    place.append(name).append("/");
    ++depth;
    look_in(*object);
    --depth;
    place.resize(before);
  }
};

}  // namespace

std::vector<std::string> datasets_in(hid_t file, bool (*fits)(hid_t set)) {
  DatasetSearch search{fits};
  search.look_in(file);
  return std::move(search.found);
}

}  // namespace arenite::io
