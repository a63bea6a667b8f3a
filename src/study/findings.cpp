#include "findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "strandyn/report/format.hpp"

namespace strandyn::study {

namespace {

constexpr double beside_a_clamp = 0.1;  // [m]

double of_member(const SteadyRow& row, std::string_view name) {
  const auto found = std::ranges::find(row.mean, name, [](const auto& member) { return member.first; });
  return found == row.mean.end() ? 0 : found->second;
}

/// [-] of what friction and the metal take along a span, the part beside its ends.
double share_at_ends(const observe::Profile& profile, double length) {
  double all = 0, ends = 0;
  for (std::size_t point = 0; point < profile.position.size(); ++point) {
    const double lost = profile.length[point] * profile.self_damping(point);
    all += lost;
    if (std::min(profile.position[point], length - profile.position[point]) < beside_a_clamp) ends += lost;
  }
  return all > 0 ? ends / all : 0;
}

std::string where_it_is_lost(const SteadyRow& row, const observe::Profile& profile, double length) {
  const double ends = share_at_ends(profile, length);
  std::string text;
  if (length > 4 * beside_a_clamp && ends > 0) {
    text = fmt::format("{:.0f} % of it is lost within {:g} m of the supports", 100 * ends, beside_a_clamp);
  }
  if (!row.free_span) return text.empty() ? text : text + ".";
  text += fmt::format("{}the free span between the first and the last inner node loses {}.",
                      text.empty() ? "Of it " : "; ", amount(*row.free_span, "W/m"));
  if (ends > 0.1) {
    text += " Inverse standing wave ratios and decays of long spans see the free span, not the supports.";
  }
  return text;
}

std::string law_of(const self_damping::FitRow& fit) {
  return fmt::format("P ~ A^{:.2f} f^{:.2f}/T^{:.2f}", *fit.l, *fit.m, *fit.n);
}

bool is_whole(const self_damping::FitRow& fit) {
  return fit.l && fit.m && fit.n;
}

std::string beside_published(const self_damping::FitRow& fit, const self_damping::PublishedRow& published) {
  std::vector<std::string> outside;
  const auto look = [&](const char* name, double exponent, const self_damping::Pair& band) {
    if (exponent < band[0]) outside.push_back(fmt::format("{} lies {:.2f} below", name, band[0] - exponent));
    if (exponent > band[1]) outside.push_back(fmt::format("{} lies {:.2f} above", name, exponent - band[1]));
  };
  look("l", *fit.l, published.l);
  look("m", *fit.m, published.m);
  look("n", *fit.n, published.n);
  std::string text = fmt::format("Published laws have l {:g} to {:g}, m {:g} to {:g}, n {:g} to {:g}: ", published.l[0],
                                 published.l[1], published.m[0], published.m[1], published.n[0], published.n[1]);
  if (outside.empty()) return text + "all three lie inside.";
  for (std::size_t i = 0; i < outside.size(); ++i) text += (i == 0 ? "" : ", ") + outside[i];
  return text + (outside.size() < 3 ? ", the others inside." : ".");
}

}  // namespace

std::string amount(double value, std::string_view unit) {
  const report::Prefix prefix = report::prefix_for(std::abs(value));
  return fmt::format("{:.3g} {}{}", value / prefix.factor, prefix.symbol, unit);
}

std::vector<std::string> findings_of(const SteadyRow& row, const observe::Profile& profile, double length) {
  std::vector<std::string> found;
  const double friction = of_member(row, "friction_dissipation_J");
  std::string what =
      fmt::format("At {:.4g} Hz and an antinode amplitude of {}, the wires lose {} per cycle by friction",
                  row.frequency, amount(of_member(row, "antinode_amplitude_m"), "m"), amount(friction, "J"));
  what += fmt::format(", and the whole span has a self-damping of {}{}.", amount(row.self_damping, "W/m"),
                      row.is_steady ? ""
                      : row.decays  ? " (the mean of the last cycles of a decay)"
                                    : " (not a steady state)");
  found.push_back(what);
  if (const std::string where = where_it_is_lost(row, profile, length); !where.empty()) found.push_back(where);
  if (row.dampers > 0) found.push_back(fmt::format("Dampers take {}.", amount(row.dampers, "W")));
  if (row.air > 0)
    found.push_back(fmt::format("Still air takes {}, which is not self-damping.", amount(row.air, "W/m")));
  if (row.numerical_share) {
    found.push_back(
        fmt::format("The integrator's own part is {:.2g} % of what is lost.", 100 * std::abs(*row.numerical_share)));
  }
  constexpr double apart = 0.02;
  if (!row.is_steady && !row.decays && std::abs(row.steadiness.work_in_over_lost.value_or(1) - 1) > apart) {
    found.push_back(fmt::format("What comes in is {:.3g} times what is lost: more cycles are needed.",
                                *row.steadiness.work_in_over_lost));
  }
  return found;
}

std::vector<std::string> findings_of(const std::vector<LoopRow>& loops) {
  if (loops.empty()) return {};
  const LoopRow& widest = *std::ranges::max_element(loops, {}, &LoopRow::curvature);
  std::vector<std::string> found;
  found.push_back(
      fmt::format("Bent to and fro by {:.3g} 1/m at a tension of {}, a metre loses {} in each cycle by "
                  "friction; moment over curvature is {:.4g} N m² there.",
                  widest.curvature, amount(widest.tension, "N"), amount(widest.area, "J"), widest.secant));
  if (widest.chi_0 && widest.M_0) {
    found.push_back(fmt::format("At that tension all wires slip beyond {:.3g} 1/m, at a moment of {}.", *widest.chi_0,
                                amount(*widest.M_0, "N m")));
  }
  return found;
}

std::vector<std::string> findings_of(const std::vector<span::ModeRow>& modes) {
  if (modes.empty()) return {};
  const auto [low, high] = std::ranges::minmax(modes, {}, &span::ModeRow::frequency);
  constexpr const char* about = "about the state of rest, in which no wire slips";
  if (modes.size() == 1) return {fmt::format("One natural frequency, {:.6g} Hz, {}.", low.frequency, about)};
  return {fmt::format("{} natural frequencies from {:.6g} to {:.6g} Hz, {}.", modes.size(), low.frequency,
                      high.frequency, about)};
}

std::vector<std::string> findings_of(const self_damping::Fits& fits, const self_damping::GridFits& grids) {
  std::vector<std::string> found;
  const auto tell = [&](const char* which, const self_damping::FitRow& fit, const std::optional<std::string>& caveat) {
    if (!is_whole(fit)) return;
    std::string text = fmt::format("{}: {}", which, law_of(fit));
    if (fit.r2) text += fmt::format(" (R^2 {:.4f}, {} points)", *fit.r2, fit.points);
    text += ". " + beside_published(fit, fits.published);
    if (caveat) text += " But there is " + *caveat + ".";
    found.push_back(text);
  };
  const auto both = [&](const char* grid, const std::optional<self_damping::GridFit>& fit) {
    if (!fit) return;
    const std::string which = std::string("On the grid of ") + grid;
    tell((which + ", all that is lost").c_str(), fit->dissipation ? *fit->dissipation : fit->self_damping, fit->caveat);
    if (fit->friction) tell((which + ", friction alone").c_str(), *fit->friction, {});
  };
  both("antinode velocities", grids.by_velocity);
  both("amplitudes", grids.by_amplitude);
  if (found.empty()) tell("All points", fits.fit, {});
  return found;
}

std::vector<std::string> findings_of_bench(const std::vector<self_damping::PointRow>& points) {
  const auto read = std::ranges::find_if(
      points, [](const self_damping::PointRow& p) { return p.bench && p.bench->iswr && p.bench->decay; });
  if (read == points.end()) return {};
  return {
      fmt::format("At {:.4g} Hz and an antinode amplitude of {} the ledger has a loss of {}, the power of the shaker "
                  "says {}, the decay {}; inverse standing wave ratios, which see the span between two nodes, {}.",
                  read->frequency, amount(read->antinode_amplitude, "m"), amount(read->bench->ledger.power, "W/m"),
                  amount(read->bench->power.power, "W/m"), amount(read->bench->decay->power, "W/m"),
                  amount(read->bench->iswr->power, "W/m"))};
}

std::vector<std::string> findings_of(const std::vector<self_damping::BalanceRow>& balances) {
  const self_damping::BalanceRow* largest = nullptr;
  std::size_t held = 0;
  for (const self_damping::BalanceRow& row : balances) {
    if (!row.amplitude_over_diameter) continue;
    ++held;
    if (!largest || *row.amplitude_over_diameter > *largest->amplitude_over_diameter) largest = &row;
  }
  if (!largest) return {};
  std::string text = fmt::format(
      "In the wind the conductor vibrates most at {:.4g} Hz (wind of {:.3g} m/s), by {:.3g} of its "
      "diameter",
      largest->frequency, largest->wind_speed, *largest->amplitude_over_diameter);
  if (largest->bare_amplitude) text += fmt::format("; without dampers {:.3g}", *largest->bare_amplitude);
  if (held < balances.size()) {
    text +=
        fmt::format("; at {} of {} frequencies wind and losses meet nowhere", balances.size() - held, balances.size());
  }
  return {text + "."};
}

}  // namespace strandyn::study
