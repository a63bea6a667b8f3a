#pragma once
/// \file Slips of the pen on the command line: a verb or an option that is nearly one.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace strandyn::app {

/// What is wrong with the first unknown verb or option of a command line, and what was meant; nothing where all are
/// known. Arguments of options and files are not looked at.
std::optional<std::string> find_slip(const CLI::App& program, int argc, const char* const* argv);

}  // namespace strandyn::app
