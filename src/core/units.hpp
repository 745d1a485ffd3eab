#pragma once
#include <string>
#include <string_view>

namespace arenite {

/// Exponents of the base units kg, m, s, K; whole numbers and halves, which a double holds exactly.
struct Dimension {
  double mass = 0, length = 0, time = 0, temperature = 0;
  constexpr bool operator==(const Dimension&) const = default;
};
constexpr Dimension operator*(Dimension a, Dimension b) {
  return {a.mass + b.mass, a.length + b.length, a.time + b.time, a.temperature + b.temperature};
}
constexpr Dimension operator/(Dimension a, Dimension b) {
  return {a.mass - b.mass, a.length - b.length, a.time - b.time, a.temperature - b.temperature};
}

namespace dimension {
inline constexpr Dimension none{}, mass{1, 0, 0, 0}, length{0, 1, 0, 0}, time{0, 0, 1, 0}, temperature{0, 0, 0, 1};
inline constexpr Dimension area = length * length, volume = area * length, frequency = none / time;
inline constexpr Dimension velocity = length / time, acceleration = velocity / time, density = mass / volume;
inline constexpr Dimension force = mass * acceleration, pressure = force / area, energy = force * length;
inline constexpr Dimension stiffness = force / length, damping = force / velocity;
inline constexpr Dimension thermoelastic_factor = temperature / pressure;
inline constexpr Dimension toughness{1, -0.5, -2, 0};
}  // namespace dimension

/// A number with its unit, in SI.
struct Quantity {
  double value = 0;
  Dimension dimension;
  std::string unit;  ///< as it is written; empty for a bare number
};

/// Whether an SI value is 0 or of a magnitude, 1e-60 to 1e60, that is computed with: fourth powers of such numbers are
/// still plain doubles, and no quantity that is measured lies beyond.
bool is_in_reach(double value);

/// How many characters a number at the start of a text takes; 0 where there is none.
std::size_t number_length(std::string_view text);

/// Reads "27.35 kN/mm". Throws InputError (without place) for anything that is not one number in reach and a unit.
Quantity parse_quantity(std::string_view text);

/// The SI value of a quantity that must have `wanted` as its dimension; a bare number is refused unless the dimension
/// is none. An area may be written as two lengths, "30.9 mm x 4.9 mm". `unit` is the unit that messages suggest
/// (default: the SI unit). Throws InputError without place.
double parse_si(std::string_view text, Dimension wanted, std::string_view unit = {});

/// The value written in `unit`, shortest text that reads back as the same double: format_quantity(0.0164, "mm") = "16.4
/// mm". An empty unit gives the bare number. For units that are powers of ten of SI.
std::string format_quantity(double value, std::string_view unit);

}  // namespace arenite
