#pragma once
#include <optional>
#include <vector>

#include "thermal/imaging/disk_model.hpp"
#include "thermal/imaging/grain_search.hpp"

namespace arenite::imaging {

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
  std::vector<char> open_pixels(double smallest) const;
  std::vector<Circle> candidates() const;
  double inset(double ring) const;
  std::size_t nearest_class(double radius) const;
  bool collides(double x, double y, double radius) const;
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
  std::vector<double> ring_;     ///< for each disk the radius at which its rim was seen
  std::vector<Circle> refused_;  ///< taken out at the end of a pass, so that others may take their place
};

}  // namespace arenite::imaging
