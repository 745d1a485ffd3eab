#pragma once
#include <string>

#include "model/result.hpp"
#include "statistics/numbers.hpp"
#include "grains/texture/texture.hpp"

// What `arenite show` prints unless it is asked for everything: a dozen numbers, each with its symbol and its meaning.
namespace arenite::report {

/// The last state of a stage.
std::string headlines(const StageResult& last, const texture::Texture& texture);

/// A result on nodes, from its numbers.
std::string field_headlines(const Numbers& numbers);

}  // namespace arenite::report
