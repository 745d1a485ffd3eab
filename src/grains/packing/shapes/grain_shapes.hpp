#pragma once
#include <concepts>
#include <variant>

#include "grains/packing/shapes/clump.hpp"
#include "grains/packing/shapes/disk.hpp"
#include "grains/packing/shapes/polygon.hpp"

namespace arenite::packing {

/// What a family of shapes gives: its word in recipes, its own parameters, equality, and a shape, of any size and anywhere.
template <class S>
concept MakesShapes = std::default_initializable<S> && std::equality_comparable<S> && requires(S shape, ParameterVisitor& visitor) {
  { S::word } -> std::convertible_to<Word>;
  { shape.declare(visitor) } -> std::same_as<void>;
  { shape.make() } -> std::same_as<Shape>;
};
template <MakesShapes... Each> using GrainShapes = std::variant<Each...>;

/// The shapes there are, the usual one first. A new one is a file beside these and a word here: recipe keys, their documentation and hashes follow.
using GrainShape = GrainShapes<DiskShape, ClumpShape, PolygonShape>;

}  // namespace arenite::packing
