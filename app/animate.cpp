#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "core/unit_names.hpp"
#include "core/units.hpp"
#include "options.hpp"
#include "python_module.hpp"
#include "report/print/animation.hpp"

namespace arenite::app {
namespace {

struct AnimateArguments {
  KeyOptions keys{recipe::every_key<report::Animation>()};
  std::string result, out;
};

double end_of_scale(const char* option, const std::string& text, const char* unit) {
  return option_value(option, [&] { return parse_si(text, parse_unit(*unit ? unit : "1").dimension, unit); });
}

void film(const AnimateArguments& a) {
  refuse_no_result(a.result);
  report::Animation animation;
  read_options(animation, a.keys.given());
  const report::Colouring& by = report::colourings()[animation.by];
  Numbers options{{"result", a.result}, {"by", by.name}, {"fps", animation.fps}, {"chains", animation.chains}};
  for (const auto& [option, value] :
       {std::pair{"out", a.out}, {"stage", animation.stage}, {"map", animation.map}, {"curve", animation.curve}})
    if (!value.empty()) options[option] = value;
  if (!animation.low.empty()) options["low"] = end_of_scale("--low", animation.low, by.unit);
  if (!animation.high.empty()) options["high"] = end_of_scale("--high", animation.high, by.unit);
  const report::PictureSize size = report::size_of(animation);
  options["size"] = std::vector<int>{size.width, size.height};
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
  a->keys.add(command, "--low", "low").type("VALUE");
  a->keys.add(command, "--high", "high").type("VALUE");
  a->keys.add(command, "--fps", "fps");
  a->keys.add(command, "--size", "size").type("WIDTHxHEIGHT");
  a->keys.add(command, "--curve{test}", "curve").type("X,Y");
  command.work = [a] { film(*a); };
}

}  // namespace arenite::app
