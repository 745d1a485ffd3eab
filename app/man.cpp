#include <fmt/core.h>

#include <algorithm>
#include <memory>

#include "commands.hpp"
#include "core/text.hpp"
#include "core/version.hpp"
#include "io/export/export.hpp"
#include "io/film/formats.hpp"
#include "io/image/image.hpp"
#include "io/sample/formats.hpp"
#include "io/volume/volume.hpp"
#include "print.hpp"
#include "recipe/film_recipe.hpp"
#include "recipe/recipe.hpp"
#include "report/figure_list.hpp"

namespace arenite::app {
namespace {

/// Text in roff: its special characters are escaped.
std::string roff(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\') {
      result += "\\e";
    } else if (c == '-') {
      result += "\\-";
    } else if ((c == '.' || c == '\'') && (result.empty() || result.back() == '\n')) {
      result += std::string("\\&") + c;
    } else {
      result += c;
    }
  }
  return result;
}

std::string usage(const CommandText& command) {
  std::string line = "arenite " + command.name;
  for (const auto& argument : command.arguments) {
    if (argument.names.empty()) line += argument.required ? " " + argument.value : " [" + argument.value + "]";
  }
  return line + " [OPTIONS]";
}

std::string section(const CommandText& command) {
  std::string text = fmt::format(".SS {}\n{}.\n", roff(usage(command)), roff(command.sentence));
  for (const auto& argument : command.arguments) {
    std::string label = list_of(argument.names);
    if (!argument.value.empty()) label += (label.empty() ? "" : " ") + argument.value;
    text += fmt::format(".TP\n.B {}\n{}", roff(label), roff(argument.sentence));
    if (!argument.choices.empty()) text += fmt::format(" (one of: {})", roff(list_of(argument.choices)));
    text += "\n";
  }
  return text;
}

void print_page(const std::vector<CommandText>& tree) {
  print(".TH ARENITE 1 \"\" \"arenite {}\" \"User commands\"\n", roff(version));
  print(".SH NAME\narenite \\- micromechanics of composite and cemented granular materials\n");
  print(".SH SYNOPSIS\n.B arenite\n.I COMMAND\n[...]\n.SH COMMANDS\n");
  for (const auto& command : tree) print("{}", section(command));
  print(
      ".SH EXIT STATUS\n"
      ".TP\n.B 0\nDone.\n"
      ".TP\n.B 2\nBad input: each problem is one line on stderr, with its place and how to fix it.\n"
      ".TP\n.B 3\nNot converged, or a claim failed; the state reached is reported and kept.\n"
      ".TP\n.B 1\nAnything else.\n");
}

/// A table in Markdown of a family of formats: the heads of its columns, and what each format has in them.
template <class Family, class Row>
void print_formats(const char* title, const std::vector<std::string>& heads, const Family& all, Row row) {
  print("\n## {}\n\n| {} |\n|{}\n", title, list_of(heads, " | "),
        list_of(std::vector<std::string>(heads.size(), "---|"), ""));
  for (const auto* format : all) print("| `{}` | {} |\n", format->name, list_of(row(*format), " | "));
}

/// What the formats of a family state, a row for each thing; formats that state nothing have none.
template <class Family> void print_statements(const char* heads, const Family& all) {
  if (std::ranges::none_of(all, [](const auto* format) { return format->states.begin() != format->states.end(); }))
    return;
  print("\n| format | {} |\n|---|---|---|\n", heads);
  for (const auto* format : all)
    for (const io::Stated& row : format->states) print("| `{}` | {} | {} |\n", format->name, row.what, row.done);
}

constexpr const char* read_heads = "a file states | what is done with it";

void print_format_reference() {
  using Cells = std::vector<std::string>;
  const auto yes = [](bool holds) { return std::string(holds ? "yes" : ""); };
  print(
      "# File formats\n\nThis page is generated from the declarations of the formats: `arenite man --formats`. "
      "[extend.md](extend.md) adds one; results of Arenite are\ndescribed in [hdf5.md](hdf5.md). Files are recognised "
      "by their content.\n");
  print_formats(
      "Films", {"format", "what it is", "endings of new films", "written", "temperatures", "several datasets"},
      io::films::all, [&](const io::FilmFormat& f) {
        const Cells endings = {std::string(f.endings[0]), std::string(f.endings[1])};
        return Cells{std::string(f.sentence), endings[1].empty() ? endings[0] : list_of(endings),
                     yes(f.create != nullptr), yes(f.create != nullptr && !f.levels_only), yes(f.has_datasets)};
      });
  print_statements(read_heads, io::films::all);
  print_formats("Pictures", {"format", "what it is", "exact values", "several datasets"}, io::pictures::all,
                [&](const io::PictureFormat& f) {
                  return Cells{std::string(f.sentence), yes(!f.blurs), yes(f.has_datasets)};
                });
  print_statements(read_heads, io::pictures::all);
  print_formats("Volumes", {"format", "what it is", "known as a sample in space"}, io::volumes::all,
                [&](const io::VolumeFormat& f) {
                  return Cells{std::string(f.sentence), f.always ? "by its content" : "by --dimension 3"};
                });
  print_statements(read_heads, io::volumes::all);
  print_formats("Grains and contacts", {"format", "grains", "contacts"}, io::samples::all,
                [](const io::SampleFormat& f) {
                  return Cells{std::string(f.grains_are), std::string(f.contacts_are)};
                });
  print_statements(read_heads, io::samples::all);
  print_formats("Exports", {"format", "what for", "fields on nodes", "samples in space"}, io::exports::all,
                [&](const io::ExportFormat& f) {
                  return Cells{std::string(f.sentence), yes(f.of_field != nullptr), yes(f.of_voxels != nullptr)};
                });
  print_statements("of a state | what its files hold", io::exports::all);
}

}  // namespace

void add_man(Options& command, int&) {
  const auto keys = std::make_shared<bool>(false), film_keys = std::make_shared<bool>(false),
             figure_keys = std::make_shared<bool>(false), formats = std::make_shared<bool>(false);
  command.add("--keys", *keys, "Print the reference of all keys of a recipe instead (Markdown)");
  command.add("--film-keys", *film_keys, "Print the reference of all keys of a film's recipe instead (Markdown)");
  command.add("--figure-keys", *figure_keys, "Print the reference of all keys of figures.toml instead (Markdown)");
  command.add("--formats", *formats, "Print the reference of all file formats instead (Markdown)");
  command.footer = "To read the page: arenite man | man -l -";
  command.work = [keys, film_keys, figure_keys, formats] {
    if (*keys) print("{}", recipe::key_reference());
    else if (*film_keys) print("{}", recipe::film_key_reference());
    else if (*figure_keys) print("{}", report::figure_key_reference());
    else if (*formats) print_format_reference();
    else print_page(command_texts());
  };
}

}  // namespace arenite::app
