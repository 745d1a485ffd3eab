#pragma once
#include <map>
#include <string>
#include <vector>

#include "campaign/study_folder.hpp"
#include "statistics/numbers.hpp"

namespace arenite::campaign {

using statistics::Estimate;

/// A single number of a run by its dotted name ("texture.coordination"), with its meaning or that of the group it is
/// in.
struct FlatNumber {
  std::string name;
  Estimate estimate;
  const Meaning* meaning = nullptr;
};
/// All of them, in the run's order; it must outlive them. {"value", "error"} is one number; of lists those of at most
/// four numbers are taken (tensors, counted from 0), and those of things with a "name", by it.
std::vector<FlatNumber> flat_numbers(const Numbers& numbers);

/// Runs as rows: first the swept keys, then numbers. Empty cells are empty texts and numbers that are not known of a
/// run.
struct CollectedTable {
  struct Row {
    std::string run, status;          ///< empty in means
    std::vector<std::string> values;  ///< by key, without the unit that the whole column has
    std::size_t runs = 1;             ///< that the row is the mean of
    std::vector<Estimate> numbers;
  };
  struct Key {
    std::string name, unit;  ///< unit empty where values have none, or several
    std::string words = {};  ///< the name as one would say it (key_words.hpp); empty: as it is
  };
  std::vector<Key> keys;
  std::vector<std::string> names;           ///< of the numbers
  std::map<std::string, Meaning> meanings;  ///< of those that a statistic declares
  std::vector<Row> rows;
  bool means = false;

  /// Heads are names; a unit that the name does not end with stands behind it: "modulus_Pa", "stress.0.0 [Pa]".
  std::string csv() const;
  std::string json() const;
  std::string unit_of_number(const std::string& name) const;  ///< empty where it has none, or none is declared
};

CollectedTable collect(const Study& study, const StudyFolder& folder);

/// The rows with equal values of `keys` as one: means over runs, and their standard errors from the scatter of the runs
/// (none of one run). Throws InputError for a key that is not swept.
CollectedTable averaged(const CollectedTable& table, const std::vector<std::string>& keys);

}  // namespace arenite::campaign
