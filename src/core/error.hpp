#pragma once
#include <stdexcept>
#include <string>
#include <vector>

namespace arenite {

/// One thing that is wrong with the input: where it is, what is wrong, and how to fix it.
struct Problem {
  std::string file;     ///< as the user named it; empty if there is none
  int line = 0;         ///< 1-based; 0 if unknown
  int column = 0;       ///< 1-based; 0 if unknown
  std::string message;  ///< one sentence with the fix
};

/// "file:line:column: message", leaving out what is unknown.
std::string to_string(const Problem& problem);

/// Bad input: every problem found in one pass. `main` prints them and exits with status 2.
class InputError : public std::exception {
 public:
  explicit InputError(std::vector<Problem> problems);
  explicit InputError(std::string message);
  InputError(std::string file, int line, std::string message);
  const std::vector<Problem>& problems() const { return problems_; }
  const char* what() const noexcept override { return text_.c_str(); }

 private:
  std::vector<Problem> problems_;
  std::string text_;
};

/// The same problems, those without a file as problems of `file`: for who knows the name where the finder did not.
InputError in_file(const InputError& error, const std::string& file);

/// A run that cannot go on although its input could be: grains that leave what holds them, an iteration that does not
/// end. `main` prints it and exits with status 3.
class CannotGoOn : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace arenite
