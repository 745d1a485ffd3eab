#include "report/print/animation.hpp"

#include <fmt/core.h>

#include <optional>

#include "core/error.hpp"
#include "core/mapped.hpp"
#include "core/text.hpp"

namespace arenite::report {
namespace {

constexpr int least_side = 100, longest_side = 4000;
constexpr PictureSize usual{800, 800}, usual_with_curve{1200, 800};

std::string in_words(const PictureSize& size) { return fmt::format("{}x{}", size.width, size.height); }

bool can_be_shown(int side) { return side >= least_side && side <= longest_side; }

/// "640x480" as 640 and 480.
std::optional<PictureSize> size_in(const std::string& text) {
  const std::size_t cross = text.find('x');
  if (cross == std::string::npos) return std::nullopt;
  const PictureSize size{parse_number<int>(text.substr(0, cross)).value_or(0),
                         parse_number<int>(text.substr(cross + 1)).value_or(0)};
  return can_be_shown(size.width) && can_be_shown(size.height) ? std::optional(size) : std::nullopt;
}

const std::string no_size = fmt::format("is not a size; give {} to {} pixels for width and height, e.g. {}", least_side,
                                        longest_side, in_words(usual_with_curve));

}  // namespace

const std::vector<Colouring>& colourings() {
  static const std::vector<Colouring> list{{"material", ""},
                                           {"forces", "", "bars only"},
                                           {"pressure", "kPa"},
                                           {"deviator", "kPa", "", true},
                                           {"z", "", "", true},
                                           {"velocity", "mm/s", "", true},
                                           {"displacement", "mm", "since the first state", true},
                                           {"rotation", "deg", "since the first state"},
                                           {"mobilisation", "", "", true}};
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
  v.text({"low", "Lower end of the colour scale, e.g. \"0 kPa\"; taken from the states if not given."}, animation.low);
  v.text({"high", "Upper end of the colour scale, e.g. \"200 kPa\"; taken from the states if not given."},
         animation.high);
  v.number({"fps", "States per second."}, animation.fps, "", range::between(0.01, 100));
  static const std::string size = fmt::format("Width and height in pixels; if not given {}, with a curve {}.",
                                              in_words(usual), in_words(usual_with_curve));
  v.text({"size", size}, animation.size);
  v.require(animation.size.empty() || size_in(animation.size), {"size"}, no_size);
  v.text({"curve",
          "Draw a curve beside the grains, with the current state marked: X,Y, e.g. axial_strain,top_force, or test: "
          "q/p or mu against strain."},
         animation.curve);
}

PictureSize size_of(const Animation& animation) {
  if (animation.size.empty()) return animation.curve.empty() ? usual : usual_with_curve;
  const auto size = size_in(animation.size);
  if (!size) throw InputError(animation.size + " " + no_size);
  return *size;
}

}  // namespace arenite::report
