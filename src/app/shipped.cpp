#include "shipped.hpp"

namespace strandyn::app {

std::filesystem::path shipped(const std::string& name, const std::string& installed) {
  if (std::filesystem::exists(name)) return name;
  std::error_code unknown;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", unknown);
  const std::filesystem::path there = program.parent_path().parent_path() / installed;
  if (!unknown && std::filesystem::exists(there)) return there;
  return std::filesystem::path(STRANDYN_SOURCE_DIR) / name;
}

}  // namespace strandyn::app
