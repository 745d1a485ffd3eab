#pragma once
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "model/film_result.hpp"

namespace arenite::workflow {
struct RunOutcome;
}  // namespace arenite::workflow

namespace arenite::report {

/// A result in a few numbers: what made it, how every stage ended, and the last state with its walls, equilibrium,
/// energies and texture. The JSON's texture is the one stored with the result, or measured now if none is. Where the
/// run went on to nodes, the numbers are those of the last result on them; of a film, they are the film's.
class Summary {
 public:
  /// Reads a stage file or the stage files of a run's folder. Throws InputError for anything else.
  explicit Summary(const std::filesystem::path& result);
  /// The same of a run that has just ended.
  explicit Summary(const workflow::RunOutcome& outcome);

  std::string text() const;  ///< for people: how the stages ended, and the headlines, each with its meaning
  std::string all() const;   ///< for people: every number
  Numbers numbers() const;   ///< for programs: the texture's fields, or a field's numbers with "texture", and
                             ///< "provenance" and "stages" beside them

 private:
  std::string how_stages_ended() const;
  /// What is told of a stage of disks or spheres.
  struct Stage {
    std::string file;
    ResultHead head;
    std::size_t states = 0;
    Numbers texture, last_state, test;
    std::vector<std::string> loads, doubts;
    std::string state_text;
  };
  struct Field {
    std::string file;
    ResultHead head;
    Numbers numbers;
  };
  template <int D> void add(const std::filesystem::path& file, const StageResultIn<D>& stage);
  void add(const std::filesystem::path& file, const ResultHead& head, const Numbers& numbers);
  const ResultHead& last() const;
  /// A stage of the plane ends with what the next begins with.
  void keep_before(const Packing& packing);
  void keep_before(const PackingIn<3>& packing);
  std::vector<Stage> stages_;
  std::vector<Field> fields_;  ///< after the stages
  std::vector<FilmResult> films_;
  std::optional<Packing> before_;
};

/// One result on a grid by itself, of the plane or of space, as text for people and as numbers; `numbers` are those
/// that it carries.
std::string field_summary(const ResultHead& result, const Numbers& numbers);
Numbers field_numbers(const ResultHead& result, Numbers numbers);

}  // namespace arenite::report
