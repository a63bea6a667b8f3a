#pragma once
/// \file Numbers and units as a person reads them.

#include <string>
#include <string_view>

namespace strandyn::report {

/// `digits` significant digits: 0.001234, 12.34, 123457, but 1.234e-06 and 1.234e+07 where plain digits would hide the
/// size. Digits left of the point are never rounded away.
std::string significant(double value, int digits = 4);

/// The same for a page: a true minus sign, 1.234×10⁻⁶ instead of 1.234e-06.
std::string typeset(double value, int digits = 4);

/// A power of thousand in front of a unit.
struct Prefix {
  double factor = 1;        ///< shown value = value / factor
  std::string_view symbol;  ///< "m", "k"; "µ" or, for plain terminals, "u"
};

/// The prefix, from nano to giga, that brings `magnitude` to 1 ... 1000; none for zero.
Prefix prefix_for(double magnitude);

/// True for units that take a prefix (N, J, W, m, s, Hz, J/m, N m ...), false for the others (1/m, m², kg/m, none).
bool takes_prefix(std::string_view unit);

/// A value ready for a page.
struct Quantity {
  std::string number;
  std::string unit;
};

/// 47.15 and "MN" for 4.715e7 and "N".
Quantity quantity(double value, std::string_view unit, int digits = 4);

/// 75 -> "1 min 15 s"; 4000 -> "1 h 07 min"; below ten seconds with one decimal where `tenths`.
std::string duration(double seconds, bool tenths = false);

}  // namespace strandyn::report
