#pragma once
/// \file Names of columns and keys taken apart: what in words, and the unit.

#include <string>
#include <string_view>
#include <vector>

namespace strandyn::results {

struct Label {
  std::string name;
  std::string unit;  ///< "J/m"; empty where the key names none
};

/// friction_dissipation_J -> "friction dissipation", "J"; EI_min_N_m2 -> "EI_min", "N m²"; the time is t_s. Of a path
/// ("steady.friction_J") the last key is taken apart.
Label label_of(std::string_view key);

/// Labels of keys that stand side by side. Parts of an energy or a power are named by what sets them apart: of
/// friction_dissipation_J and viscous_dissipation_J "friction" and "viscous".
std::vector<Label> labels_of(const std::vector<std::string>& keys);

/// True for keys of shares of a whole, which are shown in per cent: numerical_share, steady.slipping_share.
bool is_share(std::string_view key);

}  // namespace strandyn::results
