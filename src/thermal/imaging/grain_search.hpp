#pragma once
#include <optional>
#include <vector>

#include "model/image.hpp"
#include "statistics/clusters.hpp"
#include "thermal/imaging/blur.hpp"
#include "thermal/imaging/circles.hpp"
#include "thermal/imaging/disk_model.hpp"

namespace arenite::imaging {

struct RimOptions {
  bool bright = true;                  ///< disks brighter than what is around them
  double smallest = 1.6, largest = 8;  ///< radii of the steepest slope, pixels; in small disks it lies up to 1 pixel inside the rim
  double least = 0.1;                  ///< score below which a circle is not listed
  const Mask* open = nullptr;          ///< where centres can lie; null: everywhere
};

/// Circles whose rims show edges: the slope along the normal in a ring, against the root mean square slope nearby, each
/// pixel's share cut at 1 (and at -0.3 for the wrong sign), so that uneven light, unlike materials and single strong edges
/// count little. Radii go up by 5 % a step, on pictures halved until a radius is below 8 pixels. Local maxima over place and
/// radius, best first. What of a rim lies outside the picture
/// counts as not seen.
std::vector<Circle> search_rims(const FloatImage& image, const RimOptions& options);

/// Grey levels that a picture's pixels gather at, with others on both sides: what is between black and white grains may be
/// one of them. Peaks of the smoothed histogram that hold 1 % of the pixels and fall to half before the next; the fullest
/// first, the darkest and the brightest of all left out. None where there are fewer than three.
std::vector<double> levels_between(const FloatImage& image);

/// The smallest radius of which a blurred picture still shows a rim and not a spot, pixels.
double least_resolved(const DiskModel& model);

/// Marks the disks of a fitted model that the picture does not bear out: little contrast, little rim, not flat, a size that
/// makes up next to nothing (dirt), or on top of a better disk. With `strict` rims and flatness are also held against
/// those of the median disk by area, which tells a cluster of small grains from one large grain once most are found.
std::vector<char> refuted_disks(const DiskModel& model, const CircleOptions& options, bool strict);

/// Disks of a picture, and what is known of them all: classes of size are those of the model's disks, materials are not known yet.
struct DiskSearch {
  DiskModel model;
  CircleReport report;
};

/// The search of find_circles. Whether disks are brighter or darker than what is around them is decided, if it is asked,
/// by which of the two accounts for more of the picture after the first round; where the picture has a
/// level between two others (levels_between) and disks on both sides of it account for most of the rest, these are taken.
DiskSearch search_disks(const FloatImage& image, const CircleOptions& options);

/// Where rims are looked for in the first round, on the picture as it is.
RimOptions first_range(const FloatImage& image, const CircleOptions& options, bool bright);

/// The search for the disks of a picture, round by round: candidates from rims are fitted together, what the picture does
/// not bear out is taken out, and the rest of the picture is searched anew. Picture and options must outlive it.
class SearchRounds {
 public:
  /// `between`: level of the background, where disks may be brighter and darker.
  SearchRounds(const FloatImage& image, bool bright, const CircleOptions& options, std::optional<double> between = std::nullopt);

  /// The first round, with the rims that were seen in `first_range`: of both signs where there is a level between.
  void begin(std::vector<Circle> seen);

  /// Contrast squared times radius squared that the disks account for, summed.
  double gain() const;

  /// Pixels of the disks that are explained.
  double area() const;

  /// All further rounds, until nothing is left; the result, once.
  DiskSearch finish();

 private:
  void more_rounds();
  Mask open_pixels(double smallest) const;
  std::vector<Circle> candidates() const;
  double inset(double ring) const;
  std::size_t nearest_class(double radius) const;
  bool collides(const Circle& circle) const;
  bool was_refused(const Circle& circle) const;
  std::size_t add(std::vector<Circle> candidates, int round);
  void settle(int sweeps);
  void set_priors();
  void find_classes();
  void prune(bool strict = false);
  bool found_nothing_since(const std::vector<DiskModel::Disk>& last) const;

  const FloatImage& image_;
  bool bright_;
  const CircleOptions& options_;
  std::optional<double> between_;
  DiskModel model_;
  statistics::Clusters classes_;
  int rounds_ = 0;               ///< done after the first
  std::vector<Circle> refused_;  ///< taken out at the end of a pass, so that others may take their place
};

}  // namespace arenite::imaging
