#pragma once
#include <cstdint>
#include <vector>

#include "core/vec.hpp"
#include "model/film_result.hpp"
#include "model/packing.hpp"

namespace arenite {

/// Contact forces inferred from measured stresses: `contacts` hold fn and ft (peak to peak or of the state), the rest
/// are standard errors and checks, one a contact or one a grain.
struct InferredForces {
  Contacts contacts;
  std::vector<double> fn_error, ft_error;  ///< N, one a contact
  std::vector<double> presence;            ///< probability that a contact is there (presence.hpp), one a contact
  std::vector<std::uint8_t> present;       ///< 1 for those taken as there: as many as are expected, the likeliest
  std::vector<double> idle;                ///< probability that it neither is there nor lost a force on the way
  std::vector<double> imbalance;           ///< |sum of forces| of each grain, N
  int null_space = 0;                      ///< directions of force that the data do not determine (means only)
  double residual = 0;  ///< root mean square of data minus fit over the data's and the fields' standard error
  ForceFit fit;         ///< without `load`; `picture` shows the grains whole, also where pixels were left out
};

}  // namespace arenite

namespace arenite::inference {

/// A signed picture of the thermoelastic signal, peak to peak (LockinMaps::in_phase), rows from the top.
struct ThermoelasticPicture {
  int width = 0, height = 0;
  double pixel = 0;          ///< side of a pixel, m
  Vec2 first;                ///< centre of the pixel in column 0 and row 0 (top left), m, y up
  std::vector<float> value;  ///< K: warming when the load rises
  std::vector<float> error;  ///< standard error, K; a pixel without a positive one is left out
  double common_error = 0;   ///< standard error of what all pixels are shifted by together, K; not in `error`
};

/// Normal force that the grains exert on a wall, likewise peak to peak or of the state.
struct WallLoad {
  int side = 0;                 ///< model/packing.hpp
  double force = 0, error = 0;  ///< N, compression positive
};

/// What the forces obey beside the data. A single state has f = x_1 (n + mu t) + x_2 (n - mu t) with x >= 0. The
/// difference of two states lies in no cone in general; where the small load is the share r of the large one at every
/// contact, it lies in that of mu (1 + r)/(1 - r).
enum class Inequality { none, cone };

struct ForceOptions {
  double blur = 0.5;        ///< standard deviation of the lens's Gaussian, pixels
  double rim_margin = 0.5;  ///< pixels whose centre is nearer to the rim are left out, pixels
  double contact_margin =
      2.5;  ///< nearer than this to a contact point (pixels) the fields' error grows with the cube of the
            ///< distance's inverse (unknown spread of the force); pixels nearer than half of it are left out
  double model_error = 0.02;    ///< standard error of the fields themselves, share of a grain's signal: a first guess
  bool fit_model_error = true;  ///< the guess is corrected until data and fit differ as their errors say; what it came
                                ///< to is reported, and what the measured errors alone say of the fit
  bool fit_factors =
      false;  ///< the factor of every material is an unknown, too: how many times larger the film asks for
  double factor_error = 0;   ///< standard error of the materials' factors as given, relative, which their fitted ones
                             ///< obey; 0: fitted freely, or exact
  bool own_factors = false;  ///< factors of grains scatter about that of their material (emissivity, paint); the
                             ///< scatter is fitted and in the errors
  double most_off =
      2.5;  ///< standard errors from which on what a pixel is off counts less than its square (Huber); 0: never
  double position_error = 0.1;  ///< standard error of grain centres, pixels; 0: centres are taken as exact
  double balance_error = 1e-2;  ///< standard error of a grain's balance, share of the mean contact force
  double prior = 0;  ///< elastic regularisation: standard deviation of a contact's force about the elastic solution, in
                     ///< mean contact forces; 0: 10 (next to nothing) for pixels, and for means what makes them
                     ///< likeliest (MacKay's evidence)
  Inequality inequality = Inequality::none;
  double friction = 0.5;  ///< mu of the cone
  double widest_gap = 0;  ///< between grains or to walls that are proposed as contacts, m; 0: as the proposals show
  int iterations =
      6;  ///< of forces and centres together, at most: each lowers the misfit, and they end where it falls no more
  int threads = 1;  ///< the result does not depend on their number
};

/// Grains as found (domain with thickness and periodicity), and proposed contacts, whose forces are not read. Normals
/// of contacts between grains follow from the centres. `factor` is A of every material, K/Pa; -1 K/Pa stands for a
/// picture of sigma_kk itself, in Pa. Means do not read it.
struct ForceProblem {
  const Packing& packing;
  std::vector<double> factor;
  std::vector<WallLoad> walls;
  /// Standard error of the place (m) of grains of which the data show nothing; 0 for all others, empty: all are seen.
  /// Forces on such a grain follow from its neighbours and from its balance, which holds as far as its place is known.
  std::vector<double> unseen = {};

  double unseen_error(std::size_t grain) const { return unseen.empty() ? 0 : unseen[grain]; }
  bool is_seen(std::size_t grain) const { return unseen_error(grain) <= 0; }
};

}  // namespace arenite::inference
