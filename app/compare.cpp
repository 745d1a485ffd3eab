#include <memory>

#include "commands.hpp"
#include "options.hpp"
#include "python_module.hpp"

namespace arenite::app {
namespace {

struct CompareArguments {
  std::string a, b, out, csv;
  bool all = false;
};

void put_side_by_side(const CompareArguments& a) {
  refuse_no_result(a.a);
  refuse_no_result(a.b);
  Numbers options{{"a", a.a}, {"b", a.b}, {"all", a.all}};
  if (!a.out.empty()) options["out"] = a.out;
  if (!a.csv.empty()) options["csv"] = a.csv;
  continue_in_python("comparisons", "arenite.compare", options);
}

}  // namespace

void add_compare(Options& command, int&) {
  const auto a = std::make_shared<CompareArguments>();
  command.add("a", a->a, "Folder of a run or a film's result, or a file of it").required().type("A");
  command.add("b", a->b, "The other result").required().type("B");
  command
      .add("--out", a->out,
           "Page to write, .html: differing settings, curves of both, all numbers (default: compare.html)")
      .type("FILE");
  command.add("--csv", a->csv, "Also write all numbers as a table").type("FILE");
  command.add("--all", a->all, "Print all numbers, not only those that differ beyond two standard errors");
  command.work = [a] { put_side_by_side(*a); };
}

}  // namespace arenite::app
