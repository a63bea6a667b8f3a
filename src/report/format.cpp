#include "strandyn/report/format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace strandyn::report {
namespace {

/// Decimal exponent after rounding to `digits`: 9.9996 has 1 at four digits.
int exponent_of(double value, int digits) {
  const std::string scientific = fmt::format("{:.{}e}", value, digits - 1);
  int exponent = 0;
  const char* start = scientific.data() + scientific.find('e') + 1;
  if (*start == '+') ++start;
  std::from_chars(start, scientific.data() + scientific.size(), exponent);
  return exponent;
}

bool is_plain(int exponent) {
  return exponent >= -4 && exponent < 6;
}

std::string superscript(int number) {
  static constexpr std::array<std::string_view, 10> digits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string out = number < 0 ? "⁻" : "";
  for (const char c : std::to_string(std::abs(number))) out += digits[static_cast<std::size_t>(c - '0')];
  return out;
}

/// Unit suffixes of keys, the longer before those they end with.
constexpr std::array<std::pair<std::string_view, std::string_view>, 40> unit_suffixes = {{
    {"_N_s_per_m2", "N s/m²"},
    {"_N_s_per_m", "N s/m"},
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
}};

}  // namespace

std::string significant(double value, int digits) {
  if (value == 0) return "0";
  const int exponent = exponent_of(value, digits);
  if (!is_plain(exponent)) return fmt::format("{:.{}e}", value, digits - 1);
  return fmt::format("{:.{}f}", value, std::max(0, digits - 1 - exponent));
}

std::string typeset(double value, int digits) {
  std::string text = significant(std::abs(value), digits);
  if (const auto e = text.find('e'); e != std::string::npos) {
    text = text.substr(0, e) + "×10" + superscript(exponent_of(value, digits));
  }
  return (value < 0 ? "−" : "") + text;
}

Prefix prefix_for(double magnitude) {
  static constexpr std::array<Prefix, 7> prefixes = {
      {{1e9, "G"}, {1e6, "M"}, {1e3, "k"}, {1, ""}, {1e-3, "m"}, {1e-6, "µ"}, {1e-9, "n"}}};
  magnitude = std::abs(magnitude);
  if (magnitude == 0) return {};
  // Half a unit of the fourth digit is given away: 0.99996 is shown as 1.000, not as 1000 m.
  for (const Prefix& prefix : prefixes) {
    if (magnitude >= prefix.factor * 0.99995) return prefix;
  }
  return prefixes.back();
}

bool takes_prefix(std::string_view unit) {
  static constexpr std::array<std::string_view, 12> units = {"N",  "J",   "W",   "m",   "s",   "Hz",
                                                             "Pa", "J/m", "W/m", "N/m", "N m", "m/s"};
  return std::find(units.begin(), units.end(), unit) != units.end();
}

Quantity quantity(double value, std::string_view unit, int digits) {
  if (!takes_prefix(unit)) return {typeset(value, digits), std::string(unit)};
  const Prefix prefix = prefix_for(value);
  return {typeset(value / prefix.factor, digits), std::string(prefix.symbol) + std::string(unit)};
}

Label label_of(std::string_view key) {
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

std::string duration(double seconds, bool tenths) {
  if (tenths && seconds < 9.95) return fmt::format("{:.1f} s", seconds);
  const auto whole = static_cast<long long>(std::llround(seconds));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  const long long minutes = std::llround(seconds / 60);
  return fmt::format("{} h {:02} min", minutes / 60, minutes % 60);
}

}  // namespace strandyn::report
