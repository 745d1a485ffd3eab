#pragma once
#include <cstddef>
#include <vector>

#include "model/contacts.hpp"

namespace arenite {

/// Contact forces inferred from measured stresses: `contacts` hold fn and ft (of the swing or of the state), the rest
/// are standard errors and checks, one a contact or one a grain.
struct InferredForces {
  Contacts contacts;
  std::vector<double> fn_error, ft_error;    ///< N, one a contact
  std::vector<double> spurious;              ///< 1 where |fn| is within so few standard errors that the contact may be absent, else 0
  std::vector<double> imbalance;             ///< |sum of forces| of each grain, N
  int null_space = 0;                        ///< directions of force that the data do not determine (means only)
  std::size_t pixels = 0;  ///< that were used
  double residual = 0;                       ///< root mean square of data minus fit over the data's standard error
  int iterations = 0;
};

}  // namespace arenite
