#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "model/image.hpp"

namespace arenite::imaging {

/// The normal distribution and its density from a table: cubic between points, right to 3e-9. A picture's fit asks for
/// them a hundred million times.
class BlurredStep {
 public:
  static constexpr double reach = 5;  ///< beyond, the step counts as 0 or 1

  /// Phi(u) for |u| <= reach; `density` becomes phi(u).
  static double at(double u, double& density) {
    static const Table table;
    const double place = (u + reach) * per_unit;
    const auto k = static_cast<std::size_t>(place);
    const Point &a = table.point[k], &b = table.point[k + 1];
    const double t = place - static_cast<double>(k), s = 1 - t;
    const double left = s * s * (1 + 2 * t), right = t * t * (1 + 2 * s), rise = s * s * t / per_unit,
                 fall = t * t * s / per_unit;
    density = left * a.density + right * b.density + rise * a.bend - fall * b.bend;
    return left * a.share + right * b.share + rise * a.density - fall * b.density;
  }

 private:
  static constexpr double per_unit = 32;
  struct Point {
    double share, density, bend;
  };
  struct Table {
    std::array<Point, static_cast<std::size_t>(2 * reach * per_unit) + 2> point;
    Table() {
      for (std::size_t k = 0; k < point.size(); ++k) {
        const double u = static_cast<double>(k) / per_unit - reach,
                     density = std::exp(-0.5 * u * u) / std::sqrt(2 * std::numbers::pi);
        point[k] = {0.5 * std::erfc(-u / std::numbers::sqrt2), density, -u * density};
      }
    }
  };
};

/// A circle that the edges of a picture speak for.
struct Circle {
  Vec2 centre;        ///< pixels
  double radius = 0;  ///< pixels
  double score = 0;   ///< how much of the rim shows an edge of the right sign, 0 to 1
};

/// A picture as a sum of disks on a background, all under one blur:
///   I(p) = B(p) + sum_k (level_k - B(p)) C_k(p),
/// C_k the share of pixel p that disk k covers after lens and pixel have blurred it with a Gaussian of standard
/// deviation s: C = Phi((r - q - s^2/(2 q))/s) at the distance q from the centre, right to second order in s/r. B is
/// linear between the nodes of a coarse net. Fitted by Gauss-Newton steps, one disk after the other with its neighbours
/// in the model, so that touching disks do not pull at each other.
class DiskModel {
 public:
  struct Disk {
    Vec2 centre;  ///< pixels
    double radius = 0, level = 0;
    double prior_radius = 0, prior_error = 0;  ///< what is known of the radius; no prior where the error is 0
    double moved = 1;                          ///< by the last step, pixels
    double ring = 0;                           ///< radius at which its rim was first seen
  };
  /// Errors of a disk's parameters.
  struct Errors {
    double position = 0, radius = 0, level = 0;
  };

  /// Disks are brighter (`bright`) or darker than the background, or both if `between` tells the background's level.
  DiskModel(const FloatImage& image, double blur, bool bright, std::optional<double> between = std::nullopt);

  void add(const Circle& circle);
  void remove(const std::vector<char>& which);
  std::vector<Disk>& disks() { return disks_; }  ///< after a change, call refresh()
  const std::vector<Disk>& disks() const { return disks_; }
  double blur() const { return blur_; }
  double noise() const { return noise_; }  ///< robust standard deviation of what the fit leaves near rims
  double background(Vec2 place) const;
  void refresh();  ///< net, coverage and levels anew from the disks
  /// Steps of all disks, in every `between`-th sweep; in the others only of those that still move.
  void fit(int sweeps, int between = 1);
  FloatImage residual() const;  ///< picture minus model
  /// From the normal matrix of each disk and those that touch its pixels, held against the noise.
  std::vector<Errors> errors() const;
  /// How well each disk shows, in the picture with all others taken away.
  struct Evidence {
    double rim = 0;        ///< share of the rim where the picture falls by at least half the disk's contrast
    double explained = 0;  ///< share of the squares of the picture minus background that the disk takes away
    double contrast = 0;   ///< level minus background
  };
  std::vector<Evidence> evidence() const;

 private:
  struct Window {
    int x0, x1, y0, y1;
  };
  Window window(const Disk& disk) const;
  /// Calls visit(x, y, index) for the pixels of a disk's window.
  template <class Visit> void each(const Disk& disk, Visit&& visit) const {
    const Window w = window(disk);
    for (int y = w.y0; y <= w.y1; ++y)
      for (int x = w.x0; x <= w.x1; ++x) visit(x, y, image_.index(x, y));
  }
  /// How a disk covers a pixel: its share C, edge = dC/dr, and the direction from the centre.
  struct Cover {
    double share, edge = 0;
    Vec2 outward = {};
  };
  Cover cover(const Disk& disk, int x, int y) const;
  void spread(const Disk& disk, double sign);
  void spread_all();
  double left(std::size_t pixel) const;
  double alone(const Disk& disk, Vec2 place) const;
  double step(Disk& disk);
  /// The nodes of the net between which a place lies, and what each adds to its background.
  std::array<std::pair<std::size_t, double>, 4> shares(Vec2 place) const;
  void fit_background();
  void fit_blur();
  void measure_noise();
  void draw_background();
  std::vector<char> near_disks() const;
  void start_background();

  const FloatImage& image_;
  bool bright_;
  std::optional<double> between_;
  std::vector<Disk> disks_;
  double blur_, noise_ = 0;
  int spacing_ = 32, columns_ = 0, rows_ = 0;
  std::vector<double> node_;  ///< background at the net's nodes
  std::vector<float> background_, covered_, light_;
};

/// The smallest radius of which a blurred picture still shows a rim and not a spot, pixels.
inline double least_resolved(const DiskModel& model) { return 2.5 * model.blur(); }

}  // namespace arenite::imaging
