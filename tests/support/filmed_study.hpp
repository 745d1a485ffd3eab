#pragma once
#include <fstream>

#include "campaign/study.hpp"
#include "campaign/virtual_film.hpp"
#include "support/virtual_film.hpp"
#include "workflow/store.hpp"

namespace arenite::test {

/// A study of one run, the sample of a virtual film, which is done, and a camera.
class FilmedStudy {
 public:
  explicit FilmedStudy(const VirtualFilm& example) : folder_(example.at("study")) {
    std::ofstream(example.at("study.toml"))
        << slurp(example.states() + "/recipe.toml") << "\n[sweep]\nreplicates = 1\n";
    study_ = campaign::read_study(example.at("study.toml").string());
    const workflow::Store store(folder_.store);
    workflow::RunOptions options;
    options.out = folder();
    options.store = &store;
    converged = workflow::run(campaign::recipe_of(study_, run()), options).converged;
    camera_ = slurp(VirtualFilm::example("camera.toml"));
    camera_.replace(camera_.find("frames = 2960"), 13, "frames = 300\nwidth = 96\nheight = 96");
    camera_.replace(camera_.rfind("\"1.6 mm\""), 8, "\"1.2 mm\"");
    film_with("");
  }

  void film_with(const std::string& more) const { std::ofstream(folder_.out / "camera.toml") << camera_ << more; }
  bool make(bool stopped = false) const {
    workflow::RunOptions options;
    options.asked_to_stop = [stopped] { return stopped; };
    return campaign::make_film(study_, folder_, run(), options);
  }
  std::filesystem::path folder() const { return folder_.run(run().name); }
  std::filesystem::path file() const { return folder() / "virtual-film.hdf5"; }
  workflow::StoreAccount account() const { return workflow::read_account(folder_.store); }

  bool converged = false;

 private:
  const campaign::StudyRun& run() const { return study_.runs.front(); }

  campaign::StudyFolder folder_;
  campaign::Study study_;
  std::string camera_;
};

}  // namespace arenite::test
