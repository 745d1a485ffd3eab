#include "report/figure_heads.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "core/mapped.hpp"
#include "report/figures/field_figures.hpp"
#include "report/figures/figure_document.hpp"
#include "report/figures/film_figures.hpp"
#include "report/figures/over_runs.hpp"
#include "report/figures/run_figures.hpp"
#include "report/figures/stage_figures.hpp"
#include "report/figures/state_figures.hpp"

namespace arenite::report::figures {
namespace {

const Head coarse_fields{
    "coarse-fields",
    "coarse-fields",
    "Coarse-grained fields",
    {"Fields of the state shown, or of the nearest state that has them: averages over a kernel about as wide as a "
     "grain, which satisfy the balances of mass and momentum.",
     "Stress includes its kinetic part; compression is positive, except for the shear stress. Arrows: velocity."}};
const Head coarse_slices{
    "coarse-fields",
    "coarse-fields",
    "Coarse-grained fields",
    {"Slices of fields of the state shown, or of the nearest state that has them: averages over a kernel about as wide "
     "as a grain, which satisfy the balances of mass and momentum.",
     "Stress includes its kinetic part; compression is positive, except for shear stresses."},
    true};
const Head film_maps{"film-maps",
                     "beside-simulation",
                     "Experiment and simulation: \u03c3_{norm} of every grain",
                     {"Each normalised by its own mean, on one colour scale.",
                      "A film shows the difference between two loads (peak to peak); the state at the largest load "
                      "also includes the stress at the smallest load."},
                     true};
const Head film_fit{"film-fit",
                    "film-fit",
                    "Measured warming and its fit by contact forces",
                    {"Warming with the load as measured, as predicted from the contact forces (through lens and "
                     "pixels), and the residual; one scale, peak to peak.",
                     "The fit leaves out pixels at rims and contacts, which are shown here."},
                    true};

template <class Data> void add_heads(std::vector<Head>& to, const std::vector<Row<Data>>& list) {
  for (const Row<Data>& row : list) to.push_back(row.head);
}

/// Those of these ids, in their order; all must be named.
std::vector<Head> in_order(const std::vector<Head>& heads, const std::vector<std::string>& ids) {
  std::vector<Head> out;
  for (const std::string& id : ids) out.push_back(*std::ranges::find(heads, id, &Head::id));
  for (const Head& head : heads)
    if (std::ranges::find(ids, head.id) == ids.end()) throw std::logic_error(head.id + " has no place on the page");
  return out;
}

}  // namespace

std::vector<Head> packing_heads() {
  std::vector<Head> all{coarse_fields};
  add_heads(all, state_figures());
  add_heads(all, stage_figures());
  add_heads(all, run_figures());
  return in_order(all,
                  {"cycles",          "test-curves",     "discharge", "collapse",      "surface-angle", "grain-bonds",
                   "fabric",          "sigma-norm",      "forces",    "grain-scatter", "size-curve",    "coarse-fields",
                   "coordination",    "contact-numbers", "rev",       "threshold",     "stress-path",   "wall-forces",
                   "boundary-forces", "travel",          "energies",  "equilibrium"});
}

template <class Data> std::vector<Head> heads_of(const std::vector<Row<Data>>& list) {
  std::vector<Head> all;
  add_heads(all, list);
  return all;
}

std::vector<Head> field_heads() { return heads_of(field_figures()); }
std::vector<Head> voxel_heads() { return heads_of(voxel_figures()); }
std::vector<Head> sphere_heads() {
  std::vector<Head> all = heads_of(sphere_figures());
  all.insert(std::ranges::find(all, std::string("rev"), &Head::id), coarse_slices);
  return all;
}
std::vector<Head> heads_over_runs() { return heads_of(figures_over_runs()); }

std::vector<Head> film_heads() {
  std::vector<Head> all{film_maps, film_fit};
  add_heads(all, film_figures());
  return in_order(all, {"film-maps", "film-simulation", "film-tails", "film-orientations", "film-fit", "film-forces",
                        "film-certainty", "film-stresses"});
}

Numbers heads_of_parts() {
  const auto all = [](const std::vector<Head>& heads) {
    return Numbers(mapped(heads, [](const Head& head) { return numbers_of(head); }));
  };
  return {{"stage", all(packing_heads())},
          {"field", all(field_heads())},
          {"voxels", all(voxel_heads())},
          {"spheres", all(sphere_heads())},
          {"film", all(film_heads())}};
}

}  // namespace arenite::report::figures
