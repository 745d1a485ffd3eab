#include "thermal/imaging/disk_model.hpp"

#include <algorithm>
#include <cmath>

#include "core/mapped.hpp"
#include "core/median.hpp"
#include "core/ranks.hpp"
#include "statistics/least_squares.hpp"

namespace arenite::imaging {
namespace {

constexpr double least_radius = 1.0, longest_step = 0.5;  // pixels
constexpr double settled = 1e-3, at_rest = 5e-3;          // pixels a step

/// Those beyond 2.5 standard deviations count less.
double huber_weight(double residual, double noise) {
  const double size = std::abs(residual), most = 2.5 * noise;
  return size <= most || size == 0 ? 1 : most / size;
}

Vec2 from_centre(const DiskModel::Disk& disk, int x, int y) { return {x - disk.centre.x, y - disk.centre.y}; }

}  // namespace

DiskModel::DiskModel(const FloatImage& image, double blur, bool bright, std::optional<double> between)
    : image_(image),
      bright_(bright),
      between_(between),
      blur_(blur) {
  refresh();
}

DiskModel::Window DiskModel::window(const Disk& disk) const {
  const double reach = disk.radius + 3 * blur_ + 1.5;
  const auto [x, y] = disk.centre;
  return {std::max(0, static_cast<int>(std::ceil(x - reach))), std::min(image_.width - 1, static_cast<int>(x + reach)),
          std::max(0, static_cast<int>(std::ceil(y - reach))),
          std::min(image_.height - 1, static_cast<int>(y + reach))};
}

DiskModel::Cover DiskModel::cover(const Disk& disk, int x, int y) const {
  const Vec2 away = from_centre(disk, x, y);
  const double square = dot(away, away);
  // Most pixels of a window lie deep inside, or in its corners: what follows says the same of them, with a root.
  const double deep = disk.radius - (BlurredStep::reach + 0.5) * blur_, far = disk.radius + BlurredStep::reach * blur_;
  if (square > far * far) return {0};
  if (deep > blur_ && square < deep * deep) return {1};
  const double q = std::sqrt(square), u = (disk.radius - q - blur_ * blur_ / (2 * std::max(q, blur_))) / blur_;
  if (u > BlurredStep::reach) return {1};
  if (u < -BlurredStep::reach) return {0};
  double density;
  const double share = BlurredStep::at(u, density);
  return {share, density / blur_, q > 0 ? away / q : Vec2{}};
}

void DiskModel::spread(const Disk& disk, double sign) {
  each(disk, [&](int x, int y, std::size_t at) {
    const double c = sign * cover(disk, x, y).share;
    covered_[at] += static_cast<float>(c);
    light_[at] += static_cast<float>(c * disk.level);
  });
}

void DiskModel::spread_all() {
  covered_.assign(image_.size(), 0.0F);
  light_ = covered_;
  for (const Disk& disk : disks_) spread(disk, 1);
}

double DiskModel::left(std::size_t pixel) const {
  return static_cast<double>(image_.value[pixel]) - static_cast<double>(light_[pixel]) -
         (1.0 - static_cast<double>(covered_[pixel])) * static_cast<double>(background_[pixel]);
}

void DiskModel::add(const Circle& circle) {
  Disk disk{circle.centre, circle.radius, 0, 0, 0, longest_step};
  std::vector<double> inside;
  each(disk, [&](int x, int y, std::size_t at) {
    if (norm(from_centre(disk, x, y)) < std::max(0.75, 0.6 * disk.radius))
      inside.push_back(static_cast<double>(image_.value[at]));
  });
  disk.level = median(std::move(inside));
  disks_.push_back(disk);
}

void DiskModel::remove(const std::vector<char>& which) {
  std::size_t k = 0;
  std::erase_if(disks_, [&](const Disk&) { return which[k++] != 0; });
}

void DiskModel::refresh() {
  spacing_ = std::clamp(static_cast<int>(12 * median(mapped(disks_, &Disk::radius))), 32, 4096);
  columns_ = image_.width / spacing_ + 2;
  rows_ = image_.height / spacing_ + 2;
  background_.resize(image_.size());
  spread_all();
  start_background();
  for (int i = 0; i < 4; ++i) fit_background();
  measure_noise();
}

/// One damped step of a disk; its size in pixels.
double DiskModel::step(Disk& disk) {
  const double deep = disk.radius - std::max(3.0, 5 * blur_);  // farther inside nothing is learned of the rim
  statistics::SmallNormal<4> equations;
  each(disk, [&](int x, int y, std::size_t at) {
    const Vec2 away = from_centre(disk, x, y);
    if (deep > 0 && dot(away, away) < deep * deep) return;
    const auto [c, edge, outward] = cover(disk, x, y);
    if (c < 1e-5) return;
    const double contrast = disk.level - static_cast<double>(background_[at]), gap = left(at);
    equations.add({contrast * edge * outward.x, contrast * edge * outward.y, contrast * edge, c}, gap,
                  huber_weight(gap, noise_));
  });
  auto& normal = equations.matrix;
  const double trace = normal[0][0] + normal[1][1] + normal[2][2] + normal[3][3];
  if (!(trace > 0)) return 0;
  const double variance = std::max(noise_ * noise_, 1e-12 * trace);
  if (disk.prior_error > 0) {
    const double stiff = variance / (disk.prior_error * disk.prior_error);
    normal[2][2] += stiff;
    equations.right[2] += stiff * (disk.prior_radius - disk.radius);
  }
  for (std::size_t i = 0; i < 4; ++i) normal[i][i] *= 1.02;
  for (std::size_t i = 0; i < 3; ++i) normal[i][i] += 1e-3 * (normal[0][0] + normal[1][1]) + 1e-30;
  const auto [x, y, radius, level] = equations.solution();
  const double size = std::hypot(x, y, radius), part = size > longest_step ? longest_step / size : 1;
  if (!std::isfinite(size) || !std::isfinite(level)) return 0;
  spread(disk, -1);
  disk.centre += part * Vec2{x, y};
  disk.radius = std::max(least_radius, disk.radius + part * radius);
  disk.level += part * level;
  spread(disk, 1);
  return std::min(size, longest_step);
}

void DiskModel::fit_blur() {
  double top = 0, bottom = 0;
  for (const Disk& disk : disks_)
    each(disk, [&](int x, int y, std::size_t at) {
      const double edge = cover(disk, x, y).edge;
      if (edge == 0) return;
      const double q = norm(from_centre(disk, x, y));
      const double slope = -(disk.level - static_cast<double>(background_[at])) * edge *
                           ((disk.radius - q) / blur_ + blur_ / (2 * std::max(q, blur_)));
      const double gap = left(at), weight = huber_weight(gap, noise_);
      top += weight * slope * gap;
      bottom += weight * slope * slope;
    });
  if (!(bottom > 0)) return;
  const double before = blur_;
  blur_ = std::clamp(blur_ + std::clamp(0.7 * top / bottom, -0.1, 0.1), 0.3, 4.0);
  if (blur_ != before) spread_all();
}

void DiskModel::measure_noise() {
  std::vector<double> size;
  for (const Disk& disk : disks_)
    each(disk, [&](int x, int y, std::size_t at) {
      if (std::abs(norm(from_centre(disk, x, y)) - disk.radius) < 2 * blur_) size.push_back(std::abs(left(at)));
    });
  noise_ = median(std::move(size)) / median_of_normal_size;
}

void DiskModel::fit(int sweeps, int between) {
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    const bool all = sweep % between == 0;
    double most = 0;
    for (Disk& disk : disks_)
      if (all || disk.moved >= at_rest) most = std::max(most, disk.moved = step(disk));
    if (!all) continue;
    fit_background();
    fit_blur();
    measure_noise();
    if (most < settled) break;
  }
}

FloatImage DiskModel::residual() const {
  FloatImage image{image_.width, image_.height, std::vector<float>(image_.size())};
  for (std::size_t i = 0; i < image.size(); ++i) image.value[i] = static_cast<float>(left(i));
  return image;
}

std::array<std::pair<std::size_t, double>, 4> DiskModel::shares(Vec2 place) const {
  const double u = std::max(0.0, place.x / spacing_), v = std::max(0.0, place.y / spacing_);
  const int c = std::min(static_cast<int>(u), columns_ - 2), r = std::min(static_cast<int>(v), rows_ - 2);
  const double a = u - c, b = v - r;
  const auto first = static_cast<std::size_t>(c + columns_ * r), above = first + static_cast<std::size_t>(columns_);
  return {{{first, (1 - a) * (1 - b)}, {first + 1, a * (1 - b)}, {above, (1 - a) * b}, {above + 1, a * b}}};
}

double DiskModel::background(Vec2 place) const {
  double sum = 0;
  for (const auto& [node, share] : shares(place)) sum += share * node_[node];
  return sum;
}

void DiskModel::draw_background() {
  for (int y = 0; y < image_.height; ++y)
    for (int x = 0; x < image_.width; ++x)
      background_[image_.index(x, y)] = static_cast<float>(background({1.0 * x, 1.0 * y}));
}

/// Pixels in the windows of disks; all where there are none.
std::vector<char> DiskModel::near_disks() const {
  std::vector<char> near(image_.size(), disks_.empty() ? 1 : 0);
  for (const Disk& disk : disks_) each(disk, [&](int, int, std::size_t at) { near[at] = 1; });
  return near;
}

/// The net starts flat, from the level that is given, or the end of the scale where the background is: disks that are
/// not found yet look like background, and between many of them it would otherwise be taken for as bright as they are.
void DiskModel::start_background() {
  const std::vector<char> near = near_disks();
  std::vector<float> free;
  for (std::size_t i = 0; i < image_.size(); ++i)
    if (near[i] != 0 && covered_[i] < 0.2F) free.push_back(image_.value[i]);
  double level = 0;
  if (!free.empty()) {
    level = between_.value_or(static_cast<double>(of_rank_in_place(free, free.size() * (bright_ ? 1 : 9) / 10)));
    if (noise_ == 0) noise_ = 0.1 * std::abs(median_in_place(free.begin(), free.end()) - level);
  }
  node_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), level);
  draw_background();
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
      // Next to no weight for what stands out to the side of the disks, as one that is not found yet.
      const double gap = left(at), huber = noise_ > 0 ? huber_weight(gap, noise_) : 1,
                   w = between_ || (gap > 0) == bright_ ? huber * huber * huber : huber;
      for (const auto& [node, share] : shares({1.0 * x, 1.0 * y}))
        top[node] += share * w * free * gap, bottom[node] += share * w * free * free;
      all_top += w * free * gap;
      all_bottom += w * free * free;
    }
  const double few = 0.02 * all_bottom / static_cast<double>(node_.size());  // a node that sees little follows all
  for (std::size_t n = 0; n < node_.size(); ++n) node_[n] += (top[n] + few * all_top / all_bottom) / (bottom[n] + few);
  draw_background();
}

}  // namespace arenite::imaging
