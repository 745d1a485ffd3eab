#include "io/volume/stack.hpp"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "core/problems.hpp"
#include "io/film/film.hpp"
#include "io/image/image.hpp"
#include "io/volume/volume.hpp"

namespace arenite::io {
namespace {

/// Pictures of a stack, one upon the other: what else reads them as the frames of a film.
class Slices : public VolumeSource {
 public:
  Slices(std::unique_ptr<FilmSource> film, const std::string& file, bool elsewhere)
      : film_(std::move(film)),
        file_(file) {
    const FilmInfo& info = film_->info();
    facts_ = sized({info.width, info.height, info.frames}, file);
    facts_.remarks = info.remarks;
    facts_.elsewhere = elsewhere;
  }
  const VolumeFacts& facts() const override { return facts_; }
  void read(int z, std::span<std::int32_t> layer) override {
    film_->read(z, 1, block_);
    if (!block_.level.empty()) {
      std::copy(block_.level.begin(), block_.level.end(), layer.begin());
      return;
    }
    const auto width = static_cast<std::size_t>(facts_.width);
    for (std::size_t i = 0; i < layer.size(); ++i)
      layer[i] = whole_value(static_cast<double>(block_.value[i]), file_, i % width, i / width);
  }

 private:
  std::unique_ptr<FilmSource> film_;
  std::string file_;
  VolumeFacts facts_;
  FrameBlock block_;
};

VolumePointer open_stack(const Bytes& bytes, const VolumeChoice& choice) {
  return std::make_unique<Slices>(open_film(bytes, FilmChoice{.dataset = choice.dataset}), bytes->name(), false);
}

}  // namespace

VolumePointer open_slices(const std::filesystem::path& path) {
  return std::make_unique<Slices>(open_film(path), path.string(), true);
}

constinit const VolumeFormat volumes::stack{
    .name = "stack",
    .sentence = "a stack of pictures (TIFF, HDF5, a folder of TIFF slices)",
    .states = {{"pictures",
                "one upon the other: the first is z = 0, rows of a picture go along x, its columns along y"},
               {"spacing", "left aside: give --dx"}},
    .always = false,
    .is = [](std::string_view head) { return is_tiff(head) || is_hdf5(head); },
    .open = open_stack};

}  // namespace arenite::io
