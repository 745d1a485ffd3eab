#pragma once
#include <stdexcept>

namespace arenite {

/// A run that cannot go on although its input could be: grains that leave what holds them, an iteration that does not
/// end. `main` prints it and exits with status 3.
class CannotGoOn : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace arenite
