#include "workflow/store.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "core/text.hpp"
#include "workflow/result_folder.hpp"

namespace arenite::workflow {

namespace fs = std::filesystem;

namespace {

constexpr const char* events[] = {"computed", "begun", "reused"};

/// The same bytes under another name, whole or not at all; what was there before is replaced.
void place(const fs::path& from, const fs::path& to) {
  ::unlink(to.c_str());
  if (::link(from.c_str(), to.c_str()) == 0) return;
  if (errno != EEXIST) io::write_atomically(to, io::read_file(from));  // another disk, or one without links
}

fs::path in_folder(const fs::path& folder, const std::string& hash) { return folder / hash.substr(0, 2) / hash; }

}  // namespace

fs::path stored_file(const fs::path& store, const std::string& hash) { return in_folder(store, hash).string() + ".h5"; }

Store::Store(fs::path folder, std::function<void(const std::string&)> notice)
    : folder_(std::move(folder)),
      account_(std::in_place, (make_folder(folder_ / "locks"), folder_ / "account"), std::move(notice)) {}

std::unique_ptr<const Store> Store::for_parts() const { return std::unique_ptr<const Store>(new Store(this)); }

fs::path Store::file(const std::string& hash) const { return stored_file(folder_, hash); }
fs::path Store::checkpoint(const std::string& hash) const {
  make_folder(folder_ / hash.substr(0, 2));
  return in_folder(folder_, hash).string() + ".checkpoint";
}
bool Store::has(const std::string& hash) const { return ::access(file(hash).c_str(), F_OK) == 0; }
bool Store::is_busy(const std::string& hash) const { return io::FileLock::is_held(folder_ / "locks" / hash); }
std::optional<io::FileLock> Store::try_claim(const std::string& hash) const {
  return io::FileLock::try_take(folder_ / "locks" / hash);
}

bool Store::fetch(const std::string& hash, const fs::path& to) const {
  if (!has(hash)) return false;
  place(file(hash), to);
  return true;
}

void Store::put(const std::string& hash, const fs::path& from) const {
  make_folder(folder_ / hash.substr(0, 2));
  place(from, file(hash));
  ::unlink(checkpoint(hash).c_str());
}

void Store::drop(const std::string& hash) const { ::unlink(file(hash).c_str()); }

void Store::note(Event event, const PlannedStage& stage, double seconds) const {
  if (account_)
    account_->add(
        fmt::format("{}\t{}\t{}\t{:.6g}", events[static_cast<std::size_t>(event)], stage.hash, stage.name, seconds));
}

StoreAccount read_account(const fs::path& store) {
  StoreAccount account;
  std::vector<std::string> reused;
  std::map<std::string, std::string> name_of;
  io::read_log(store / "account", [&](std::string_view line) {
    const auto a = line.find('\t'), b = line.find('\t', a + 1), c = line.rfind('\t');
    if (a == line.npos || b == line.npos || c <= b) return;
    const std::string_view event = line.substr(0, a);
    const std::string hash(line.substr(a + 1, b - a - 1));
    const double seconds = parse_number<double>(line.substr(c + 1)).value_or(0);
    if (event == "reused") return reused.push_back(hash);
    account.cost[hash] += seconds;
    account.seconds_computed += seconds;
    if (event != "computed") return;
    ++account.computed;
    name_of[hash] = line.substr(b + 1, c - b - 1);
  });
  for (const auto& [hash, name] : name_of) {
    account.by_name[name].sum += account.cost[hash];
    ++account.by_name[name].count;
  }
  account.reused = reused.size();
  for (const auto& hash : reused)
    if (const auto at = account.cost.find(hash); at != account.cost.end()) account.seconds_saved += at->second;
  return account;
}

}  // namespace arenite::workflow
