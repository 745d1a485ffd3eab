#include <fmt/core.h>

#include <filesystem>

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

}  // namespace

std::string slurm_script(const StudyArguments& arguments, const campaign::StudyFolder& folder) {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path out = fs::absolute(folder.out);
  std::string line = fmt::format("{} study run {} --out {} --store {} --keep {} --checkpoint-every {:g} --threads {}",
                                 quoted(error ? "arenite" : program.string()), quoted(fs::absolute(arguments.recipe).string()), quoted(out.string()),
                                 quoted(fs::absolute(folder.store).string()), arguments.keep, arguments.checkpoint_seconds, arguments.threads);
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
      "#SBATCH --output={4}/slurm-%A-%a.log\n"
      "# Each task does its part of the runs, {3} at a time. Two minutes before the wall time, or when the task is asked to end, runs write\n"
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
      fs::path(arguments.recipe).stem().string() == "recipe" ? fs::absolute(arguments.recipe).parent_path().filename().string()
                                                             : fs::path(arguments.recipe).stem().string(),
      arguments.tasks, arguments.time, arguments.jobs * static_cast<std::size_t>(arguments.threads), out.string(), line, arguments.jobs);
}

}  // namespace arenite::app
