#pragma once
/// \file [[load]] and [[motion]]: what acts on a span, and how it changes with time.
///
/// To add a history: a form in a header below math with its name in the list of math/time_function.hpp, and here its
/// word, its keys and its line of `history_function`.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "strandyn/casefile/declare.hpp"
#include "strandyn/core/words.hpp"
#include "strandyn/math/time_function.hpp"

namespace strandyn::casefile {

using Vector3 = std::array<double, 3>;

enum class LoadType { static_force, harmonic_force, table };
constexpr auto words_of(LoadType) {
  return std::array{Named{LoadType::static_force, "static-force"}, Named{LoadType::harmonic_force, "harmonic-force"},
                    Named{LoadType::table, "table"}};
}

enum class MotionType { static_motion, harmonic_motion, table };
constexpr auto words_of(MotionType) {
  return std::array{Named{MotionType::static_motion, "static-motion"},
                    Named{MotionType::harmonic_motion, "harmonic-motion"}, Named{MotionType::table, "table"}};
}

enum class Interpolation { linear, smooth };
constexpr auto words_of(Interpolation) {
  return std::array{Named{Interpolation::linear, "linear"}, Named{Interpolation::smooth, "smooth"}};
}

enum class End { left, right };
constexpr auto words_of(End) {
  return std::array{Named{End::left, "left"}, Named{End::right, "right"}};
}

inline math::Tabulated tabulated(const std::vector<std::array<double, 2>>& rows) {
  math::Tabulated table;
  for (const auto& [time, value] : rows) {
    table.time.push_back(time);
    table.value.push_back(value);
  }
  return table;
}

struct Load {
  LoadType type = LoadType::static_force;
  std::optional<double> at;  ///< [m] from the left support; empty: per length of the whole span
  std::optional<bool> per_length;
  std::optional<double> force;                 ///< [N] or [N/m], `static-force`
  std::optional<double> amplitude;             ///< [N] or [N/m], `harmonic-force`
  std::optional<double> moment;                ///< [N m] or [N], in the place of either
  std::vector<std::array<double, 2>> history;  ///< [s], [N] ([N m] if history_is_moment), `table`
  std::optional<std::string> history_file;     ///< where it comes from; after reading it is in `history`
  bool history_is_moment = false;
  std::optional<Interpolation> interpolation;  ///< of the history; always set after reading where there is one
  std::optional<double> history_begins;        ///< [s] of the file that is the beginning of the run
  std::optional<double> low_pass;              ///< [Hz] above which the history is cut off; after reading it has been
  std::optional<Vector3> direction;            ///< [-] unit vector; always set after reading
  std::optional<double> frequency;             ///< [Hz] `harmonic-force`: this, or
  std::optional<int> frequency_mode;           ///< that of this mode, counted from 1

  bool is_harmonic() const { return type == LoadType::harmonic_force; }
  bool is_moment() const { return moment.has_value() || history_is_moment; }
  /// How it changes with time. A harmonic one has no history of its own: it follows a drive of the run.
  math::TimeFunction history_function() const {
    if (type != LoadType::table) return math::Constant{};
    return interpolation == Interpolation::smooth ? math::smooth(tabulated(history)) : tabulated(history);
  }
  /// The one of force, amplitude, moment that is given, which the history multiplies; 1 for a table.
  double value() const {
    return type == LoadType::table ? 1.0 : moment.value_or(force.value_or(amplitude.value_or(0.0)));
  }
};

template <class V>
void keys(V& v, Load& l) {
  v.choice("type", l.type, {.help = "the kind of load", .required = true});
  v.one_of({"at_m", "per_length"}, {.required = true});
  v.number("at_m", l.at, {.help = "the distance from the left support", .unit = units::m, .at_least = 0});
  v.flag("per_length", l.per_length, {.help = "whether the load acts on every metre of the span"});
  v.when("type", l.type, {LoadType::static_force}, [&] {
    v.one_of({"force_N", "moment_N_m"}, {.required = true});
    v.number("force_N", l.force, {.help = "the force, per metre with per_length", .unit = units::N});
  });
  v.when("type", l.type, {LoadType::harmonic_force}, [&] {
    v.one_of({"amplitude_N", "moment_N_m"}, {.required = true});
    v.number("amplitude_N", l.amplitude,
             {.help = "the amplitude of the force, per metre with per_length", .unit = units::N});
    v.one_of({"frequency_Hz", "frequency"}, {.required = true});
    v.number("frequency_Hz", l.frequency, {.help = "the frequency", .unit = units::Hz, .above = 0});
    v.mode_word("frequency", l.frequency_mode, {.help = "a natural frequency, written \"mode 12\""});
  });
  v.when("type", l.type, {LoadType::static_force, LoadType::harmonic_force}, [&] {
    v.number("moment_N_m", l.moment,
             {.help = "the moment or its amplitude, in the place of a force", .unit = units::N_m});
  });
  v.when("type", l.type, {LoadType::table}, [&] {
    v.one_of({"history", "history_file"}, {.required = true});
    v.rows("history", l.history, {{{.help = "time", .unit = units::s}, {.help = "force or moment", .unit = units::N}}},
           {.help = "the load over time, rows of seconds and newtons (newton metres with moment = true)"});
    v.text("history_file", l.history_file,
           {.help = "the name of a csv file, beside the case, with the columns time_s and force_N (moment_N_m with "
                    "moment = true)"});
    v.flag("moment", l.history_is_moment, {.help = "whether the history is that of a moment"});
    v.choice("interpolation", l.interpolation,
             {.help = "straight lines, or the cubic spline through the rows (linear unless given)"});
    v.number("history_begins_at_s", l.history_begins,
             {.help = "the time of the file that is the beginning of the run (0 unless given)", .unit = units::s});
    v.number("low_pass_Hz", l.low_pass,
             {.help = "the frequency above which the history is left out, before it is followed in steps",
              .unit = units::Hz,
              .above = 0});
  });
  v.vector("direction", l.direction,
           {.help = "the direction of the force, or the axis of the moment (y, or z for a moment, unless given)"});
}

/// [[motion]]: a support or a point of the span follows a prescribed motion along or about one axis.
struct Motion {
  MotionType type = MotionType::static_motion;
  std::optional<End> support;                  ///< this, or
  std::optional<double> at;                    ///< [m] from the left support, along the span
  std::optional<double> displacement;          ///< [m] `static-motion`: this, or
  std::optional<double> rotation;              ///< [rad]
  std::optional<double> amplitude;             ///< [m] `harmonic-motion`: this, or
  std::optional<double> rotation_amplitude;    ///< [rad]
  std::optional<double> frequency;             ///< [Hz] `harmonic-motion`: this, or
  std::optional<int> frequency_mode;           ///< that of this mode, counted from 1
  std::vector<std::array<double, 2>> history;  ///< [s], [m] ([rad] if history_is_rotation), `table`
  std::optional<std::string> history_file;     ///< where it comes from; after reading it is in `history`
  bool history_is_rotation = false;
  std::optional<double> history_begins;        ///< [s] of the file that is the beginning of the run
  std::optional<double> low_pass;              ///< [Hz] above which the history is cut off; after reading it has been
  std::optional<Interpolation> interpolation;  ///< of the history; always set after reading where there is one
  double ease = 0;                             ///< [s] in which a motion swells to its full size
  std::optional<Vector3> direction;            ///< [-] plus or minus one of the axes x, y, z; always set after reading

  bool is_harmonic() const { return type == MotionType::harmonic_motion; }
  bool is_rotation() const { return rotation || rotation_amplitude || history_is_rotation; }
  /// As that of a load.
  math::TimeFunction history_function() const {
    if (type != MotionType::table) return math::Constant{};
    return interpolation == Interpolation::smooth ? math::smooth(tabulated(history)) : tabulated(history);
  }
  /// [m] or [rad] the one of displacement, rotation and their amplitudes that is given; 1 for a table.
  double value() const {
    if (type == MotionType::table) return 1;
    return displacement.value_or(rotation.value_or(amplitude.value_or(rotation_amplitude.value_or(0.0))));
  }
};

template <class V>
void keys(V& v, Motion& m) {
  v.choice("type", m.type, {.help = "the kind of motion", .required = true});
  v.one_of({"at", "at_m"}, {.required = true});
  v.choice("at", m.support, {.help = "the support that moves"});
  v.number("at_m", m.at,
           {.help = "the distance from the left support to the point that moves, along the span",
            .unit = units::m,
            .at_least = 0});
  v.when("type", m.type, {MotionType::static_motion}, [&] {
    v.one_of({"displacement_mm", "rotation_deg"}, {.required = true});
    v.number("displacement_mm", m.displacement, {.help = "the displacement", .unit = units::mm});
    v.number("rotation_deg", m.rotation, {.help = "the rotation", .unit = units::deg});
  });
  v.when("type", m.type, {MotionType::harmonic_motion}, [&] {
    v.one_of({"amplitude_mm", "amplitude_deg"}, {.required = true});
    v.number("amplitude_mm", m.amplitude, {.help = "the amplitude of the displacement", .unit = units::mm});
    v.number("amplitude_deg", m.rotation_amplitude, {.help = "the amplitude of the rotation", .unit = units::deg});
    v.one_of({"frequency_Hz", "frequency"}, {.required = true});
    v.number("frequency_Hz", m.frequency, {.help = "the frequency", .unit = units::Hz, .above = 0});
    v.mode_word("frequency", m.frequency_mode, {.help = "a natural frequency, written \"mode 12\""});
  });
  v.when("type", m.type, {MotionType::table}, [&] {
    v.one_of({"history", "history_file"}, {.required = true});
    v.flag("rotation", m.history_is_rotation, {.help = "whether the history is that of a rotation"});
    const Number value = m.history_is_rotation
                             ? Number{.help = "rotation", .unit = units::deg}
                             : Number{.help = "displacement (degrees with rotation = true)", .unit = units::mm};
    v.rows("history", m.history, {{{.help = "time", .unit = units::s}, value}},
           {.help = "the motion over time, rows of seconds and millimetres (degrees with rotation = true)"});
    v.text("history_file", m.history_file,
           {.help = "the name of a csv file, beside the case, with the columns time_s and displacement_mm "
                    "(rotation_deg with rotation = true)"});
    v.number("history_begins_at_s", m.history_begins,
             {.help = "the time of the file that is the beginning of the run (0 unless given)", .unit = units::s});
    v.number("low_pass_Hz", m.low_pass,
             {.help = "the frequency above which the history is left out, before it is followed in steps",
              .unit = units::Hz,
              .above = 0});
    v.choice(
        "interpolation", m.interpolation,
        {.help = "straight lines, whose corners are jumps of velocity, or the cubic spline through the rows (smooth "
                 "for eight rows and more that are evenly spaced: samples; otherwise linear)"});
  });
  v.when("type", m.type, {MotionType::harmonic_motion, MotionType::table}, [&] {
    v.number("ease_s", m.ease,
             {.help = "the time in which the motion swells from nothing to its full size, by a raised cosine",
              .unit = units::s,
              .at_least = 0});
  });
  v.vector("direction", m.direction,
           {.help = "the direction of the displacement, or the axis of the rotation, along x, y or z "
                    "(y, or z for a rotation, unless given)"});
}

}  // namespace strandyn::casefile
