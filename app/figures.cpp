#include <memory>

#include "commands.hpp"
#include "options.hpp"
#include "python_module.hpp"
#include "report/print/print.hpp"

namespace arenite::app {
namespace {

struct FiguresArguments {
  std::string result, out;
  report::Print print;  ///< what the command line gives, but the width
  KeyOptions keys{recipe::every_key<report::Print>()};
};

void draw(FiguresArguments& a) {
  refuse_neither_result_nor_study(a.result);
  read_options(a.print, a.keys.given("mm"));
  Numbers options{{"result", a.result}, {"formats", a.print.formats}};
  if (!a.print.names.empty()) options["only"] = a.print.names;
  if (!a.out.empty()) options["out"] = a.out;
  if (a.print.width) options["width"] = *a.print.width;
  continue_in_python("figures", "arenite.figures", options);
}

}  // namespace

void add_figures(Options& command, int&) {
  const auto a = std::make_shared<FiguresArguments>();
  command.add("result", a->result, "Folder of a run, a film's result or a study, or a file of it")
      .required()
      .type("RESULT");
  command.add("--out", a->out, "Folder to write to (default: figures in the result's folder)").type("DIR");
  command.add("--format", a->print.formats, recipe::help_of(a->keys.at("formats")))
      .among(report::print_formats())
      .type("FORMAT");
  command.add("--only", a->print.names, recipe::help_of(a->keys.at("names"))).type("NAME");
  a->keys.add(command, "--width", "width").type("LENGTH");
  command.work = [a] { draw(*a); };
}

}  // namespace arenite::app
