#pragma once
#include <string>
#include <string_view>

namespace arenite {

/// A parameter that a sentence names, by the option that it is: option("dx") is "--dx" on the command line and `dx` in
/// Python. Sentences carry names, and the face of this process words them.
std::string option(std::string_view name);

/// How a face words the name of an option.
using OptionWords = std::string (*)(std::string_view name);
/// Instead of the command line's way: set once, before anything is asked for.
void word_options(OptionWords words);

}  // namespace arenite
