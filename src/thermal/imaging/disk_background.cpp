#include <algorithm>
#include <cmath>

#include "core/median.hpp"
#include "thermal/imaging/disk_model.hpp"

namespace arenite::imaging {

double huber_weight(double residual, double noise) {
  const double size = std::abs(residual), most = 2.5 * noise;
  return size <= most || size == 0 ? 1 : most / size;
}

double DiskModel::background(Vec2 place) const {
  const double u = std::max(0.0, place.x / spacing_), v = std::max(0.0, place.y / spacing_);
  const int c = std::min(static_cast<int>(u), columns_ - 2), r = std::min(static_cast<int>(v), rows_ - 2);
  const double a = u - c, b = v - r;
  const auto at = [&](int i, int j) { return node_[static_cast<std::size_t>(i + columns_ * j)]; };
  return (1 - b) * ((1 - a) * at(c, r) + a * at(c + 1, r)) + b * ((1 - a) * at(c, r + 1) + a * at(c + 1, r + 1));
}

void DiskModel::draw_background() {
  for (int y = 0; y < image_.height; ++y)
    for (int x = 0; x < image_.width; ++x) background_[image_.index(x, y)] = static_cast<float>(background({static_cast<double>(x), static_cast<double>(y)}));
}

/// Pixels in the windows of disks; all where there are none.
std::vector<char> DiskModel::near_disks() const {
  std::vector<char> near(image_.size(), disks_.empty() ? 1 : 0);
  for (const Disk& disk : disks_) {
    const Window w = window(disk);
    for (int y = w.y0; y <= w.y1; ++y) std::fill_n(near.begin() + static_cast<std::ptrdiff_t>(image_.index(w.x0, y)), w.x1 - w.x0 + 1, 1);
  }
  return near;
}

/// The net starts flat, from the level that is given, or the end of the scale where the background is: disks that are not found yet look like
/// background, and between many of them it would otherwise be taken for as bright as they are.
void DiskModel::start_background() {
  const std::vector<char> near = near_disks();
  std::vector<float> free;
  for (std::size_t i = 0; i < image_.size(); ++i)
    if (near[i] != 0 && covered_[i] < 0.2F) free.push_back(image_.value[i]);
  double level = 0;
  if (!free.empty()) {
    const auto at = free.begin() + static_cast<std::ptrdiff_t>(free.size() * (bright_ ? 1 : 9) / 10);
    std::nth_element(free.begin(), at, free.end());
    level = between_.value_or(static_cast<double>(*at));
    if (noise_ == 0) noise_ = 0.1 * std::abs(median_in_place(free.begin(), free.end()) - level);
  }
  node_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), level);
  draw_background();
}

/// Huber's weight, and next to none for what stands out to the side of the disks, as one that is not found yet.
double DiskModel::background_weight(double gap) const {
  const double w = noise_ > 0 ? huber_weight(gap, noise_) : 1;
  return between_ || (gap > 0) == bright_ ? w * w * w : w;
}

/// One lumped least-squares step of every node on the pixels near disks, as far as these do not cover them.
void DiskModel::fit_background() {
  const std::vector<char> near = near_disks();
  std::vector<double> top(node_.size(), 0.0), bottom(node_.size(), 1e-12);
  double all_top = 0, all_bottom = 1e-12;
  for (int y = 0; y < image_.height; ++y)
    for (int x = 0; x < image_.width; ++x) {
      const std::size_t at = image_.index(x, y);
      const double free = std::clamp(1.0 - static_cast<double>(covered_[at]), 0.0, 1.0);
      if (near[at] == 0 || free < 0.02) continue;
      const double gap = left(at), w = background_weight(gap);
      const int c = x / spacing_, r = y / spacing_;
      const double a = static_cast<double>(x) / spacing_ - c, b = static_cast<double>(y) / spacing_ - r;
      const double share[4] = {(1 - a) * (1 - b), a * (1 - b), (1 - a) * b, a * b};
      for (int k = 0; k < 4; ++k) {
        const auto n = static_cast<std::size_t>(c + k % 2 + columns_ * (r + k / 2));
        top[n] += w * share[k] * free * gap;
        bottom[n] += w * share[k] * free * free;
      }
      all_top += w * free * gap;
      all_bottom += w * free * free;
    }
  const double few = 0.02 * all_bottom / static_cast<double>(node_.size());  // a node that sees little follows all
  for (std::size_t n = 0; n < node_.size(); ++n) node_[n] += (top[n] + few * all_top / all_bottom) / (bottom[n] + few);
  draw_background();
}

}  // namespace arenite::imaging
