#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/contacts.hpp"

namespace arenite {

/// Contact forces inferred from measured stresses: `contacts` hold fn and ft (of the swing or of the state), the rest
/// are standard errors and checks, one a contact or one a grain.
struct InferredForces {
  Contacts contacts;
  std::vector<double> fn_error, ft_error;    ///< N, one a contact
  std::vector<double> presence;              ///< probability that a contact is there (inference/presence.hpp), one a contact
  std::vector<std::uint8_t> present;         ///< 1 for those taken as there: as many as are expected, the likeliest
  std::vector<double> idle;                  ///< probability that it neither is there nor lost a force on the way
  double expected = 0, expected_error = 0;   ///< number of contacts that are there
  std::vector<double> imbalance;             ///< |sum of forces| of each grain, N
  int null_space = 0;                        ///< directions of force that the data do not determine (means only)
  std::size_t pixels = 0;                    ///< that were used
  double residual = 0;                       ///< root mean square of data minus fit over the data's and the fields' standard error
  double over_noise = 0;                     ///< the same over the measured noise alone: chi, 1 where nothing but noise is left
  double over_signal = 0;                    ///< median size of data minus fit over that of the data
  double model_error = 0;                    ///< of the fields, share of a grain's signal, with which `residual` came out
  std::vector<double> factor_scale, factor_scale_error;  ///< one a material: the film wants its factor so many times larger
  std::vector<float> fitted;                 ///< what the forces make the picture show, K; no number outside grains
  int iterations = 0;
};

}  // namespace arenite
