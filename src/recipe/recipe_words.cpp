#include "recipe/recipe_words.hpp"

namespace arenite::study {

const std::vector<Word>& words(cement::CementParameters::Kind) {
  static const std::vector<Word> list{{"none", "nowhere"},
                                      {"bridges", "trapezia between neighbouring grains"},
                                      {"full", "in all space between the grains"},
                                      {"coating", "a layer of even thickness round every grain"},
                                      {"menisci", "between two arcs that touch both neighbours, as a liquid would be"}};
  return list;
}

const std::vector<Word>& words(peridynamics::Loading) {
  static const std::vector<Word> list{{"tension", "away from it"}, {"compression", "towards it"}, {"shear", "along it, to the right"}};
  return list;
}

const std::vector<Word>& words(peridynamics::LowerEdge) {
  static const std::vector<Word> list{{"fixed", "nothing moves"}, {"sliding", "free along the row"}};
  return list;
}

const std::vector<Word>& words(peridynamics::Method) {
  static const std::vector<Word> list{{"static_solve", "conjugate gradients with a coarse space cut by grain: seconds"},
                                      {"relaxation", "adaptive dynamic relaxation: half a minute"},
                                      {"damped", "dynamics under a fixed viscosity, as the paper does: minutes"}};
  return list;
}

const std::vector<Word>& words(Load::Axis) {
  static const std::vector<Word> list{{"y", ""}, {"x", ""}};
  return list;
}

const std::vector<Word>& words(raster::Cavity) {
  static const std::vector<Word> list{{"pore", "space between grains, matrix or empty"}, {"void", "empty space"}};
  return list;
}

}  // namespace arenite::study
