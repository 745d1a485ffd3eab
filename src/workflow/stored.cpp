#include "workflow/stored.hpp"

#include <chrono>
#include <thread>

#include "core/version.hpp"

namespace arenite::study {

namespace fs = std::filesystem;

bool Claim::taken_from_store(const fs::path& file) {
  const Store* const store = options_.store;
  if (!store) return false;
  lock_.reset();
  while (!store->fetch(stage_.hash, file)) {
    lock_ = store->try_claim(stage_.hash);
    if (lock_) {
      // It may have come between the look and the lock.
      if (!store->fetch(stage_.hash, file)) break;
      lock_.reset();
      return true;
    }
    if (options_.asked_to_stop()) {
      stopped = true;
      return false;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  began_ = std::clock();
  return !lock_;
}

fs::path Claim::checkpoint(const fs::path& without_store) const {
  return options_.store ? options_.store->checkpoint(stage_.hash) : without_store;
}

void Claim::computed(const fs::path& file) const {
  if (!options_.store) return;
  options_.store->put(stage_.hash, file);
  options_.store->note_computed(stage_, seconds());
}

void Claim::interrupted() const {
  if (options_.store) options_.store->note_begun(stage_, seconds());
}

Provenance provenance_of(const Recipe& recipe, std::size_t s, const PlannedStage& stage, const std::string& kernel) {
  Provenance p;
  p.version = version;
  p.stage = stage.name;
  p.input_hash = stage.hash;
  p.recipe = to_toml(part_of(recipe, s));
  p.seed = recipe.seed;
  p.kernel = kernel;
  return p;
}

}  // namespace arenite::study
