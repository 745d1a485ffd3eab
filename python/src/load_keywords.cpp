#include "load_keywords.hpp"

namespace arenite::python {

const Keywords& load_keywords() {
  static const Keywords keywords(recipe::every_key<recipe::Load>(), {{"loading", "loading", "", true},
                                                                     {"strain", "strain"},
                                                                     {"axis", "axis"},
                                                                     {"lower", "lower"},
                                                                     {"method", "method"},
                                                                     {"element", "element"},
                                                                     {"plane", "plane"},
                                                                     {"matrix_poisson", "poisson.matrix"},
                                                                     {"interface_poisson", "poisson.interface"},
                                                                     {"particle_poisson", "poisson.particle"},
                                                                     {"tolerance", "tolerance"},
                                                                     {"moduli", "moduli"},
                                                                     {"effective_stiffness", "effective_stiffness"},
                                                                     {"failure", "failure"},
                                                                     {"matrix", "stiffness.matrix"},
                                                                     {"interface", "stiffness.interface"},
                                                                     {"particle", "stiffness.particle"},
                                                                     {"horizon_in_space", "horizon_in_space"},
                                                                     {"stop_at_voids", "stop_at_voids"},
                                                                     {"exact_stretch", "exact_stretch"},
                                                                     {"toughness", "toughness.matrix"},
                                                                     {"strength", "strength.matrix"},
                                                                     {"cracks_stay_open", "cracks_stay_open"},
                                                                     {"max_strain", "max_strain"}});
  return keywords;
}

recipe::Load load_of(const char* function, const std::string& loading, const py::kwargs& more) {
  auto given = load_keywords().given(function, more);
  given.push_back(load_keywords().given("loading", py::str(loading)));
  recipe::Load load;
  read_keywords(load, given);
  warn_of_idle(load.idle_keys());
  load.name = load.failure ? "failure" : recipe::word_of(load.loading);
  return load;
}

}  // namespace arenite::python
