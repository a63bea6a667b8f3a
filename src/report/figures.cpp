#include "strandyn/report/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "strandyn/report/format.hpp"

namespace strandyn::report {
namespace {

std::string with_unit(double value, std::string_view unit, int digits) {
  const Quantity shown = quantity(value, unit, digits);
  return shown.number + " " + shown.unit;
}

/// Markers where single points can be told apart.
bool are_few(std::size_t points) {
  return points <= 40;
}

std::optional<double> number(const nlohmann::ordered_json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_number()) return std::nullopt;
  return found->get<double>();
}

/// One part of the ledger over the cycles.
Series part(const std::vector<CycleRow>& cycles, std::optional<double> CycleRow::*energy) {
  Series series;
  for (const CycleRow& cycle : cycles) {
    if (!(cycle.*energy)) continue;
    series.x.push_back(static_cast<double>(cycle.cycle));
    series.y.push_back(*(cycle.*energy));
  }
  series.markers = are_few(series.x.size());
  return series;
}

bool is_zero(const Series& series) {
  return std::all_of(series.y.begin(), series.y.end(), [](double y) { return y == 0; });
}

/// Trapezoidal integral of y over x, as a running sum.
std::vector<double> running_integral(const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<double> sum(x.size(), 0.0);
  for (std::size_t i = 1; i < x.size(); ++i) sum[i] = sum[i - 1] + (x[i] - x[i - 1]) * (y[i] + y[i - 1]) / 2;
  return sum;
}

/// Where the loss lies: [m] the length of the span, and the distance from the supports that holds half of it.
struct Concentration {
  double length = 0;
  double half = 0;
};

/// Nothing where there is no loss. The points are those of the sections, symmetric in the span and short of its ends;
/// the loss between the outermost ones and the supports is taken as theirs.
std::optional<Concentration> concentration(std::vector<double> x, std::vector<double> loss) {
  const double gap = x.front();
  if (gap > 0) {
    x.insert(x.begin(), 0);
    loss.insert(loss.begin(), loss.front());
    x.push_back(x.back() + gap);
    loss.push_back(loss.back());
  }
  const std::vector<double> sum = running_integral(x, loss);
  if (!(sum.back() > 0)) return std::nullopt;
  const auto lost_before = [&](double position) {
    const auto above = std::upper_bound(x.begin(), x.end(), position) - x.begin();
    const auto i = std::clamp<std::size_t>(static_cast<std::size_t>(above), 1, x.size() - 1);
    const double width = x[i] - x[i - 1];
    return width > 0 ? sum[i - 1] + (sum[i] - sum[i - 1]) * (position - x[i - 1]) / width : sum[i];
  };
  double low = 0;
  double high = (x.back() - x.front()) / 2;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    const double outside = lost_before(x.front() + middle) + sum.back() - lost_before(x.back() - middle);
    (outside < sum.back() / 2 ? low : high) = middle;
  }
  return Concentration{.length = x.back() - x.front(), .half = high};
}

}  // namespace

std::optional<Figure> loops_figure(const results::Table& loops) {
  for (const char* name : {"loop", "tension_N", "curvature_per_m", "moment_N_m"}) {
    if (!loops.has(name)) return std::nullopt;
  }
  if (loops.rows() < 2) return std::nullopt;
  struct Loop {
    Series series;
    double tension = 0;
    double amplitude = 0;
  };
  std::map<double, Loop> by_number;
  for (std::size_t i = 0; i < loops.rows(); ++i) {
    Loop& loop = by_number[loops.column("loop")[i]];
    loop.tension = loops.column("tension_N")[i];
    loop.amplitude = std::max(loop.amplitude, std::abs(loops.column("curvature_per_m")[i]));
    loop.series.x.push_back(loops.column("curvature_per_m")[i]);
    loop.series.y.push_back(loops.column("moment_N_m")[i]);
  }
  // The name of a loop is what sets it apart from the others.
  const Loop& first = by_number.begin()->second;
  const bool tensions_differ = std::any_of(by_number.begin(), by_number.end(), [&](const auto& entry) {
    return std::abs(entry.second.tension - first.tension) > 1e-6 * std::abs(first.tension);
  });
  const bool amplitudes_differ = std::any_of(by_number.begin(), by_number.end(), [&](const auto& entry) {
    return std::abs(entry.second.amplitude - first.amplitude) > 1e-6 * first.amplitude;
  });
  Figure figure{.name = "loops",
                .caption =
                    "Bending moment against curvature over a closed cycle. The area of a loop is the energy "
                    "that friction takes from a metre of conductor in that cycle.",
                .plot = {.title = "Hysteresis of the cross section",
                         .x = {.label = "curvature", .unit = "1/m"},
                         .y = {.label = "bending moment", .unit = "N m"},
                         .series = {}}};
  const auto colours = ramp(by_number.size());
  for (auto& [number_of_loop, loop] : by_number) {
    std::vector<std::string> names;
    if (tensions_differ || !amplitudes_differ) names.push_back(with_unit(loop.tension, "N", 3));
    if (amplitudes_differ) names.push_back("±" + typeset(loop.amplitude, 2) + " 1/m");
    loop.series.name = fmt::format("{}", fmt::join(names, ", "));
    loop.series.custom_colour = colours[figure.plot.series.size()];
    figure.plot.series.push_back(std::move(loop.series));
  }
  return figure;
}

std::optional<Figure> energy_figure(const std::vector<CycleRow>& cycles) {
  Figure figure{.name = "energy_per_cycle",
                .caption =
                    "Where the work of a cycle goes. The numerical part is what the ledger leaves over: the "
                    "error of the time integration, and no physics.",
                .plot = {.title = "Energy per cycle",
                         .x = {.label = "cycle", .tight = true},
                         .y = {.label = "energy", .unit = "J", .from_zero = true},
                         .series = {}}};
  struct Part {
    const char* name;
    std::optional<double> CycleRow::*energy;
    Colour colour;
    bool filled;
    bool dashed;
    bool always;  ///< also where it is zero throughout
  };
  const std::array<Part, 4> parts = {{{"external work", &CycleRow::external, Colour::ink, false, false, false},
                                      {"friction", &CycleRow::friction, Colour::orange, true, false, true},
                                      {"viscous", &CycleRow::viscous, Colour::blue, false, false, false},
                                      {"numerical", &CycleRow::numerical, Colour::red, false, true, true}}};
  for (const Part& p : parts) {
    Series series = part(cycles, p.energy);
    if (series.x.empty() || (is_zero(series) && !p.always)) continue;
    series.name = p.name;
    series.colour = p.colour;
    series.filled = p.filled;
    series.dashed = p.dashed;
    series.markers = series.markers && !p.dashed;
    figure.plot.series.push_back(std::move(series));
  }
  if (figure.plot.series.empty() || figure.plot.series.front().x.size() < 2) return std::nullopt;
  return figure;
}

std::optional<Figure> amplitude_figure(const std::vector<CycleRow>& cycles) {
  Series series = part(cycles, &CycleRow::antinode_amplitude);
  if (series.x.size() < 2) return std::nullopt;
  series.colour = Colour::blue;
  series.filled = true;
  return Figure{.name = "amplitude",
                .caption = "Half of peak to peak over a cycle, at the largest antinode away from the ends.",
                .plot = {.title = "Antinode amplitude",
                         .x = {.label = "cycle", .tight = true},
                         .y = {.label = "amplitude", .unit = "m", .from_zero = true},
                         .series = {std::move(series)}}};
}

std::optional<Figure> dissipation_figure(const results::Table& profile) {
  if (!profile.has("x_m") || !profile.has("friction_J_per_m") || profile.rows() < 2) return std::nullopt;
  const auto& x = profile.column("x_m");
  const auto& loss = profile.column("friction_J_per_m");
  std::string caption = "Friction loss per metre and cycle, mean of the last cycles.";
  if (const auto where = concentration(x, loss)) {
    caption += fmt::format(" Half of it lies within {} of the supports, on {} % of the length.",
                           with_unit(where->half, "m", 2), typeset(200 * where->half / where->length, 2));
  }
  return Figure{.name = "dissipation_profile",
                .caption = std::move(caption),
                .plot = {.title = "Where the energy is lost along the span",
                         .x = {.label = "position along the span (m)", .tight = true},
                         .y = {.label = "friction loss per cycle", .unit = "J/m", .from_zero = true},
                         .series = {{.x = x, .y = loss, .colour = Colour::orange, .filled = true}}}};
}

std::optional<Figure> dissipation_near_support_figure(const results::Table& profile) {
  constexpr double concentrated = 0.05;  // of the length; wider than this, the plot of the span shows the shape
  constexpr double shown_halves = 6;     // the loss falls off over a few times the distance that holds half of it
  if (!profile.has("x_m") || !profile.has("friction_J_per_m") || profile.rows() < 2) return std::nullopt;
  const auto& x = profile.column("x_m");
  const auto& loss = profile.column("friction_J_per_m");
  const auto where = concentration(x, loss);
  if (!where || where->half > concentrated * where->length) return std::nullopt;
  Series series{.x = {}, .y = {}, .colour = Colour::orange, .filled = true};
  for (std::size_t i = 0; i < x.size() && x[i] <= x.front() + shown_halves * where->half; ++i) {
    series.x.push_back(x[i]);
    series.y.push_back(loss[i]);
  }
  if (series.x.size() < 2) return std::nullopt;
  series.markers = are_few(series.x.size());
  return Figure{.name = "dissipation_near_support",
                .caption = "The same loss beside the first support.",
                .plot = {.title = "Where the energy is lost beside the support",
                         .x = {.label = "position along the span", .unit = "m", .tight = true},
                         .y = {.label = "friction loss per cycle", .unit = "J/m", .from_zero = true},
                         .series = {std::move(series)}}};
}

std::optional<Figure> curvature_figure(const results::Table& profile) {
  if (!profile.has("x_m") || !profile.has("curvature_amplitude_per_m") || profile.rows() < 2) return std::nullopt;
  return Figure{.name = "curvature_profile",
                .caption = "The curvature that the cross sections go through in each cycle.",
                .plot = {.title = "Curvature amplitude along the span",
                         .x = {.label = "position along the span (m)", .tight = true},
                         .y = {.label = "curvature amplitude", .unit = "1/m", .from_zero = true},
                         .series = {{.x = profile.column("x_m"),
                                     .y = profile.column("curvature_amplitude_per_m"),
                                     .colour = Colour::violet,
                                     .filled = true}}}};
}

std::optional<Figure> modes_figure(const results::Table& modes) {
  if (!modes.has("x_m") || modes.rows() < 2 || modes.names().size() < 2) return std::nullopt;
  Figure figure{.name = "modes",
                .caption = "The lowest modes of the span about its static state.",
                .plot = {.title = "Mode shapes",
                         .x = {.label = "position along the span (m)", .tight = true},
                         .y = {.label = "mode shape"},
                         .series = {}}};
  constexpr std::size_t most = 6;
  std::vector<std::string> names;
  for (const std::string& name : modes.names()) {
    if (name != "x_m" && names.size() < most) names.push_back(name);
  }
  const auto colours = ramp(names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    figure.plot.series.push_back({.name = label_of(names[i]).name,
                                  .x = modes.column("x_m"),
                                  .y = modes.column(names[i]),
                                  .custom_colour = colours[i]});
  }
  return figure;
}

std::optional<Figure> self_damping_figure(const nlohmann::ordered_json& points) {
  // One line per tension and road; a second amplitude at the same frequency opens a line of its own.
  std::map<std::pair<double, std::string>, std::vector<Series>> lines;
  std::size_t count = 0;
  for (const auto& point : points) {
    const auto frequency = number(point, "frequency_Hz");
    const auto power = number(point, "self_damping_W_per_m");
    if (!frequency || !power) continue;
    const auto road = point.find("road");
    auto& of_tension = lines[{number(point, "tension_N").value_or(0),
                              road != point.end() && road->is_string() ? road->get<std::string>() : ""}];
    auto free = std::find_if(of_tension.begin(), of_tension.end(), [&](const Series& series) {
      return std::find(series.x.begin(), series.x.end(), *frequency) == series.x.end();
    });
    if (free == of_tension.end()) free = of_tension.insert(of_tension.end(), Series{.x = {}, .y = {}});
    free->x.push_back(*frequency);
    free->y.push_back(*power);
    ++count;
  }
  if (count < 2) return std::nullopt;
  Figure figure{.name = "self_damping",
                .caption = "Dissipated power per metre of span against frequency.",
                .plot = {.title = "Self-damping",
                         .x = {.label = "frequency", .unit = "Hz", .log = true},
                         .y = {.label = "self-damping", .unit = "W/m", .log = true},
                         .series = {}}};
  const std::string& first_road = lines.begin()->first.second;
  const bool roads_differ =
      std::any_of(lines.begin(), lines.end(), [&](const auto& line) { return line.first.second != first_road; });
  for (auto& [key, of_tension] : lines) {
    const auto& [tension, road] = key;
    const std::string name = with_unit(tension, "N", 3) + (roads_differ ? ", " + road : "");
    for (std::size_t i = 0; i < of_tension.size(); ++i) {
      of_tension[i].name = i > 0 ? "" : name;
      of_tension[i].markers = true;
      figure.plot.series.push_back(std::move(of_tension[i]));
    }
  }
  const auto colours = ramp(lines.size());
  std::size_t used = 0;
  for (Series& series : figure.plot.series) {
    if (!series.name.empty()) ++used;
    series.custom_colour = colours[used - 1];
  }
  return figure;
}

std::optional<Figure> static_figure(const nlohmann::ordered_json& steps) {
  Series series{.x = {}, .y = {}};
  for (const auto& step : steps) {
    const auto load = number(step, "load_N");
    const auto displacement = number(step, "displacement_m");
    if (!load || !displacement) continue;
    series.x.push_back(*displacement);
    series.y.push_back(*load);
  }
  if (series.x.size() < 2) return std::nullopt;
  series.markers = are_few(series.x.size());
  return Figure{.name = "load_displacement",
                .caption = "Load against the displacement of the loaded point.",
                .plot = {.title = "Load and displacement",
                         .x = {.label = "displacement", .unit = "m"},
                         .y = {.label = "load", .unit = "N", .from_zero = true},
                         .series = {std::move(series)}}};
}

}  // namespace strandyn::report
