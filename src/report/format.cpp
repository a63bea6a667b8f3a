#include "strandyn/report/format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

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

std::string duration(double seconds, bool tenths) {
  if (tenths && seconds < 9.95) return fmt::format("{:.1f} s", seconds);
  const auto whole = static_cast<long long>(std::llround(seconds));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  const long long minutes = std::llround(seconds / 60);
  return fmt::format("{} h {:02} min", minutes / 60, minutes % 60);
}

}  // namespace strandyn::report
