#include <utility>

#include "io/film_formats.hpp"

namespace arenite::io {
namespace {

class ScaledFilm : public FilmSource {
 public:
  ScaledFilm(FilmPointer film, double scale, double offset) : film_(std::move(film)), info_(film_->info()), scale_(scale), offset_(offset) {
    info_.floating = true;
    info_.bits = 0;
    info_.quantity = FilmQuantity::kelvin;
  }
  const FilmInfo& info() const override { return info_; }

  void read(std::int64_t first, std::size_t count, FrameBlock& block) override {
    film_->read(first, count, part_);
    block.first = first;
    block.frames = count;
    block.level.clear();
    block.value.clear();
    for (const std::uint16_t v : part_.level) block.value.push_back(static_cast<float>(scale_ * v + offset_));
    for (const float v : part_.value) block.value.push_back(static_cast<float>(scale_ * static_cast<double>(v) + offset_));
  }

 private:
  FilmPointer film_;
  FilmInfo info_;
  double scale_, offset_;
  FrameBlock part_;
};

}  // namespace

FilmPointer scaled_film(FilmPointer film, const FilmChoice& choice) {
  if (!choice.scale && !choice.offset) return film;
  return std::make_unique<ScaledFilm>(std::move(film), choice.scale.value_or(1), choice.offset.value_or(0));
}

}  // namespace arenite::io
