#include "strandyn/results/label.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace strandyn::results {
namespace {

/// Unit suffixes of keys, the longer before those they end with.
constexpr std::array<std::pair<std::string_view, std::string_view>, 43> unit_suffixes = {{
    {"_N_s_per_m2", "N s/m²"},
    {"_N_s_per_m", "N s/m"},
    {"_kg_m_per_s", "kg m/s"},
    {"_N_s", "N s"},
    {"_kg_per_m3", "kg/m³"},
    {"_kg_per_m", "kg/m"},
    {"_N_per_mm", "N/mm"},
    {"_N_per_m", "N/m"},
    {"_W_per_m", "W/m"},
    {"_J_per_m", "J/m"},
    {"_m_per_s", "m/s"},
    {"_rad_per_m", "rad/m"},
    {"_per_mm", "1/mm"},
    {"_per_m", "1/m"},
    {"_kg_m2", "kg m²"},
    {"_N_m2", "N m²"},
    {"_kN_m", "kN m"},
    {"_N_m", "N m"},
    {"_mm4", "mm⁴"},
    {"_mm2", "mm²"},
    {"_m4", "m⁴"},
    {"_m2", "m²"},
    {"_um", "µm"},
    {"_mm", "mm"},
    {"_km", "km"},
    {"_m", "m"},
    {"_MN", "MN"},
    {"_kN", "kN"},
    {"_N", "N"},
    {"_mJ", "mJ"},
    {"_J", "J"},
    {"_mW", "mW"},
    {"_W", "W"},
    {"_Hz", "Hz"},
    {"_ms", "ms"},
    {"_s", "s"},
    {"_deg", "°"},
    {"_rad", "rad"},
    {"_GPa", "GPa"},
    {"_MPa", "MPa"},
    {"_Pa", "Pa"},
    {"_kg", "kg"},
    {"_B", "B"},
}};

/// Columns whose keys are a letter or a symbol.
struct Name {
  std::string_view key, name, unit;
};
constexpr std::array<Name, 6> names = {{{"t_s", "time", "s"},
                                        {"x_m", "position", "m"},
                                        {"arc_m", "position along the span", "m"},
                                        {"at_m", "distance", "m"},
                                        {"theta_rad", "angle around the lay", "rad"},
                                        {"theta_deg", "angle around the lay", "°"}}};

}  // namespace

Label label_of(std::string_view key) {
  if (const auto dot = key.rfind('.'); dot != std::string_view::npos) {
    const Label last = label_of(key.substr(dot + 1));
    const Label whole = label_of(key.substr(0, dot));
    if (last.unit.empty() && !whole.unit.empty()) return {whole.name + " " + last.name, whole.unit};
    return {std::string(key.substr(0, dot + 1)) + last.name, last.unit};
  }
  for (const auto& [short_key, name, unit] : names) {
    if (key == short_key) return {std::string(name), std::string(unit)};
  }
  // Symbols of the section keep their underscore: they are names, not words.
  const auto words = [](std::string_view name) {
    std::string text(name);
    if (!text.starts_with("EI_") && !text.starts_with("C_") && !text.starts_with("M_") && !text.starts_with("chi_")) {
      std::replace(text.begin(), text.end(), '_', ' ');
    }
    return text;
  };
  for (const auto& [suffix, unit] : unit_suffixes) {
    if (key.size() > suffix.size() && key.ends_with(suffix)) {
      return {words(key.substr(0, key.size() - suffix.size())), std::string(unit)};
    }
  }
  return {words(key), ""};
}

std::vector<Label> labels_of(const std::vector<std::string>& keys) {
  std::vector<Label> labels;
  for (const std::string& key : keys) labels.push_back(label_of(key));
  const auto last_word = [](const Label& label) {
    const auto blank = label.name.rfind(' ');
    return blank == std::string::npos ? std::string() : label.name.substr(blank);
  };
  std::vector<Label> shorter = labels;
  for (Label& label : shorter) {
    const std::string word = last_word(label);
    if (word.empty() || (!label.unit.starts_with("J") && !label.unit.starts_with("W"))) continue;
    const auto shared = std::count_if(labels.begin(), labels.end(), [&](const Label& other) {
      return other.unit == label.unit && last_word(other) == word;
    });
    if (shared > 1) label.name.resize(label.name.size() - word.size());
  }
  for (std::size_t i = 0; i < shorter.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (shorter[i].name == shorter[k].name && shorter[i].unit == shorter[k].unit) return labels;
    }
  }
  return shorter;
}

bool is_share(std::string_view key) {
  return key == "share" || key.ends_with(".share") || key.ends_with("_share");
}

}  // namespace strandyn::results
