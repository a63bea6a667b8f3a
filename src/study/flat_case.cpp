#include "flat_case.hpp"

#include <fmt/format.h>

#include "strandyn/results/json.hpp"

namespace strandyn::study {
namespace {

void flatten(const results::Value& value, const std::string& path, FlatCase& flat) {
  if (value.members().empty() && value.entries().empty()) {
    flat[path] = results::to_text(value, -1);
    return;
  }
  for (const auto& [key, member] : value.members()) flatten(member, path.empty() ? key : path + "." + key, flat);
  for (std::size_t i = 0; i < value.entries().size(); ++i) {
    flatten(value.entries()[i], fmt::format("{}.{}", path, i), flat);
  }
}

}  // namespace

FlatCase flat_case(const results::Value& as_run) {
  FlatCase flat;
  flatten(as_run, "", flat);
  return flat;
}

std::optional<KeyDifference> first_difference(const FlatCase& first, const FlatCase& second) {
  const auto value = [](const FlatCase& flat, const std::string& key) {
    const auto found = flat.find(key);
    return found == flat.end() ? std::string("not given") : found->second;
  };
  for (const FlatCase* side : {&first, &second}) {
    for (const auto& [key, ignored] : *side) {
      if (value(first, key) != value(second, key)) return KeyDifference{key, value(first, key), value(second, key)};
    }
  }
  return std::nullopt;
}

}  // namespace strandyn::study
