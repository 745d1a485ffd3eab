#pragma once
#include <string>
#include <vector>

#include "statistics/estimate.hpp"
#include "statistics/numbers.hpp"

/// What all statistics write their numbers with.
namespace arenite::statistics {

Numbers number(double value);                      ///< not known where it is not finite
Numbers numbers(const std::vector<double>& values);
Numbers matrix(const Tensor2& t);
Numbers curve(const Curve& c);                     ///< {"x", "y", "error"}

// What is not known is left out.
void put(Numbers& to, const std::string& name, const Estimate& e);   ///< {"value", "error"}
void put(Numbers& to, const std::string& name, double value);
void put(Numbers& to, const std::string& name, const TensorEstimate& t);
void put(Numbers& to, const std::string& name, const Tensor2& t);
void put(Numbers& to, const std::string& name, const ByName<Estimate>& values);

}  // namespace arenite::statistics
