#pragma once
/// \file Enums with their words, and the ones that several rooms share.
///
/// A function beside the enum spells it:    constexpr auto words_of(Grading) { return std::array{Named{...}, ...}; }

#include <array>
#include <string_view>

namespace strandyn {

template <class E>
struct Named {
  E value;
  std::string_view name;
};

enum class Dimension { planar, spatial };
constexpr auto words_of(Dimension) {
  return std::array{Named{Dimension::planar, "planar"}, Named{Dimension::spatial, "spatial"}};
}

enum class MassMatrix { lumped, consistent };
constexpr auto words_of(MassMatrix) {
  return std::array{Named{MassMatrix::lumped, "lumped"}, Named{MassMatrix::consistent, "consistent"}};
}

/// What a path of equilibrium is stepped by.
enum class Control { load, displacement, arc_length };
constexpr auto words_of(Control) {
  return std::array{Named{Control::load, "load"}, Named{Control::displacement, "displacement"},
                    Named{Control::arc_length, "arc-length"}};
}

/// All words of an enum, in the order in which help lists them.
template <class E>
inline constexpr auto choices = words_of(E{});

/// The word of a value.
template <class E>
constexpr std::string_view name_of(E value) {
  for (const auto& choice : choices<E>) {
    if (choice.value == value) return choice.name;
  }
  return {};
}

}  // namespace strandyn
