#pragma once
/// \file From text to a validated scene. Whatever is wrong with the text is an InputError that says where, what, and
/// what would be right.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "strandyn/casefile/scene.hpp"

namespace strandyn::casefile {

/// Reads a case file. Each override is `KEY.PATH=VALUE`, the argument of --set: VALUE is TOML, a bare word is a string.
/// An override wins: it displaces the keys of the file that it excludes (tension_rts those of tension_kN), and where it
/// changes a choice (analysis.type), the keys of the file that belong to another choice fall away; a new
/// conductor.catalogue brings its own mass and rated strength.
/// Throws FileError where the file cannot be read, else InputError.
Scene read_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

/// The same from a text; `name` stands for the file in messages.
Scene read_scene_text(std::string_view text, const std::string& name, const std::vector<std::string>& overrides = {});

}  // namespace strandyn::casefile
