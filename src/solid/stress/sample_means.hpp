#pragma once
#include <optional>

#include "model/field_quantities.hpp"
#include "model/result.hpp"
#include "model/voxel_quantities.hpp"
#include "solid/stress/options.hpp"
#include "solid/stress/selection.hpp"

namespace arenite::stress {

/// Those that the stored statistics of a field were measured with; the usual ones where there are none.
StressOptions options_of(const FieldResult& sample);

/// Means of a loaded sample, which pictures on the page and in print are centred about and stresses are divided by:
/// those that are stored with its statistics, and of what has none over the same nodes.
class SampleMeans {
 public:
  /// The sample has to outlive it.
  explicit SampleMeans(const FieldResult& sample) : sample_(sample) {}
  double of(const FieldQuantity& quantity) const;  ///< not a number where the field has it not
  /// The component of stress of the largest mean, by which the load acts: sigma_yy in tension along the clamps, the
  /// shear stress where the sample is sheared. Null where there is none.
  const FieldQuantity* strongest() const;
  /// What a strong stress is measured by, Pa: the size of that mean; 1 where there is none.
  double scale() const;

 private:
  const FieldResult& sample_;
  mutable std::optional<Selection> nodes_;  ///< chosen where a mean is asked for that is not stored
};

/// The same of a sample in space.
double sample_mean(const VoxelResult& sample, const VoxelQuantity& quantity);

}  // namespace arenite::stress
