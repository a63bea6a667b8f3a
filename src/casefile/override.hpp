#pragma once
/// \file The arguments of --set: `load[0].amplitude_N=5`, `analysis.type=modes`, `accept."steady.loss_factor".below=1`.

#include <toml++/toml.h>

#include <string>
#include <string_view>
#include <vector>

namespace strandyn::casefile {

struct Override {
  struct Step {
    std::string key;
    std::vector<std::size_t> indices;  ///< into arrays below the key
  };
  std::vector<Step> steps;
  std::string place;     ///< "--set analysis.type=modes"
  std::string document;  ///< TOML that gives the key `value` the value
};

/// True of the `place` of an override, which also names the source of its nodes.
bool is_override(std::string_view place);

/// Throws InputError where the argument is not KEY.PATH=VALUE. A value that is no TOML but a bare word is a string.
Override parse_override(const std::string& argument);

/// Puts the value in its place; makes the tables on the way, but no elements of arrays.
void apply(const Override& change, toml::table& root);

}  // namespace strandyn::casefile
