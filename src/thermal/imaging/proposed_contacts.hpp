#pragma once
#include <type_traits>
#include <vector>

#include "model/packing.hpp"

namespace arenite::imaging {

/// How wide a gap may be that is still offered as a contact: `errors` times the gap's standard error plus `floor`
/// pixels. Contacts under load overlap, so only errors open them; what is offered in excess is for the inversion to
/// find empty.
struct ContactTolerance {
  double errors = 3;
  double floor = 0.2;     ///< pixels: what errors of position do not tell of (distortion, grains that are not round)
  double pixel = 0;       ///< width of a pixel on the sample, m; 0: no floor
  double wall_error = 0;  ///< standard error of a wall's position, m
};

/// Standard errors of grains found in a picture, m, one a grain; an empty array: none.
struct GrainErrors {
  std::vector<double> position;  ///< of the centre along one axis
  std::vector<double> radius;
};

/// Contacts between grains, and with the walls that are present, whose surfaces are no farther apart than the
/// tolerance: grains first, by (i, j), then walls by side. Forces are 0, `overlap` is minus the gap (below 0 where
/// surfaces are apart), and a contact lies in the middle of the overlap, on a wall in its plane. Periodic sides are
/// honoured, sheared cells too. Linear in the number of grains. Throws InputError where arrays disagree in length or
/// hold values that are no numbers.
template <int D>
ContactsIn<D> propose_contacts(const GrainsIn<D>& grains, const std::type_identity_t<DomainIn<D>>& domain,
                               const GrainErrors& errors = {}, const ContactTolerance& tolerance = {});

}  // namespace arenite::imaging
