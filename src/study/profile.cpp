#include "profile.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace strandyn::study {
namespace {

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

void add_profile(const observe::Profile& profile, Outcome& outcome) {
  constexpr const char* file = "dissipation_profile.csv";
  results::Table table({"x_m", "friction_J_per_m", "curvature_amplitude_per_m", "length_m", "material_J_per_m"});
  for (std::size_t i = 0; i < profile.position.size(); ++i) {
    table.append(std::array{profile.position[i], profile.friction[i], profile.curvature_amplitude[i], profile.length[i],
                            profile.material[i]});
  }
  outcome.tables.push_back({.file = file, .table = std::move(table)});
  if (profile.cycles == 0 || profile.position.size() < 2) return;

  results::Figure loss{.name = "dissipation_profile",
                       .title = "Where the energy is lost along the span",
                       .kind = "points",
                       .table = file,
                       .x = "x_m",
                       .y = {"friction_J_per_m"},
                       .y_scale = "log",
                       .caption =
                           "Friction loss per metre and cycle, mean of the last cycles; where nothing is lost "
                           "there is no point."};
  const auto where = concentration(profile.position, profile.friction);
  if (where) {
    loss.caption += fmt::format(" Half of it lies within {:.2g} m of the supports, on {:.2g} % of the length.",
                                where->half, 200 * where->half / where->length);
  }
  outcome.figures.push_back(loss);
  constexpr double concentrated = 0.05;  // of the length; wider than this, the plot of the span shows the shape
  constexpr double shown_halves = 6;     // the loss falls off over a few times the distance that holds half of it
  if (where && where->half <= concentrated * where->length) {
    const double start = profile.position.front();
    loss.name = "dissipation_near_support";
    loss.title = "Where the energy is lost beside the support";
    loss.kind = "line";
    loss.y_scale = "linear";
    loss.caption = "The same loss beside the first support.";
    loss.x_range = {start, start + shown_halves * where->half};
    outcome.figures.push_back(loss);
  }
  outcome.figures.push_back({.name = "curvature_profile",
                             .title = "Curvature amplitude along the span",
                             .table = file,
                             .x = "x_m",
                             .y = {"curvature_amplitude_per_m"},
                             .caption = "The curvature that the cross sections go through in each cycle."});
}

}  // namespace strandyn::study
