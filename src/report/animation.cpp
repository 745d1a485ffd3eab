#include "report/animation.hpp"

#include "core/mapped.hpp"

namespace arenite::report {

const std::vector<Colouring>& colourings() {
  static const std::vector<Colouring> list{{"material", ""},
                                           {"forces", "", "bars only"},
                                           {"pressure", "kPa"},
                                           {"deviator", "kPa"},
                                           {"z", ""},
                                           {"velocity", "mm/s"},
                                           {"displacement", "mm", "since the first state"},
                                           {"rotation", "deg", "since the first state"},
                                           {"mobilisation", ""}};
  return list;
}

void declare(ParameterVisitor& v, Animation& animation) {
  int by = static_cast<int>(animation.by);
  v.choice({"by", "Quantity that colours the grains."}, by, mapped(colourings(), [](const Colouring& each) {
             return Word{each.name, each.sentence};
           }));
  animation.by = static_cast<std::size_t>(by);
  v.flag({"chains", "Also draw contact forces as bars over the grains."}, animation.chains);
  v.text({"stage", "Only the states of this stage; all if not given."}, animation.stage);
  v.text({"map", "Colour map of Matplotlib, e.g. viridis."}, animation.map);
  v.number({"fps", "States per second."}, animation.fps, "", range::between(0.01, 100));
}

}  // namespace arenite::report
