#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "io/volume/volume.hpp"
#include "support/pictures.hpp"

namespace arenite::io {
namespace {

using Matrix34 = std::array<float, 12>;

/// A header of 2 x 2 x 2 voxels of 0.1 mm, and their numbers.
class NiftiFile {
 public:
  NiftiFile() {
    set(0, std::int32_t{348});
    const std::int16_t dim[] = {3, 2, 2, 2};
    for (std::size_t k = 0; k < 4; ++k) set(40 + 2 * k, dim[k]);
    set(70, std::int16_t{2});
    for (std::size_t k = 1; k <= 3; ++k) set(76 + 4 * k, 0.1F);
    set(108, 352.0F);
    bytes_[123] = 2;
    bytes_.replace(344, 3, "n+1");
  }
  template <class T> NiftiFile& set(std::size_t at, T value) {
    std::memcpy(bytes_.data() + at, &value, sizeof(value));
    return *this;
  }
  NiftiFile& sform(const Matrix34& m) {
    set(254, std::int16_t{1});
    for (std::size_t k = 0; k < 12; ++k) set(280 + 4 * k, m[k]);
    return *this;
  }
  std::vector<std::string> remarks(bool dx_given = false) const {
    return open_volume(bytes_in_memory(bytes_, "a.nii"), {.dx_given = dx_given})->facts().remarks;
  }
  std::string refusal() const {
    return test::complaint([&] { remarks(); });
  }

 private:
  std::string bytes_ = std::string(352 + 8, '\0');
};

bool tells_of(const std::vector<std::string>& remarks, const std::string& part) {
  return remarks.size() == 1 && remarks[0].find(part) != std::string::npos;
}

TEST(Nifti, WhereVoxelsLieIsToldOrRefused) {
  EXPECT_TRUE(NiftiFile().remarks().empty());
  EXPECT_TRUE(NiftiFile().sform({0.1F, 0, 0, 0, 0, 0.1F, 0, 0, 0, 0, 0.1F, 0}).remarks().empty());
  EXPECT_TRUE(tells_of(NiftiFile().sform({0, 0, 0.1F, 0, 0, 0.1F, 0, 0, -0.1F, 0, 0, 0}).remarks(),
                       "the steps of its sform turn or mirror the axes"));
  EXPECT_TRUE(tells_of(NiftiFile().sform({0.1F, 0, 0, 5, 0, 0.1F, 0, 0, 0, 0, 0.1F, 0}).remarks(),
                       "the offset of its sform (5, 0, 0) is left aside"));
  EXPECT_NE(NiftiFile().sform({0.1F, 0.05F, 0, 0, 0, 0.1F, 0, 0, 0, 0, 0.1F, 0}).refusal().find("axes that lean"),
            std::string::npos);
  const NiftiFile other = NiftiFile().sform({0.1F, 0, 0, 0, 0, 0.1F, 0, 0, 0, 0, 0.2F, 0});
  EXPECT_NE(other.refusal().find("voxels of 0.2 along axis 3 by its sform and of 0.1 by its pixdim"), std::string::npos)
      << other.refusal();
  EXPECT_TRUE(other.remarks(true).empty());
}

TEST(Nifti, QformCountsWithoutSform) {
  const auto turned = [] { return NiftiFile().set(252, std::int16_t{1}).set(260, 0.70710678F); };
  EXPECT_TRUE(NiftiFile().set(252, std::int16_t{1}).remarks().empty());
  EXPECT_TRUE(tells_of(turned().remarks(), "the steps of its qform turn or mirror the axes"));
  EXPECT_TRUE(tells_of(NiftiFile().set(252, std::int16_t{1}).set(76, -1.0F).remarks(), "its qform turn or mirror"));
  EXPECT_TRUE(turned().sform({0.1F, 0, 0, 0, 0, 0.1F, 0, 0, 0, 0, 0.1F, 0}).remarks().empty());
}

}  // namespace
}  // namespace arenite::io
