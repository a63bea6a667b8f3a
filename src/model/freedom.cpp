#include "strandyn/model/freedom.hpp"

#include <algorithm>

namespace strandyn::model {
namespace {

using enum Unknown;
constexpr std::array planar_unknowns = {x, y, rotation_z};
constexpr std::array spatial_unknowns = {x, y, z, rotation_x, rotation_y, rotation_z};
constexpr std::array untwisted_unknowns = {x, y, z, rotation_y, rotation_z};
constexpr std::array transverse_planar_unknowns = {y, rotation_z};
constexpr std::array transverse_spatial_unknowns = {y, z, rotation_y, rotation_z};

}  // namespace

std::span<const Unknown> unknowns_of(Freedom freedom) {
  switch (freedom) {
    case Freedom::planar:
      return planar_unknowns;
    case Freedom::spatial:
      return spatial_unknowns;
    case Freedom::spatial_untwisted:
      return untwisted_unknowns;
    case Freedom::transverse_planar:
      return transverse_planar_unknowns;
    case Freedom::transverse_spatial:
      break;
  }
  return transverse_spatial_unknowns;
}

std::optional<std::size_t> place_of(Freedom freedom, Unknown unknown) {
  const auto all = unknowns_of(freedom);
  const auto found = std::find(all.begin(), all.end(), unknown);
  if (found == all.end()) return std::nullopt;
  return static_cast<std::size_t>(found - all.begin());
}

const char* name_of(Unknown unknown) {
  constexpr std::array names = {"displacement x", "displacement y", "displacement z",
                                "rotation x",     "rotation y",     "rotation z"};
  return names[static_cast<std::size_t>(unknown)];
}

}  // namespace strandyn::model
