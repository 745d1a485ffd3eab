#pragma once
#include <string>
#include <vector>

#include "model/result.hpp"

namespace arenite::report {

/// One stored state on the way of a loading. Strains are compression positive, since the state before the stage.
struct CoursePoint {
  std::string stage, label;
  double time = 0;                           ///< s
  double strain_x = 0, strain_y = 0;         ///< 1 - width/start, 1 - height/start
  double volume_strain = 0;                  ///< 1 - area/start: negative where the sample dilates
  double pressure = 0, deviator = 0;         ///< Pa: mean and half the difference of the principal stresses
  double ratio = 0;                          ///< q/p = sin of the mobilised angle of friction
  double solid_fraction = 0, coordination = 0, rattlers = 0;
  double bearing_coordination = 0;           ///< without rattlers
  double anisotropy = 0;                     ///< a_c of all contacts, signed against the axis of loading, or of greatest compression where there are several
  double strong_anisotropy = 0, weak_anisotropy = 0;
  double strong_share = 0;                   ///< of contacts above the mean force
  double deviator_on_strong = 0;             ///< share of the deviator that they carry
  double mobilisation = 0;                   ///< mean |F_t|/F_n
};

/// The course through `stages` in their order; of the first one the reference is its own first state.
std::vector<CoursePoint> course(const std::vector<StageResult>& stages);

}  // namespace arenite::report
