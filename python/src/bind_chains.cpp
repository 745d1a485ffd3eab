#include <pybind11/stl.h>

#include "arrays.hpp"
#include "calls.hpp"
#include "grains/fields/force_chains.hpp"
#include "grains/fields/loops.hpp"
#include "keywords.hpp"
#include "module.hpp"

namespace arenite::python {
namespace {

/// What functions of one choice ask.
struct StrongContacts {
  double factor = 1;
};
void declare(ParameterVisitor& v, StrongContacts& asked) {
  v.number({"factor", "Contacts are strong above this multiple of the mean force."}, asked.factor, "",
           range::not_negative);
}

struct LoopsAsked {
  bool bearing_only = true;
};
void declare(ParameterVisitor& v, LoopsAsked& asked) {
  v.flag({"bearing_only", "Only contacts that bear a force count."}, asked.bearing_only);
}

const Keywords& chain_keywords() {
  static const Keywords keywords(recipe::every_key<fields::ChainOptions>(),
                                 {{"stress_factor", "stress_factor"}, {"angle", "angle", "deg"}, {"least", "least"}});
  return keywords;
}

py::dict force_chains(const Packing& packing, const py::kwargs& more) {
  fields::ChainOptions options;
  read_keywords(options, chain_keywords().given("force_chains", more));
  Call call;
  const auto found = call.without_lock([&] { return fields::find_force_chains(packing, options); });
  py::dict d;
  d["chains"] = found.chains;
  d["mean_length"] = found.mean_length;
  d["grain_share"] = found.grain_share;
  d["mean_stress_Pa"] = found.mean_stress;
  return d;
}

const Keywords& strong_keywords() {
  static const Keywords keywords(recipe::every_key<StrongContacts>(), {{"factor", "factor"}});
  return keywords;
}

py::dict strong_clusters(const Packing& packing, const py::kwargs& more) {
  StrongContacts asked;
  read_keywords(asked, strong_keywords().given("strong_clusters", more));
  Call call;
  auto found = call.without_lock([&] { return fields::strong_clusters(packing, asked.factor); });
  py::dict d;
  d["threshold_N"] = found.threshold;
  d["share"] = found.share;
  d["grains"] = found.grains;
  d["contacts"] = found.contacts_of;
  d["of"] = taken_over(std::move(found.of));
  return d;
}

const Keywords& loop_keywords() {
  static const Keywords keywords(recipe::every_key<LoopsAsked>(), {{"bearing_only", "bearing_only"}});
  return keywords;
}

py::dict loops(const Packing& packing, const py::kwargs& more) {
  LoopsAsked asked;
  read_keywords(asked, loop_keywords().given("loops", more));
  Call call;
  auto found = call.without_lock([&] { return fields::find_loops(packing, asked.bearing_only); });
  py::dict d;
  d["mean_edges"] = found.mean_edges;
  d["rattlers"] = found.rattlers;
  d["histogram"] = found.histogram;
  d["edges"] = taken_over(std::move(found.edges));
  d["area"] = taken_over(std::move(found.area));
  return d;
}

}  // namespace

void bind_chains(py::module_& m) {
  def_with_keywords(m, "force_chains", &force_chains, chain_keywords(),
                    "Force chains (Peters et al. 2005): chains (lists of grains in order), mean_length (grains), "
                    "grain_share, mean_stress_Pa.",
                    py::arg("packing"));
  def_with_keywords(
      m, "strong_clusters", &strong_clusters, strong_keywords(),
      "Clusters of grains joined by strong contacts, the largest first: threshold_N, fraction of strong contacts, "
      "grains and contacts of each, of (cluster of every grain, -1: none).",
      py::arg("packing"));
  def_with_keywords(m, "loops", &loops, loop_keywords(),
                    "Smallest cycles of the contact network without rattlers: edges (contacts of each), area (m^2), "
                    "histogram by number of contacts, mean_edges.",
                    py::arg("packing"));
}

}  // namespace arenite::python
