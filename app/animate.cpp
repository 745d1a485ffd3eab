#include <algorithm>
#include <memory>

#include "commands.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "options.hpp"
#include "python_module.hpp"

namespace arenite::app {
namespace {

struct AnimateArguments {
  std::string result, out, by = "material", stage, map, low, high, curve, size;
  double per_second = 10;
  bool chains = false;
};

/// What grains can be coloured by, and the unit of its scale.
struct Colouring {
  const char* name;
  Dimension dimension;
  const char* unit;
};
constexpr Colouring colourings[] = {{"material", dimension::none, ""},
                                    {"forces", dimension::none, ""},
                                    {"pressure", dimension::pressure, "kPa"},
                                    {"deviator", dimension::pressure, "kPa"},
                                    {"z", dimension::none, ""},
                                    {"velocity", dimension::velocity, "mm/s"},
                                    {"displacement", dimension::length, "mm"},
                                    {"rotation", dimension::none, "deg"},
                                    {"mobilisation", dimension::none, ""}};

std::vector<std::string> names() {
  std::vector<std::string> list;
  for (const Colouring& each : colourings) list.emplace_back(each.name);
  return list;
}

double end_of_scale(const char* option, const std::string& text, const std::string& by) {
  const Colouring& scale = *std::ranges::find(colourings, by, &Colouring::name);
  return option_value(option, [&] { return parse_si(text, scale.dimension, scale.unit); });
}

/// "1200x800" as 1200 and 800.
std::vector<int> width_and_height(const std::string& text) {
  const std::size_t cross = text.find('x');
  if (cross != std::string::npos) {
    const auto width = parse_number<int>(text.substr(0, cross)), height = parse_number<int>(text.substr(cross + 1));
    if (width.value_or(0) > 0 && height.value_or(0) > 0) return {*width, *height};
  }
  throw InputError("--size: " + text + " is not a size; give pixels, e.g. 1200x800");
}

void film(const AnimateArguments& a) {
  refuse_no_result(a.result);
  Numbers options{{"result", a.result}, {"by", a.by}, {"fps", a.per_second}, {"chains", a.chains}};
  for (const auto& [option, value] : {std::pair{"out", a.out}, {"stage", a.stage}, {"map", a.map}, {"curve", a.curve}})
    if (!value.empty()) options[option] = value;
  if (!a.low.empty()) options["low"] = end_of_scale("--low", a.low, a.by);
  if (!a.high.empty()) options["high"] = end_of_scale("--high", a.high, a.by);
  if (!a.size.empty()) options["size"] = width_and_height(a.size);
  continue_in_python("animations", "arenite.animate", options);
}

}  // namespace

void add_animate(Options& command, int&) {
  const auto a = std::make_shared<AnimateArguments>();
  command.add("result", a->result, "Folder of a run, or a file of it").required().type("RESULT");
  command
      .add("--out", a->out, "File to write, .mp4 (by ffmpeg) or .gif (default: animation.mp4 in the result's folder)")
      .type("FILE");
  command
      .add("--by", a->by,
           "Quantity that colours the grains (default: material); forces: bars only; displacement and rotation since "
           "the first state")
      .among(names())
      .type("WHAT");
  command.add("--chains", a->chains, "Also draw contact forces as bars over the grains");
  command.add("--stage", a->stage, "Only the states of this stage; all if not given").type("NAME");
  command.add("--map", a->map, "Colour map of Matplotlib, e.g. viridis").type("NAME");
  command.add("--low", a->low, "Lower end of the colour scale, e.g. \"0 kPa\"; taken from the states if not given")
      .type("VALUE");
  command.add("--high", a->high, "Upper end of the colour scale, e.g. \"200 kPa\"; taken from the states if not given")
      .type("VALUE");
  command.add("--fps", a->per_second, "States per second (default: 10)").between(0.01, 100).type("NUMBER");
  command.add("--size", a->size, "Size in pixels (default: 800x800, with a curve 1200x800)").type("WIDTHxHEIGHT");
  command
      .add("--curve{test}", a->curve,
           "Draw a curve beside the grains, with the current state marked: X,Y, e.g. axial_strain,top_force, or test: "
           "q/p or mu against strain")
      .type("X,Y");
  command.work = [a] { film(*a); };
}

}  // namespace arenite::app
