#pragma once
/// \file What the shell and `man` are told of the command line, made from the declarations that --help shows.

#include <CLI/CLI.hpp>
#include <string>

namespace strandyn::app {

/// A script that completes verbs, options and the names of conductors in a shell: "bash", "zsh" or "fish".
/// Throws InputError for another one.
std::string completion(const CLI::App& program, const std::string& shell);

/// The page of the manual, in the macros of man(7).
std::string manual(const CLI::App& program, const std::string& version);

}  // namespace strandyn::app
