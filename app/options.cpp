
#include <fmt/core.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "campaign/run_study.hpp"
#include "commands.hpp"
#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "core/text.hpp"
#include "core/thread_count.hpp"
#include "core/unit_names.hpp"
#include "core/units.hpp"
#include "core/version.hpp"
#include "io/table/table.hpp"
#include "print.hpp"
#include "recipe/document.hpp"
#include "recipe/record.hpp"
#include "workflow/checkpoints.hpp"

namespace arenite::app {
namespace {

void overview() {
  std::puts("Arenite: micromechanics of composite and cemented granular materials\n\nusage: arenite COMMAND [...]\n");
  for (const auto& command : commands()) std::printf("  %-11s %s\n", command.name, command.sentence);
  std::puts(
      "\nFour workflows:\n"
      "  composite packings       arenite init composite r.toml, then arenite run r.toml\n"
      "  cemented packings        arenite init cemented r.toml, then arenite run r.toml; a map of your own: arenite "
      "load MAP\n"
      "  a loaded packing's film  arenite init film r.toml, then arenite film FILM --recipe r.toml\n"
      "  many runs                arenite init study r.toml, then arenite study run r.toml\n"
      "\nA run writes a page, report.html, in its folder; a study writes study.html, with the figures declared in a "
      "figures.toml\n"
      "beside its recipe. In Python, `import arenite` has every step as a function. More: `arenite COMMAND --help`.");
}

/// Refuses an unknown first word with the nearest command, which CLI11 does not offer.
bool unknown_command(const std::string& word) {
  if (word.starts_with('-')) return false;
  std::vector<std::string> names;
  for (const auto& command : commands()) {
    if (word == command.name) return false;
    names.emplace_back(command.name);
  }
  const std::string near = nearest(word, names);
  print(stderr, "arenite: unknown command \"{}\"; {}\n", word,
        near.empty() ? "`arenite` lists the commands" : "did you mean `arenite " + near + "`?");
  return true;
}

/// What is wrong with the command line, as one sentence; CLI11 adds a second one.
std::string complaint(const CLI::App& program, const CLI::Error& error) {
  const auto used = program.get_subcommands();
  const std::string command = used.empty() ? "arenite" : "arenite " + used.front()->get_name();
  return command + ": " + error.what() + "; `" + command + " --help` lists its options";
}

/// CLI11's way of reading each type is long to compile: flags, of which some take a word, have no numbers.
template <class T> CLI::Option* declare(CLI::App& to, const Option& option, const std::string& name, T& target) {
  if constexpr (std::is_same_v<T, bool>) return to.add_flag(name, target, option.sentence);
  else {
    if constexpr (std::is_same_v<T, std::string>)
      if (option.is_flag()) return to.add_flag(name, target, option.sentence);
    return to.add_option(name, target, option.sentence);
  }
}

/// What is wrong with a number's text, "" where nothing is: "nan" compares false with both ends of a range, and no
/// option means it.
std::string out_of_range(const Option& option, const std::string& text) {
  double value = 0;
  if (!CLI::detail::lexical_cast(text, value)) return {};  // the reading of the value says so
  if (std::isnan(value) || ((option.is_real() || option.is_number) && std::isinf(value)))
    return fmt::format("{} is no finite number", text);
  if (!option.range || (value >= option.range->first && value <= option.range->second)) return {};
  return fmt::format("Value {} not in range {} to {}", text, option.range->first, option.range->second);
}

CLI::Option* declare(CLI::App& to, const Option& option, const std::string& name) {
  CLI::Option* declared = std::visit([&](auto* target) { return declare(to, option, name, *target); }, option.to);
  if (!option.choices.empty()) declared->check(CLI::IsMember(option.choices));
  if (option.is_real() || option.is_number || option.range)
    declared->check(CLI::Validator([option](std::string& text) { return out_of_range(option, text); }, ""));
  const auto now = [former = option.former_choices](std::string& word) {
    if (const auto at = former.find(word); at != former.end()) word = at->second;
    return std::string();
  };
  if (!option.former_choices.empty()) declared->transform(CLI::Validator(now, ""));
  return declared;
}

/// Numbers of a list, or a number, without unit get this one.
std::string with_units(const std::string& text, const std::string& unit) {
  if (unit.empty() || text.empty()) return text;
  return list_of(mapped(split_commas(text),
                        [&](const std::string& part) { return io::to_number(part) ? part + " " + unit : part; }),
                 ",");
}

std::vector<std::string> names_in(const recipe::Record& section) {
  return mapped(section.tables.front(), &recipe::Record::name);
}

void declare(CLI::App& to, const Options& options) {
  for (const Option& option : options.table) {
    for (const auto& former : option.former_names) declare(to, option, former)->group("");
    CLI::Option* declared = declare(to, option, option.name);
    if (!option.value.empty()) declared->type_name(option.value);
    if (option.is_required) declared->required();
    if (option.one_at_a_time) declared->allow_extra_args(false);
  }
  for (const Option& option : options.table)
    for (const auto& other : option.without) to.get_option(option.name)->excludes(to.get_option(other));
  to.footer(options.footer);
}

}  // namespace

Option& Option::required() { return is_required = true, *this; }
Option& Option::type(std::string_view text) { return value = text, *this; }
Option& Option::among(const std::vector<std::string>& words) { return choices = words, *this; }
Option& Option::among(std::initializer_list<const char*> words) {
  return choices.assign(words.begin(), words.end()), *this;
}
Option& Option::between(double low, double high) { return range = {low, high}, *this; }
Option& Option::formerly(std::string_view former) { return former_names.emplace_back(former), *this; }
Option& Option::formerly(std::string_view word, std::string_view now) {
  return former_choices.emplace(word, now), *this;
}
Option& Option::not_with(std::string_view other) { return without.emplace_back(other), *this; }
Option& Option::each() { return one_at_a_time = true, *this; }

Option& Options::add(std::string_view name, Option::Target to, std::string_view sentence) {
  return table.emplace_back(Option{std::string(name), to, std::string(sentence), {}, {}, {}, {}, {}, {}});
}

Option& KeyOptions::add(Options& to, std::string_view name, std::string_view key, std::string_view bare_unit) {
  using Type = recipe::Record::Type;
  const recipe::Record& record = at(key);
  Slot& slot = slots_.emplace_back(Slot{
      std::string(name.substr(0, name.find('{'))), std::string(key), std::string(bare_unit), &record, {}, {}, false});
  std::string help = recipe::help_of(record);
  if (record.kind == recipe::Record::Kind::section)
    help += ", written " + list_of(names_in(record), "=VALUE,") + "=VALUE";
  Option& option = record.type == Type::flag ? to.add(name, slot.on, help) : to.add(name, slot.text, help);
  if (record.type == Type::number) option.type(record.unit.empty() ? "NUMBER" : "QUANTITY");
  if (record.type == Type::integer) option.type("N");
  option.is_number = record.type == Type::number || record.type == Type::integer;
  std::vector<std::string> words;
  for (const auto& choice : record.choices) {
    words.emplace_back(choice.word.word);
    if (!choice.word.former.empty()) option.formerly(choice.word.former, choice.word.word);
  }
  return option.among(words);
}

Option& KeyOptions::add_word(Options& to, std::string_view name, std::string_view key, std::string_view word) {
  const recipe::Record& record = at(key);
  Slot& slot =
      slots_.emplace_back(Slot{std::string(name), std::string(key), {}, &record, {}, std::string(word), false});
  return to.add(name, slot.on, recipe::help_of(record, word));
}

void KeyOptions::add_section(const Slot& slot, std::vector<recipe::Given>& given) const {
  const auto names = names_in(*slot.record);
  for (const std::string& part : split_commas(slot.text)) {
    const auto equals = part.find('=');
    const std::string name = part.substr(0, equals);
    if (equals == std::string::npos || std::ranges::find(names, name) == names.end())
      throw InputError(
          fmt::format("{}: \"{}\" is not of the form {}=VALUE", slot.name, part, list_of(names, "=VALUE,")));
    const std::string key = slot.key + "." + name;
    if (std::ranges::find(given, key, &recipe::Given::key) != given.end())
      throw refusal("{}: {} is given twice; keep one", slot.name, name);
    given.push_back({slot.name + ": " + name, key, recipe::value_of(at(key), part.substr(equals + 1))});
  }
}

std::vector<recipe::Given> KeyOptions::given(std::string_view bare_length) const {
  std::vector<recipe::Given> given;
  for (const Slot& slot : slots_) {
    if (slot.record->kind == recipe::Record::Kind::section) {
      if (!slot.text.empty()) add_section(slot, given);
      continue;
    }
    const bool is_length = !slot.record->unit.empty() && parse_unit(slot.record->unit).dimension == dimension::length;
    const std::string text =
        slot.on
            ? (slot.word.empty() ? "true" : slot.word)
            : with_units(slot.text, is_length && slot.bare_unit.empty() ? std::string(bare_length) : slot.bare_unit);
    if (!text.empty()) given.push_back({slot.name, slot.key, recipe::value_of(*slot.record, text)});
  }
  return given;
}

std::string KeyOptions::text(std::string_view key) const {
  const auto at = std::ranges::find(slots_, key, &Slot::key);
  return at == slots_.end() ? "" : at->text;
}

std::vector<std::string> KeyOptions::overrides() const {
  std::vector<std::string> set;
  for (const auto& [label, key, value] : given()) set.push_back(key + "=" + recipe::toml_literal(value));
  return set;
}

Option& add_threads(Options& to, int& threads) {
  static const recipe::RecordTable keys = recipe::every_key<Threads>();
  const recipe::Record& record = recipe::record_at(keys, "threads");
  return to.add("--threads", threads, recipe::help_of(record))
      .between(static_cast<double>(record.integers.min), static_cast<double>(record.integers.max))
      .type("N");
}

Option& add_checkpoints(Options& to, double& seconds) {
  static const recipe::RecordTable keys = recipe::every_key<workflow::Checkpoints>();
  const recipe::Record& record = recipe::record_at(keys, "checkpoint_every");
  return to.add("--checkpoint-every", seconds, recipe::help_of(record))
      .between(workflow::Checkpoints::allowed.min, workflow::Checkpoints::allowed.max)
      .type("S");
}

Option& add_jobs(Options& to, std::uint64_t& jobs) {
  static const recipe::RecordTable keys = recipe::every_key<campaign::Jobs>();
  const recipe::Record& record = recipe::record_at(keys, "jobs");
  return to.add("--jobs", jobs, recipe::help_of(record))
      .between(static_cast<double>(record.integers.min), static_cast<double>(record.integers.max))
      .type("J");
}

Option& add_retry(Options& to, bool& retry) {
  return to.add("--retry", retry, "Repeat runs that failed, or found no equilibrium");
}
Option& add_keep(Options& to, std::string& what) {
  return to
      .add("--keep", what,
           fmt::format("Keep all files, or only the numbers of cemented samples and loads (default {})", what))
      .type("WHAT")
      .among({"all", "numbers"});
}

Option& add_quiet(Options& to, bool& quiet) { return to.add("--quiet", quiet, "Show no progress"); }
Option& add_json(Options& to, bool& json) { return to.add("--json", json, "Print all numbers as JSON"); }

std::string option_name(std::string_view key) {
  std::string name = "--" + std::string(key);
  std::ranges::replace(name, '_', '-');
  return name;
}

void read_options(const std::vector<recipe::Given>& given, const Visit& declare) {
  try {
    for (const std::string& sentence : recipe::read_given(given, declare)) print(stderr, "{}\n", sentence);
  } catch (const InputError& error) {
    auto problems = error.problems();
    for (Problem& problem : problems)  // an option is no file
      if (!problem.file.empty()) problem = {"", 0, 0, problem.file + ": " + problem.message};
    throw InputError(std::move(problems));
  }
}

const Options* read_command_line(int argc, char** argv, const std::deque<Options>& tables, int& status) {
  CLI::App program("Micromechanics of composite and cemented granular materials", "arenite");
  program.set_version_flag("--version", std::string("arenite ") + version);
  program.require_subcommand(0, 1);
  std::map<const CLI::App*, const Options*> table_of;
  for (std::size_t c = 0; c < tables.size(); ++c) {
    CLI::App* const command = program.add_subcommand(commands()[c].name, commands()[c].sentence);
    declare(*command, tables[c]);
    table_of[command] = &tables[c];
  }
  if (argc > 1 && unknown_command(argv[1])) return status = bad_input, nullptr;
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return status = program.exit(error), nullptr;
    print(stderr, "{}\n", complaint(program, error));
    return status = bad_input, nullptr;
  }
  const auto named = program.get_subcommands();
  if (!named.empty()) return table_of.at(named.front());
  overview();
  return nullptr;
}

}  // namespace arenite::app
