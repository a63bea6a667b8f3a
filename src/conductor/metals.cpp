#include "strandyn/conductor/metals.hpp"

#include <cctype>
#include <string>

namespace strandyn::conductor {
namespace {

constexpr Metal aluminium{.young = 68e9, .poisson = 0.33, .density = 2703};
constexpr Metal alloy{.young = 68e9, .poisson = 0.33, .density = 2703};
constexpr Metal steel{.young = 207e9, .poisson = 0.3, .density = 7780};
constexpr Metal clad_steel{.young = 162e9, .poisson = 0.3, .density = 6590};

}  // namespace

const Metal* find_metal(std::string_view grade) {
  std::string name;
  for (const char c : grade) name += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  if (name == "AL1") return &aluminium;
  if (name.size() == 3 && name.starts_with("AL") && name[2] >= '2' && name[2] <= '7') return &alloy;
  if (name == "20SA") return &clad_steel;
  if (name.starts_with("ST") && name.size() <= 4) return &steel;
  return nullptr;
}

}  // namespace strandyn::conductor
