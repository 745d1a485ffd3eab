#include <memory>

#include "commands.hpp"
#include "core/units.hpp"
#include "options.hpp"
#include "python_module.hpp"

namespace arenite::app {
namespace {

struct FiguresArguments {
  std::string result, out, width;
  std::vector<std::string> formats{"pdf"}, only;
};

void draw(const FiguresArguments& a) {
  refuse_neither_result_nor_study(a.result);
  Numbers options{{"result", a.result}, {"formats", a.formats}};
  if (!a.only.empty()) options["only"] = a.only;
  if (!a.out.empty()) options["out"] = a.out;
  if (!a.width.empty())
    options["width"] = option_value("--width", [&] { return parse_si(a.width, dimension::length, "mm"); });
  continue_in_python("figures", "arenite.figures", options);
}

}  // namespace

void add_figures(Options& command, int&) {
  const auto a = std::make_shared<FiguresArguments>();
  command.add("result", a->result, "Folder of a run, a film's result or a study, or a file of it")
      .required()
      .type("RESULT");
  command.add("--out", a->out, "Folder to write to (default: figures in the result's folder)").type("DIR");
  command.add("--format", a->formats, "Formats: pdf, svg, png; several may be given")
      .among({"pdf", "svg", "png"})
      .type("FORMAT");
  command.add("--only", a->only, "Names of the figures to draw; all if not given").type("NAME");
  command.add("--width", a->width, "Width, e.g. \"85 mm\" (default: 85 mm for one column, 175 mm for two)")
      .type("LENGTH");
  command.work = [a] { draw(*a); };
}

}  // namespace arenite::app
