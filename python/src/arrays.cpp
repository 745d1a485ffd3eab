#include "arrays.hpp"

#include <fmt/core.h>

#include <cmath>
#include <limits>

#include "core/error.hpp"

namespace arenite::python {
namespace {

const char* in_words(int dimensions) {
  constexpr const char* words[] = {"none", "one dimension", "two dimensions", "three dimensions"};
  return words[dimensions];
}

/// NumPy alone says what an array may be made of; complex numbers and text it would force into numbers are none.
template <class Array> Array numbers(const ArrayLike& values, int dimensions, const std::string& name) {
  const auto plain = py::array::ensure(unmasked(values));
  const auto refuse = [&] {
    return InputError(fmt::format("{}: give numbers as a list or an array with {}", name, in_words(dimensions)));
  };
  if (!plain || plain.ndim() != dimensions || std::string("biuf").find(plain.dtype().kind()) == std::string::npos) {
    PyErr_Clear();
    throw refuse();
  }
  auto array = Array::ensure(plain);
  if (!array) throw refuse();
  return array;
}

}  // namespace

py::object unmasked(const py::object& values) {
  if (!py::isinstance<py::array>(values) || !py::hasattr(values, "mask") || !py::hasattr(values, "filled"))
    return values;
  if (!values.attr("mask").attr("any")().cast<bool>()) return values.attr("data");
  const py::dtype type = py::array(values).dtype();
  const bool holds_none = type.kind() == 'f';
  const py::object floating = holds_none ? values : values.attr("astype")(type.itemsize() <= 2 ? "float32" : "float64");
  return floating.attr("filled")(std::numeric_limits<double>::quiet_NaN());
}

Doubles doubles(const ArrayLike& values, int dimensions, const std::string& name) {
  return numbers<Doubles>(values, dimensions, name);
}
Floats floats(const ArrayLike& values, int dimensions, const std::string& name) {
  return numbers<Floats>(values, dimensions, name);
}

std::vector<double> to_vector(const ArrayLike& values, const std::string& name) {
  const Doubles array = doubles(values, 1, name);
  return {array.data(), array.data() + array.size()};
}

std::vector<double> finite_numbers(const ArrayLike& values, const std::string& name) {
  auto numbers = to_vector(values, name);
  for (std::size_t k = 0; k < numbers.size(); ++k)
    if (!std::isfinite(numbers[k]))
      throw InputError(fmt::format("{}[{}] is {}; give finite numbers", name, k, numbers[k]));
  return numbers;
}

std::vector<std::int32_t> whole_numbers(const ArrayLike& values, std::int32_t least, std::int32_t most,
                                        const std::string& name, int dimensions) {
  const Doubles array = doubles(values, dimensions, name);
  std::vector<std::int32_t> whole(static_cast<std::size_t>(array.size()));
  for (std::size_t k = 0; k < whole.size(); ++k) {
    const double value = array.data()[k];
    if (!(value >= least && value <= most) || value != std::floor(value))
      throw InputError(
          fmt::format("{}: {} is among the values; give whole numbers from {} to {}", name, value, least, most));
    whole[k] = static_cast<std::int32_t>(value);
  }
  return whole;
}

}  // namespace arenite::python
