#pragma once

namespace arenite {

/// A value to 15 digits of a size, the largest that it was made of, where these end in three zeros: arithmetic on what
/// is written in decimals gives what one would write, 0.105 - 0.1 = 0.005 and not 0.0049999999999999906. Others stay.
double in_decimals(double value, double size);

}  // namespace arenite
