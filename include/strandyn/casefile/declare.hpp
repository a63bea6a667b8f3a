#pragma once
/// \file What the declaration of a key may say. A visitor turns it into a parser, an echo or a schema.

#include <numbers>
#include <optional>
#include <string>

namespace strandyn::casefile {

/// Unit of a key in the case file. `suffix` ends the key's name.
struct Unit {
  const char* suffix = "";
  const char* words = "";  ///< for a sentence
  double si = 1;           ///< SI value of one such unit

  /// For si < 1 by division: 3.52 mm becomes the double nearest to 0.00352, as 1/1e-3 is exactly 1000.
  double to_si(double x) const { return si < 1 ? x / (1 / si) : x * si; }
  double from_si(double x) const { return si < 1 ? x * (1 / si) : x / si; }
};

namespace units {
inline constexpr Unit none{};
inline constexpr Unit m{"m", "metres", 1};
inline constexpr Unit mm{"mm", "millimetres", 1e-3};
inline constexpr Unit mm2{"mm2", "square millimetres", 1e-6};
inline constexpr Unit per_m{"per_m", "1/m", 1};
inline constexpr Unit deg{"deg", "degrees", std::numbers::pi / 180};
inline constexpr Unit s{"s", "seconds", 1};
inline constexpr Unit per_s{"", "1/s", 1};
inline constexpr Unit stiffness_s{"", "seconds", 1};
inline constexpr Unit Hz{"Hz", "hertz", 1};
inline constexpr Unit m_per_s{"m_per_s", "metres per second", 1};
inline constexpr Unit N{"N", "newtons", 1};
inline constexpr Unit kN{"kN", "kilonewtons", 1e3};
inline constexpr Unit N_m{"N_m", "newton metres", 1};
inline constexpr Unit N_m2{"N_m2", "N m^2", 1};
inline constexpr Unit N_per_mm{"N_per_mm", "newtons per millimetre of wire", 1e3};
inline constexpr Unit N_per_m{"N_per_m", "N/m", 1};
inline constexpr Unit N_s_per_m{"N_s_per_m", "N s/m", 1};
inline constexpr Unit N_s_per_m2{"N_s_per_m2", "N s/m^2", 1};
inline constexpr Unit m2_per_s{"m2_per_s", "m^2/s", 1};
inline constexpr Unit celsius{"C", "Celsius", 1};
inline constexpr Unit GPa{"GPa", "gigapascals", 1e9};
inline constexpr Unit kg{"kg", "kilograms", 1};
inline constexpr Unit kg_m{"kg_m", "kg m", 1};
inline constexpr Unit kg_m2{"kg_m2", "kg m^2", 1};
inline constexpr Unit kg_per_m{"kg_per_m", "kilograms per metre", 1};
inline constexpr Unit kg_per_m3{"kg_per_m3", "kilograms per cubic metre", 1};
}  // namespace units

/// A number. Bounds are in the unit of the file. The type of the field says whether it must be whole.
struct Number {
  const char* help;  ///< what it is, as a noun: "the distance between the supports"
  Unit unit = units::none;
  std::optional<double> above = {};
  std::optional<double> at_least = {};
  std::optional<double> below = {};
  std::optional<double> at_most = {};
  bool not_zero = false;
  int multiple_of = 0;
  std::optional<double> otherwise = {};  ///< of a field that may be absent: what is then taken, if it is a number
  const char* word = nullptr;            ///< a word that leaves the field empty: "auto"
  bool required = false;
  bool whole = false;  ///< for a column of a row; of a field the type says it
};

/// Any other kind of key.
struct Plain {
  const char* help;
  bool required = false;
  bool depends = false;            ///< what is taken where it is absent depends on the case, as `help` says
  const char* old_name = nullptr;  ///< by which case files may still call it
};

/// A group of keys that exclude each other.
struct OneOf {
  bool required = false;
  bool false_counts = false;  ///< `key = false` gives the key; else it gives nothing, as `per_length = false`
};

/// "must be above 0", or nothing: the first demand that `x` (in the unit of the file) does not meet.
std::optional<std::string> find_fault(const Number& number, double x);

/// "the distance between the supports in metres"; the unit stands before the first comma or bracket of the help.
std::string describe(const Number& number);

}  // namespace strandyn::casefile
