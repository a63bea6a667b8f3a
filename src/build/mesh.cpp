#include "strandyn/model/mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "parts.hpp"
#include "strandyn/build/wind.hpp"

namespace strandyn::build {
namespace {

/// Beyond this a mesh is no choice of the program.
constexpr std::size_t most_automatic = 200000;

/// Half a wave [m] at the highest frequency that the scene speaks of; unless elements of a loop are asked for, that of
/// the twelfth mode where it speaks of lower ones or of none.
double shortest_loop(const casefile::Scene& scene, double tension, double length) {
  double shortest = scene.span->elements_per_loop ? length : length / 12;
  const auto consider_mode = [&](int mode) { shortest = std::min(shortest, length / mode); };
  const auto consider = [&](const auto& source) {
    if (source.frequency) shortest = std::min(shortest, loop_length(scene, tension, *source.frequency));
    if (source.frequency_mode) consider_mode(*source.frequency_mode);
  };
  for (const casefile::Load& load : scene.loads) consider(load);
  for (const casefile::Motion& motion : scene.motions) consider(motion);
  if (scene.initial) consider_mode(scene.initial->velocity_mode);
  for (const casefile::WindKeys& wind : scene.winds) {
    if (wind.mode) consider_mode(*wind.mode);
    if (const auto frequency = shedding_frequency(scene)) {
      shortest = std::min(shortest, loop_length(scene, tension, *frequency));
    }
  }
  std::visit(
      [&](const auto& analysis) {
        if constexpr (requires { analysis.near_frequency; }) {
          // Modes near a frequency: as many loops as it makes, and as many more as there are modes above it.
          double loops = analysis.highest_mode();
          if (analysis.near_frequency) loops += length / loop_length(scene, tension, *analysis.near_frequency);
          shortest = std::min(shortest, length / loops);
        } else if constexpr (requires { analysis.highest_mode(); }) {
          consider_mode(analysis.highest_mode());
        }
      },
      scene.analysis);
  return shortest;
}

/// [m] places that must be nodes.
std::vector<double> stations(const casefile::Scene& scene) {
  std::vector<double> at;
  for (const casefile::Load& load : scene.loads) {
    if (load.at) at.push_back(*load.at);
  }
  for (const casefile::Motion& motion : scene.motions) {
    if (motion.at) at.push_back(*motion.at);
  }
  for (const casefile::Body& body : scene.bodies) at.push_back(body.at);
  for (const casefile::DamperKeys& damper : scene.dampers) at.push_back(damper.at);
  for (const casefile::StretchKeys& stretch : scene.span->stretches) {
    for (const double end : {stretch.from, stretch.to}) {
      if (end > 0 && end < *scene.span->length) at.push_back(end);
    }
  }
  std::visit(
      [&](const auto& analysis) {
        if constexpr (requires { analysis.probes; })
          at.insert(at.end(), analysis.probes.begin(), analysis.probes.end());
      },
      scene.analysis);
  return at;
}

/// What a span of a line asks of its mesh: from one support to the next.
struct Leg {
  double from = 0, to = 0;  // [m]
  double tension = 0;       // [N]
  bool grade_left = false, grade_right = false;
};

std::vector<Leg> legs_of(const casefile::Scene& scene, const SectionNumbers& numbers, const BuiltSpan& built) {
  const casefile::Span& span = *scene.span;
  const bool graded = span.grading == casefile::Grading::clamps && built.tension > 0;
  std::vector<Leg> legs;
  if (span.supports.empty()) {
    legs.push_back({.from = 0, .to = built.length, .tension = built.tension});
  } else {
    for (const Stretch& stretch : stretches_of(scene, numbers.EA)) {
      // At a suspension a line bends as at a clamp, where its spans do not swing alike.
      legs.push_back({.from = stretch.from,
                      .to = stretch.to,
                      .tension = stretch.stringing.tension,
                      .grade_left = graded,
                      .grade_right = graded});
    }
  }
  legs.front().grade_left = graded && span.left == casefile::Support::clamped;
  legs.back().grade_right = graded && span.right == casefile::Support::clamped;
  return legs;
}

/// Elements for each leg in proportion to its length, at least one; what rounding leaves goes to the longest elements.
std::vector<std::size_t> share_out(const std::vector<double>& legs, std::size_t elements);

std::vector<double> straight_positions(const casefile::Scene& scene, const SectionNumbers& numbers, BuiltSpan& built) {
  const casefile::Span& span = *scene.span;
  const std::vector<Leg> legs = legs_of(scene, numbers, built);
  const double elements_per_loop = std::visit(
      [&](const auto& analysis) {
        if constexpr (requires { analysis.elements_per_loop; }) return analysis.elements_per_loop;
        return span.elements_per_loop.value_or(10.0);
      },
      scene.analysis);
  std::vector<std::size_t> shares;
  if (span.elements) {
    std::vector<double> lengths;
    for (const Leg& leg : legs) lengths.push_back(leg.to - leg.from);
    shares = share_out(lengths, static_cast<std::size_t>(*span.elements));
  }
  const std::vector<double> wanted = stations(scene);
  std::vector<double> positions = {0};
  std::size_t total = 0;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const Leg& leg = legs[i];
    model::MeshOptions options{.length = leg.to - leg.from,
                               .elements = 0,
                               .end_size = 0,
                               .grade_left = leg.grade_left,
                               .grade_right = leg.grade_right,
                               .growth = 0.25,
                               .stations = {}};
    for (const double s : wanted) {
      const double apart = legs.size() > 1 ? model::same_place(built.length) : 0;  // a suspension is a node already
      if (legs.size() == 1 || (s > leg.from + apart && s < leg.to - apart)) options.stations.push_back(s - leg.from);
    }
    // Half of the length within which bending dies out at a clamp when all wires slip there.
    const bool graded = span.grading == casefile::Grading::clamps && leg.tension > 0;
    if (graded) options.end_size = 0.5 * std::sqrt(numbers.EI_min / leg.tension);
    if (i == 0) built.end_size = options.end_size;
    const double loop = shortest_loop(scene, leg.tension, built.length);
    options.elements = span.elements ? shares[i] : model::elements_for(options, loop / elements_per_loop);
    total += options.elements;
    if (!span.elements && total > most_automatic) {
      casefile::refuse(
          scene.source, "span",
          fmt::format("loops of {:.3g} m on {:.6g} m take {} elements{}", loop, built.length, total,
                      total >= 1000000000 ? " or more" : ""),
          fmt::format("the program chooses at most {}: give span.elements, a lower frequency or a shorter span",
                      most_automatic));
    }
    const std::vector<double> nodes = model::span_mesh(options);
    for (std::size_t n = 1; n < nodes.size(); ++n) positions.push_back(leg.from + nodes[n]);
  }
  return positions;
}

std::vector<std::size_t> share_out(const std::vector<double>& legs, std::size_t elements) {
  const double total = std::accumulate(legs.begin(), legs.end(), 0.0);
  std::vector<std::size_t> share;
  std::size_t used = 0;
  for (double leg : legs) {
    share.push_back(std::max<std::size_t>(1, static_cast<std::size_t>(static_cast<double>(elements) * leg / total)));
    used += share.back();
  }
  for (; used < elements; ++used) {
    std::size_t longest = 0;
    for (std::size_t i = 1; i < legs.size(); ++i) {
      if (legs[i] / static_cast<double>(share[i]) > legs[longest] / static_cast<double>(share[longest])) longest = i;
    }
    ++share[longest];
  }
  return share;
}

std::vector<double> polyline_positions(const casefile::Scene& scene) {
  const casefile::Span& span = *scene.span;
  std::vector<double> legs;
  for (std::size_t i = 0; i + 1 < span.nodes.size(); ++i) {
    const Eigen::Vector3d a = Eigen::Map<const Eigen::Vector3d>(span.nodes[i].data());
    legs.push_back((Eigen::Map<const Eigen::Vector3d>(span.nodes[i + 1].data()) - a).norm());
  }
  if (span.elements && static_cast<std::size_t>(*span.elements) < legs.size()) {
    casefile::refuse(scene.source, "span.elements", "there are fewer elements than legs of the bend",
                     "give at least one element for every leg between two corners of nodes_m");
  }
  const std::size_t elements =
      span.elements ? static_cast<std::size_t>(*span.elements) : std::max<std::size_t>(20, 4 * legs.size());
  const std::vector<std::size_t> share = share_out(legs, elements);
  std::vector<double> positions = {0};
  const std::vector<double> wanted = stations(scene);
  double start = 0;
  for (std::size_t leg = 0; leg < legs.size(); ++leg) {
    model::MeshOptions options{.length = legs[leg], .elements = share[leg], .stations = {}};
    for (double s : wanted) {
      const double apart = model::same_place(legs[leg]);  // a corner is a node already
      if (s > start + apart && s < start + legs[leg] - apart) options.stations.push_back(s - start);
    }
    const std::vector<double> nodes = model::span_mesh(options);
    for (std::size_t i = 1; i < nodes.size(); ++i) positions.push_back(start + nodes[i]);
    start = positions.back();
  }
  return positions;
}

}  // namespace

std::vector<double> mesh_positions(const casefile::Scene& scene, const SectionNumbers& numbers, BuiltSpan& built) {
  return scene.span->nodes.empty() ? straight_positions(scene, numbers, built) : polyline_positions(scene);
}

}  // namespace strandyn::build
