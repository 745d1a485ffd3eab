#include "core/option.hpp"

namespace arenite {
namespace {

std::string on_the_command_line(std::string_view name) { return "--" + std::string(name); }

OptionWords words_of_this_process = on_the_command_line;

}  // namespace

std::string option(std::string_view name) { return words_of_this_process(name); }

void word_options(OptionWords words) { words_of_this_process = words; }

}  // namespace arenite
