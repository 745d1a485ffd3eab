#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "core/parameters.hpp"
#include "solid/raster/cavities.hpp"
#include "recipe/recipe.hpp"

namespace arenite::study {

/// The words that a recipe, a command line and Python share for a choice, in the order of its enumeration.
const std::vector<Word>& words(cement::CementParameters::Kind);
const std::vector<Word>& words(peridynamics::Loading);
const std::vector<Word>& words(peridynamics::LowerEdge);
const std::vector<Word>& words(peridynamics::Method);
const std::vector<Word>& words(Load::Axis);
const std::vector<Word>& words(raster::Cavity);

/// The word for a value.
template <class Enum>
std::string word_of(Enum value) {
  return std::string(words(value)[static_cast<std::size_t>(value)].word);
}

/// All words without their sentences, as a check of a command line wants them.
template <class Enum>
std::vector<std::string> plain_words() {
  std::vector<std::string> plain;
  for (const Word& each : words(Enum{})) plain.emplace_back(each.word);
  return plain;
}

/// The value that a word stands for. Throws InputError, which calls the choice `what`, for a word that is not among them.
template <class Enum>
Enum chosen(std::string_view word, std::string_view what) {
  const auto& known = words(Enum{});
  std::string list;
  for (std::size_t k = 0; k < known.size(); ++k) {
    if (known[k].word == word) return static_cast<Enum>(k);
    list.append(k > 0 ? ", " : "").append(known[k].word);
  }
  throw InputError(std::string(what) + " \"" + std::string(word) + "\" is not known; there are " + list);
}

}  // namespace arenite::study
