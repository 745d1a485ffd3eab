#include <memory>

#include "commands.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "core/unit_names.hpp"
#include "core/units.hpp"
#include "options.hpp"
#include "python_module.hpp"
#include "report/animation.hpp"

namespace arenite::app {
namespace {

struct AnimateArguments {
  KeyOptions keys{recipe::every_key<report::Animation>()};
  std::string result, out, low, high, curve, size;
};

double end_of_scale(const char* option, const std::string& text, const char* unit) {
  return option_value(option, [&] { return parse_si(text, parse_unit(*unit ? unit : "1").dimension, unit); });
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
  report::Animation animation;
  read_options(animation, a.keys.given());
  const report::Colouring& by = report::colourings()[animation.by];
  Numbers options{{"result", a.result}, {"by", by.name}, {"fps", animation.fps}, {"chains", animation.chains}};
  for (const auto& [option, value] :
       {std::pair{"out", a.out}, {"stage", animation.stage}, {"map", animation.map}, {"curve", a.curve}})
    if (!value.empty()) options[option] = value;
  if (!a.low.empty()) options["low"] = end_of_scale("--low", a.low, by.unit);
  if (!a.high.empty()) options["high"] = end_of_scale("--high", a.high, by.unit);
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
  a->keys.add(command, "--by", "by").type("WHAT");
  a->keys.add(command, "--chains", "chains");
  a->keys.add(command, "--stage", "stage").type("NAME");
  a->keys.add(command, "--map", "map").type("NAME");
  command.add("--low", a->low, "Lower end of the colour scale, e.g. \"0 kPa\"; taken from the states if not given")
      .type("VALUE");
  command.add("--high", a->high, "Upper end of the colour scale, e.g. \"200 kPa\"; taken from the states if not given")
      .type("VALUE");
  a->keys.add(command, "--fps", "fps");
  command.add("--size", a->size, "Size in pixels (default: 800x800, with a curve 1200x800)").type("WIDTHxHEIGHT");
  command
      .add("--curve{test}", a->curve,
           "Draw a curve beside the grains, with the current state marked: X,Y, e.g. axial_strain,top_force, or test: "
           "q/p or mu against strain")
      .type("X,Y");
  command.work = [a] { film(*a); };
}

}  // namespace arenite::app
