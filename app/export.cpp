#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <vector>

#include "commands.hpp"
#include "print.hpp"
#include "workflow/export_result.hpp"

namespace arenite::app {
namespace {

struct ExportArguments {
  std::string result, format, out;
  bool last = false;
};

/// The folder of the result, or of its file, and in it one named after the format.
std::filesystem::path default_folder(const ExportArguments& a) {
  const std::filesystem::path result(a.result);
  return (std::filesystem::is_directory(result) ? result : result.parent_path()) / io::export_named(a.format)->name;
}

void write_export(const ExportArguments& a) {
  refuse_no_result(a.result);
  const auto folder = a.out.empty() ? default_folder(a) : std::filesystem::path(a.out);
  std::vector<std::filesystem::path> left_out;
  const auto files = workflow::export_result(a.result, *io::export_named(a.format), folder, a.last, &left_out);
  print("{} {} in {}; the last is {}\n", files.size(), files.size() == 1 ? "file" : "files", folder.string(),
        files.back().filename().string());
  for (const auto& file : left_out)
    print(stderr, "left out, for {} does not hold it: {}\n", a.format, file.filename().string());
}

}  // namespace

void add_export(Options& command, int&) {
  const auto arguments = std::make_shared<ExportArguments>();
  std::string sentences = "Format";
  for (const auto* format : io::exports::all) {
    std::string names(format->name);
    for (const std::string_view other : format->other_names)
      if (!other.empty()) names += fmt::format(" or {}", other);
    sentences += fmt::format("; {}: {}", names, format->sentence);
  }
  command.add("result", arguments->result, "Stage file (.h5) or folder of a run").required().type("RESULT");
  command.add("--to", arguments->format, sentences).required().among(io::export_names());
  command.add("--out", arguments->out, "Folder to write to; default: one named after the format, beside the result")
      .type("DIR");
  command.add("--last", arguments->last, "Export the last state only, not the whole loading");
  command.work = [arguments] { write_export(*arguments); };
}

}  // namespace arenite::app
