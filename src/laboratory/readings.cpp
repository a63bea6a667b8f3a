#include "strandyn/laboratory/readings.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "strandyn/solver/periodic/periodic.hpp"
#include "strandyn/span/free_span.hpp"

namespace strandyn::laboratory {

using solver::LoopPoint;
using std::numbers::pi;
using system::Vector;

namespace {

LedgerReading read_ledger(const SteadyRun& steady, double length) {
  LedgerReading route;
  const double weight = 1 / static_cast<double>(steady.cycles.size());
  for (const observe::Cycle& cycle : steady.cycles) {
    route.friction += weight * cycle.friction;
    route.material += weight * cycle.material;
    route.viscous += weight * cycle.viscous;
    route.air += weight * cycle.air;
    route.numerical += weight * cycle.numerical;
    route.quadrature_error += weight * cycle.quadrature_error;
  }
  const double lost = route.friction + route.material + route.viscous;
  route.power = lost * steady.drive.frequency / length;
  route.air_power = route.air * steady.drive.frequency / length;
  if (lost + route.air > 0) route.numerical_share = std::abs(route.numerical) / (lost + route.air);
  return route;
}

PowerReading read_power(const SteadyRun& steady, double length) {
  const std::complex<double> velocity = std::complex<double>(0, 2 * pi * steady.drive.frequency) * steady.driven;
  double work = 0;
  for (const observe::Cycle& cycle : steady.cycles) work += cycle.external_work;
  work /= static_cast<double>(steady.cycles.size());
  return {.from_phasors = analysis::drive_power(steady.force, velocity) / length,
          .from_work = analysis::power_method({.work = work, .frequency = steady.drive.frequency}, length),
          .phase = std::abs(steady.force * velocity) > 0 ? std::arg(steady.force / velocity) : 0};
}

/// [W] mean that viscous forces take at each node, those of the air not among them.
std::vector<double> viscous_by_node(const span::SpanAtRest& span, const Eigen::VectorXcd& velocity) {
  std::vector<double> power(span.built.model.nodes.size(), 0.0);
  const std::size_t per_node = span.built.model.unknowns_per_node();
  const Vector none = span.system.make_vector();
  for (const Vector& part : {Vector(velocity.real()), Vector(velocity.imag())}) {
    Vector forward = none;
    Vector backward = none;  // what inertia adds is even in the velocity
    const Vector opposite = -part;
    span.system.add_inertia_and_drag({.u = span.u.data(), .v = part.data(), .a = none.data()}, forward.data());
    span.system.add_inertia_and_drag({.u = span.u.data(), .v = opposite.data(), .a = none.data()}, backward.data());
    for (std::size_t i = 0; i < span.system.unknowns(); ++i) {
      const auto at = static_cast<Eigen::Index>(i);
      if (span.system.has_mass(i)) power[i / per_node] += part(at) * (forward(at) - backward(at)) / 4;
    }
    if (span.system.air().is_none()) continue;
    const std::vector<double> air = span.system.air_on_chain().power_by_node(span.system.air(), part.data());
    for (std::size_t node = 0; node < power.size(); ++node) power[node] -= air[node] / 2;
  }
  return power;
}

Eigen::VectorXcd velocity_of(const SteadyRun& steady) {
  return std::complex<double>(0, 2 * pi * steady.drive.frequency) * steady.motion;
}

/// [W] the ledger by position: every section point stands for half of its element.
double lost_between(const BenchSpan& bench, const SteadyRun& steady, double from, double to) {
  const span::SpanAtRest& span = bench.at_rest();
  const span::Piece piece{.from = from, .to = to};
  const std::vector<double> lengths = span::section_lengths(span, piece);
  double power = 0;
  for (std::size_t point = 0; point < lengths.size(); ++point) {
    power += steady.drive.frequency * steady.profile.self_damping(point) * lengths[point];
  }
  return power + span::of_nodes(span.built.model, viscous_by_node(span, velocity_of(steady)), piece);
}

std::vector<LoopPoint> loop_points(const BenchSpan& bench, const SteadyRun& steady) {
  return solver::loop_points(bench.at_rest().built.model, model::Unknown::y, steady.motion);
}

/// [m] the largest antinode of the fundamental, a loop and more from the ends where there are three.
double largest_antinode(const BenchSpan& bench, const std::vector<LoopPoint>& points) {
  const double length = bench.at_rest().built.length;
  const double margin = length >= 2.99 * bench.loop_length() ? bench.loop_length() : 0;
  double largest = 0;
  for (const LoopPoint& point : points) {
    if (point.position >= margin && point.position <= length - margin) largest = std::max(largest, point.amplitude);
  }
  return largest;
}

/// Those on the longer side of the shaker, from there on.
std::vector<LoopPoint> beyond_the_shaker(const BenchSpan& bench, std::vector<LoopPoint> points) {
  const bool to_the_right = bench.shaker_position() <= bench.at_rest().built.length / 2;
  if (!to_the_right) std::ranges::reverse(points);
  std::erase_if(points, [&](const LoopPoint& point) {
    return to_the_right ? point.position <= bench.shaker_position() : point.position >= bench.shaker_position();
  });
  return points;
}

double secant_stiffness(const SteadyRun& steady, double from, double to) {
  double stress = 0;
  double strain = 0;
  for (std::size_t point = 0; point < steady.profile.position.size(); ++point) {
    if (steady.profile.position[point] < from || steady.profile.position[point] > to) continue;
    const auto row = static_cast<Eigen::Index>(point);
    stress += steady.curvature.row(row).dot(steady.moment.row(row)).real();
    strain += steady.curvature.row(row).squaredNorm();
  }
  return strain > 0 ? stress / strain : 0;
}

std::optional<IswrReading> read_iswr(const BenchSpan& bench, const SteadyRun& steady,
                                     const std::vector<LoopPoint>& all) {
  const std::vector<LoopPoint> points = beyond_the_shaker(bench, all);
  const auto is_node = [](const LoopPoint& point) { return !point.antinode; };
  const auto near = std::ranges::find_if(points, is_node);
  const auto last = std::find_if(points.rbegin(), points.rend(), is_node);
  const auto loops = std::ranges::count_if(points, is_node) - 1;
  if (loops < 1) return std::nullopt;
  const auto far = std::prev(last.base());
  const double mass = bench.at_rest().built.model.inertia.mass;
  const double omega = 2 * pi * steady.drive.frequency;

  IswrReading route;
  route.near_position = near->position;
  route.far_position = far->position;
  route.loops = static_cast<int>(loops);
  route.nodes = {.near = {.node_amplitude = near->amplitude, .antinode_amplitude = std::next(near)->amplitude},
                 .far = {.node_amplitude = far->amplitude, .antinode_amplitude = std::prev(far)->amplitude},
                 .distance = std::abs(far->position - near->position)};
  const double from = std::min(near->position, far->position);
  const double to = std::max(near->position, far->position);
  const double k = pi * static_cast<double>(loops) / route.nodes.distance;
  const double EI = secant_stiffness(steady, from, to);
  route.guide = {.tension = mass * omega * omega / (k * k) - EI * k * k, .mass_per_length = mass, .EI = EI};
  route.power = analysis::iswr_method(route.nodes, route.guide, steady.drive.frequency);
  route.by_string = analysis::iswr_method(
      route.nodes, {.tension = bench.at_rest().built.tension, .mass_per_length = mass}, steady.drive.frequency);
  route.ledger = lost_between(bench, steady, from, to) / (to - from);
  const system::System& system = bench.at_rest().system;
  route.air =
      span::of_nodes(system.model(), system.air_on_chain().swing_power_by_node(system.air(), velocity_of(steady)),
                     {.from = from, .to = to}) /
      (to - from);
  return route;
}

/// [J] kinetic energy of the fundamental at its crest.
double crest_energy(const span::SpanAtRest& span, const SteadyRun& steady) {
  const auto energy = [&](const Vector& velocity) {
    return span.system.kinetic_energy(span.u.data(), velocity.data());
  };
  const double omega = 2 * pi * steady.drive.frequency;
  const Vector re = omega * steady.motion.real();
  const Vector im = omega * steady.motion.imag();
  const double along = energy(re);
  const double across = energy(im);
  const double both = energy(re + im) - along - across;  // re . M im
  return (along + across + std::hypot(along - across, both)) / 2;
}

/// What two neighbouring cycles of the decay tell, at the mean of their amplitudes.
struct DecayingPair {
  double off = 0;        // logarithm of the amplitude over the wanted one
  double decrement = 0;  // [-]
  double loss = 0;       // [J] per cycle
};

/// The first cycle is left out: the shaker's part of the motion has just gone.
std::vector<DecayingPair> decaying_pairs(const BenchRun& run) {
  std::vector<DecayingPair> pairs;
  for (std::size_t i = 1; i + 1 < run.decay.size(); ++i) {
    const std::span two(run.decay.data() + i, 2);
    const auto fit = analysis::fit_decrement(two);
    if (!fit) break;
    pairs.push_back({.off = std::log(std::sqrt(two[0] * two[1]) / run.steady.modal_amplitude),
                     .decrement = fit->decrement,
                     .loss = std::sqrt(run.decay_losses[i] * run.decay_losses[i + 1])});
  }
  // Those within a quarter of the amplitude, three at least.
  std::ranges::sort(pairs, {}, [](const DecayingPair& pair) { return std::abs(pair.off); });
  while (pairs.size() > 3 && std::abs(pairs.back().off) > 0.25) pairs.pop_back();
  return pairs;
}

/// At the wanted amplitude, by a parabola over its logarithm; a line through few. Losses fall with a power of the
/// amplitude, so that their logarithm is what is nearly straight; where there are none, they are fitted as they are.
double at_amplitude(const std::vector<DecayingPair>& pairs, double DecayingPair::*value) {
  const Eigen::Index terms = pairs.size() > 4 ? 3 : 2;
  Eigen::MatrixXd powers(static_cast<Eigen::Index>(pairs.size()), terms);
  Vector values(powers.rows());
  const bool logarithms = std::ranges::all_of(pairs, [&](const DecayingPair& pair) { return pair.*value > 0; });
  for (Eigen::Index i = 0; i < powers.rows(); ++i) {
    const DecayingPair& pair = pairs[static_cast<std::size_t>(i)];
    for (Eigen::Index term = 0; term < terms; ++term) powers(i, term) = std::pow(pair.off, static_cast<double>(term));
    values(i) = logarithms ? std::log(pair.*value) : pair.*value;
  }
  const double found = powers.colPivHouseholderQr().solve(values)(0);
  return logarithms ? std::exp(found) : found;
}

std::optional<DecayReading> read_decay(const BenchSpan& bench, const BenchRun& run, double antinode_amplitude) {
  const std::vector<DecayingPair> pairs = decaying_pairs(run);
  if (pairs.size() < 3) return std::nullopt;
  const double length = bench.at_rest().built.length;
  const double frequency = run.steady.drive.frequency;
  DecayReading route{.amplitudes = run.decay, .decrement = at_amplitude(pairs, &DecayingPair::decrement)};
  route.modal_energy = crest_energy(bench.at_rest(), run.steady);
  route.power = 2 * route.decrement * route.modal_energy * frequency / length;
  route.ledger = at_amplitude(pairs, &DecayingPair::loss) * frequency / length;
  route.by_sine = analysis::decay_method(route.decrement, {.mass_per_length = bench.at_rest().built.model.inertia.mass,
                                                           .frequency = frequency,
                                                           .velocity = 2 * pi * frequency * antinode_amplitude});
  return route;
}

}  // namespace

Readings read_all(const BenchSpan& bench, const BenchRun& run) {
  const double length = bench.at_rest().built.length;
  Readings routes{.ledger = read_ledger(run.steady, length), .power = read_power(run.steady, length)};
  for (const observe::Cycle& cycle : run.steady.cycles) {
    routes.antinode_amplitude += cycle.antinode_amplitude / static_cast<double>(run.steady.cycles.size());
  }
  const std::vector<LoopPoint> points = loop_points(bench, run.steady);
  routes.fundamental_amplitude = largest_antinode(bench, points);
  routes.iswr = read_iswr(bench, run.steady, points);
  routes.decay = read_decay(bench, run, routes.antinode_amplitude);
  return routes;
}

}  // namespace strandyn::laboratory
