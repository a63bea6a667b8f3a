#pragma once
/// \file The words a case file may choose from, one enum per key, with their spelling in the file.

#include <array>
#include <string_view>

#include "strandyn/conductor/strand.hpp"

namespace strandyn::casefile {

using conductor::WireShape;

enum class Law { stick, slip, elastic, multilinear, masing, return_map, compliant };
enum class Grading { clamps, uniform };
enum class Support { clamped, pinned, roller, free, guided };
enum class Dimension { planar, spatial };
enum class MassMatrix { lumped, consistent };
enum class LoadType { static_force, harmonic_force, table };
enum class MotionType { static_motion, harmonic_motion, table };
enum class End { left, right };
enum class Control { load, displacement, arc_length };
enum class Method { ida, generalized_alpha };
enum class StepRule { fixed, automatic, adaptive };
enum class Twist { held, free };
enum class Until { steady };
enum class AnalysisType { section, axial_torsion, static_, modes, decay, forced, transient, sweep, self_damping };
enum class DampingMethod { quadrature, periodic, transient, foti_2018 };
enum class ModeShape { sine, clamped };
enum class BenchStart { mode, rest };
enum class WindCurve { cigre, diana_falco, brika_laneville };
enum class BalancedBy { quadrature, foti_2018, fit, published };

template <class E>
struct Named {
  E value;
  std::string_view name;
};

/// All words of an enum, in the order in which help lists them.
template <class E>
inline constexpr std::array<Named<E>, 0> choices{};

template <>
inline constexpr std::array choices<WireShape>{Named{WireShape::round, "round"},
                                               Named{WireShape::trapezoidal, "trapezoidal"}};
template <>
inline constexpr std::array choices<Law>{Named{Law::stick, "stick"},        Named{Law::slip, "slip"},
                                         Named{Law::elastic, "elastic"},    Named{Law::multilinear, "multilinear"},
                                         Named{Law::masing, "masing"},      Named{Law::return_map, "return-map"},
                                         Named{Law::compliant, "compliant"}};
template <>
inline constexpr std::array choices<Grading>{Named{Grading::clamps, "clamps"}, Named{Grading::uniform, "uniform"}};
template <>
inline constexpr std::array choices<Support>{Named{Support::clamped, "clamped"}, Named{Support::pinned, "pinned"},
                                             Named{Support::roller, "roller"}, Named{Support::free, "free"},
                                             Named{Support::guided, "guided"}};
template <>
inline constexpr std::array choices<Dimension>{Named{Dimension::planar, "planar"},
                                               Named{Dimension::spatial, "spatial"}};
template <>
inline constexpr std::array choices<MassMatrix>{Named{MassMatrix::lumped, "lumped"},
                                                Named{MassMatrix::consistent, "consistent"}};
template <>
inline constexpr std::array choices<LoadType>{Named{LoadType::static_force, "static-force"},
                                              Named{LoadType::harmonic_force, "harmonic-force"},
                                              Named{LoadType::table, "table"}};
template <>
inline constexpr std::array choices<MotionType>{Named{MotionType::static_motion, "static-motion"},
                                                Named{MotionType::harmonic_motion, "harmonic-motion"},
                                                Named{MotionType::table, "table"}};
template <>
inline constexpr std::array choices<End>{Named{End::left, "left"}, Named{End::right, "right"}};
template <>
inline constexpr std::array choices<Control>{Named{Control::load, "load"}, Named{Control::displacement, "displacement"},
                                             Named{Control::arc_length, "arc-length"}};
template <>
inline constexpr std::array choices<Method>{Named{Method::ida, "ida"},
                                            Named{Method::generalized_alpha, "generalized-alpha"}};
template <>
inline constexpr std::array choices<StepRule>{Named{StepRule::fixed, "fixed"}, Named{StepRule::automatic, "auto"},
                                              Named{StepRule::adaptive, "adaptive"}};
template <>
inline constexpr std::array choices<Twist>{Named{Twist::held, "held"}, Named{Twist::free, "free"}};
template <>
inline constexpr std::array choices<Until>{Named{Until::steady, "steady"}};
template <>
inline constexpr std::array choices<AnalysisType>{Named{AnalysisType::section, "section"},
                                                  Named{AnalysisType::axial_torsion, "axial-torsion"},
                                                  Named{AnalysisType::static_, "static"},
                                                  Named{AnalysisType::modes, "modes"},
                                                  Named{AnalysisType::decay, "decay"},
                                                  Named{AnalysisType::forced, "forced"},
                                                  Named{AnalysisType::transient, "transient"},
                                                  Named{AnalysisType::sweep, "sweep"},
                                                  Named{AnalysisType::self_damping, "self-damping"}};
template <>
inline constexpr std::array choices<DampingMethod>{
    Named{DampingMethod::quadrature, "quadrature"}, Named{DampingMethod::periodic, "periodic"},
    Named{DampingMethod::transient, "transient"}, Named{DampingMethod::foti_2018, "foti-2018"}};
template <>
inline constexpr std::array choices<ModeShape>{Named{ModeShape::sine, "sine"}, Named{ModeShape::clamped, "clamped"}};
template <>
inline constexpr std::array choices<BenchStart>{Named{BenchStart::mode, "mode"}, Named{BenchStart::rest, "rest"}};
template <>
inline constexpr std::array choices<WindCurve>{Named{WindCurve::cigre, "cigre"},
                                               Named{WindCurve::diana_falco, "diana-falco"},
                                               Named{WindCurve::brika_laneville, "brika-laneville"}};
template <>
inline constexpr std::array choices<BalancedBy>{
    Named{BalancedBy::quadrature, "quadrature"}, Named{BalancedBy::foti_2018, "foti-2018"},
    Named{BalancedBy::fit, "fit"}, Named{BalancedBy::published, "published"}};

/// The word of a value, as the case file spells it.
template <class E>
constexpr std::string_view name_of(E value) {
  for (const auto& choice : choices<E>) {
    if (choice.value == value) return choice.name;
  }
  return {};
}

}  // namespace strandyn::casefile
