#pragma once
#include <string>
#include <vector>

namespace arenite::identify {

/// A record of a test as it was measured: y against x, both SI, with the line of the file that each point stands in.
struct Curve {
  std::string file;               ///< for messages
  std::string name;               ///< of the test ("specimen 2"); empty where a file holds one
  std::vector<double> x, y;
  std::vector<int> line;          ///< as long as x and y
};

}  // namespace arenite::identify
