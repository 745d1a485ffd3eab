#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "statistics/estimate.hpp"

/// Pieces of JSON that all statistics are written with; for the sources that write JSON, not for other headers.
namespace arenite::statistics {

using Json = nlohmann::ordered_json;

Json number(double value);                      ///< null where it is not known
Json numbers(const std::vector<double>& values);
Json matrix(const Tensor2& t);
Json curve(const Curve& c);                     ///< {"x", "y", "error"}

// What is not known is left out.
void put(Json& to, const std::string& name, const Estimate& e);   ///< {"value", "error"}
void put(Json& to, const std::string& name, double value);
void put(Json& to, const std::string& name, const TensorEstimate& t);
void put(Json& to, const std::string& name, const Tensor2& t);
void put(Json& to, const std::string& name, const ByName<Estimate>& values);

}  // namespace arenite::statistics
