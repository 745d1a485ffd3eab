#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <ranges>

#include "core/problems.hpp"
#include "core/text.hpp"
#include "study_parts.hpp"

namespace arenite::app {
namespace {

namespace fs = std::filesystem;

/// A word of a shell script.
std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

/// The study's name as Slurm shows it: no character that a shell or Slurm reads as anything but itself.
std::string job_name(const fs::path& recipe) {
  std::string name =
      recipe.stem() == "recipe" ? fs::absolute(recipe).parent_path().filename().string() : recipe.stem().string();
  std::ranges::replace_if(
      name, [](char c) { return !is_name_character(c) && c != '.'; }, '_');
  return name;
}

/// Of Slurm: minutes, minutes:seconds, hours:minutes:seconds, days-hours and so on.
void check_wall_time(const std::string& time) {
  if (time.find_first_not_of("0123456789:-") != time.npos || time.find_first_of("0123456789") == time.npos)
    throw InputError(
        "--time is not a wall time of Slurm; give it as hours:minutes:seconds, such as 24:00:00, or days-hours");
}

/// A path in a line of options, where quotes hold blanks and nothing holds a line break; % would name a part of the
/// job.
std::string quoted_option(const fs::path& path) {
  std::string text = "\"";
  for (const char c : path.string()) {
    if (static_cast<unsigned char>(c) < ' ' || c == '"' || c == '\\')
      refuse(path.string(),
             "its name holds a quote, a backslash or a control character, which options of Slurm cannot; rename it");
    text += c == '%' ? "%%" : std::string(1, c);
  }
  return text;
}

}  // namespace

std::string slurm_script(const StudyArguments& arguments, const campaign::StudyFolder& folder) {
  check_wall_time(arguments.time);
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path out = fs::absolute(folder.out);
  std::string line =
      fmt::format("{} study run {} --out {} --store {} --keep {} --checkpoint-every {:g} --threads {}",
                  quoted(error ? "arenite" : program.string()), quoted(fs::absolute(arguments.recipe).string()),
                  quoted(out.string()), quoted(fs::absolute(folder.store).string()), arguments.keep,
                  arguments.checkpoint_seconds, arguments.threads);
  if (arguments.quiet) line += " --quiet";
  for (const auto& assignment : arguments.overrides) line += " --set " + quoted(assignment);
  return fmt::format(
      "#!/bin/bash\n"
      "#SBATCH --job-name={0}\n"
      "#SBATCH --array=1-{1}\n"
      "#SBATCH --time={2}\n"
      "#SBATCH --cpus-per-task={3}\n"
      "#SBATCH --requeue\n"
      "#SBATCH --open-mode=append\n"
      "#SBATCH --signal=B:TERM@120\n"
      "#SBATCH --output={4}/slurm-%A-%a.log\"\n"
      "# Each task does its part of the runs, {3} at a time. Two minutes before the wall time, or when the task is "
      "asked to end, runs write\n"
      "# checkpoints and exit, and the task is queued again: it continues where it stopped.\n"
      "{5} --shard \"$SLURM_ARRAY_TASK_ID/{1}\" --jobs {6} &\n"
      "run=$!\n"
      "stopped=\n"
      "trap 'stopped=1; kill -TERM $run 2>/dev/null' TERM INT\n"
      "wait $run\n"
      "status=$?\n"
      "if [ -n \"$stopped\" ]; then\n"
      "  wait $run\n"
      "  status=$?\n"
      "  [ $status -eq 1 ] && scontrol requeue \"${{SLURM_ARRAY_JOB_ID}}_${{SLURM_ARRAY_TASK_ID}}\"\n"
      "fi\n"
      "exit $status\n",
      job_name(arguments.recipe), arguments.tasks, arguments.time,
      arguments.jobs * static_cast<std::size_t>(arguments.threads), quoted_option(out), line, arguments.jobs);
}

}  // namespace arenite::app
