#pragma once
#include <string>
#include <vector>

namespace arenite::io {

/// Levels and temperatures (K) of a calibration curve.
struct CalibrationCurve {
  std::vector<double> level, temperature;
};

/// From a CSV file with columns level and temperature, in K or, where the header says so, in degrees Celsius
/// ("temperature [C]"). Throws InputError with every bad row.
CalibrationCurve read_calibration_curve(const std::string& file);

}  // namespace arenite::io
