#include "strandyn/self_damping/sectional_loss.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "strandyn/core/side_by_side.hpp"

namespace strandyn::self_damping {

using section::Component;

namespace {

/// The knots begin this part of the onset above it, and this part of the lowest amplitude where there is no onset:
/// what a sine loses below is nothing (its cube and more).
constexpr double above_onset = 1e-3;
constexpr double below_lowest = 1.0 / 32;

/// So many loops go through the law in one piece, whatever the number of cores: whole registers of it, so that each
/// loop has the same neighbours, and the same bits, as in one batch of all.
constexpr std::size_t together = 16;

/// A batch of points at one axial strain.
class Batch {
 public:
  Batch(const section::Law& law, double axial_strain, std::span<const double> amplitudes)
      : law_(law), amplitudes_(amplitudes), strains_(law.dimension(), amplitudes.size()), energy_(amplitudes.size()) {
    std::fill_n(strains_[Component::axial].begin(), amplitudes.size(), axial_strain);
    history_ = law.start(strains_);
  }

  /// Goes straight from one multiple of the amplitudes to another; adds the loss to `lost`. [J/m]
  void bend(double from, double to, int steps, std::vector<double>& lost) {
    for (int step = 1; step <= steps; ++step) {
      const double part = from + (to - from) * step / steps;
      for (std::size_t i = 0; i < amplitudes_.size(); ++i) strains_[Component::bending2][i] = part * amplitudes_[i];
      effort_ += law_.commit(history_, strains_, energy_);
      for (std::size_t i = 0; i < amplitudes_.size(); ++i) {
        lost[i] += energy_.dissipated[i] - energy_.quadrature_error[i];
      }
    }
  }
  /// Goes to the amplitudes in one step and says which points slip.
  std::vector<double> first_step() {
    std::copy(amplitudes_.begin(), amplitudes_.end(), strains_[Component::bending2].begin());
    effort_ += law_.commit(history_, strains_, energy_);
    return {energy_.dissipated.begin(), energy_.dissipated.begin() + static_cast<std::ptrdiff_t>(amplitudes_.size())};
  }
  /// [N m] where the last step has led.
  std::vector<double> moments() {
    section::Field stresses = strains_;
    effort_ += law_.respond(history_, strains_, stresses, nullptr);
    const auto& moment = stresses[Component::bending2];
    return {moment.begin(), moment.begin() + static_cast<std::ptrdiff_t>(amplitudes_.size())};
  }
  const section::Effort& effort() const { return effort_; }

 private:
  const section::Law& law_;
  std::span<const double> amplitudes_;
  section::Field strains_;
  section::StepEnergy energy_;
  section::History history_;
  section::Effort effort_;
};

std::vector<double> geometric(double first, double last, std::size_t count) {
  std::vector<double> list(count);
  for (std::size_t i = 0; i < count; ++i) {
    list[i] = first * std::pow(last / first, static_cast<double>(i) / static_cast<double>(count - 1));
  }
  list.back() = last;
  return list;
}

/// The largest amplitude without loss, to 1e-8 of itself; 0 where the smallest loses already, `highest` where none
/// does.
double find_onset(const section::Law& law, const SectionState& state, CurvatureRange range, section::Effort& effort) {
  constexpr std::size_t candidates = 65;
  bool between = false;  // range.lowest is known to lose nothing, range.highest to lose something
  while (range.highest > range.lowest * (1 + 1e-8)) {
    const std::vector<double> amplitudes = geometric(range.lowest, range.highest, candidates);
    Batch batch(law, state.axial_strain, amplitudes);
    const std::vector<double> lost = batch.first_step();
    effort += batch.effort();
    std::size_t i = 0;
    while (i < candidates && lost[i] <= 1e-12 * state.EI_max * amplitudes[i] * amplitudes[i]) ++i;
    if (!between && i == 0) return 0;
    if (!between && i == candidates) return range.highest;
    if (i == 0 || i == candidates) break;  // rounding between two candidates
    between = true;
    range = {.lowest = amplitudes[i - 1], .highest = amplitudes[i]};
  }
  return range.lowest;
}

/// Slopes of a monotone cubic through the knots.  [Fritsch and Butland 1984]
std::vector<double> monotone_slopes(const std::vector<double>& x, const std::vector<double>& y) {
  const std::size_t n = x.size();
  const auto secant = [&](std::size_t i) { return (y[i + 1] - y[i]) / (x[i + 1] - x[i]); };
  std::vector<double> slope(n);
  slope[0] = secant(0);
  slope[n - 1] = secant(n - 2);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double left = secant(i - 1), right = secant(i);
    const double h_left = x[i] - x[i - 1], h_right = x[i + 1] - x[i];
    const double w_left = 2 * h_right + h_left, w_right = h_right + 2 * h_left;
    slope[i] = left * right > 0 ? (w_left + w_right) / (w_left / left + w_right / right) : 0;
  }
  return slope;
}

}  // namespace

std::vector<ClosedLoop> closed_loops(const section::Law& law, const SectionState& state,
                                     std::span<const double> amplitudes, const LossOptions& options,
                                     section::Effort& effort) {
  const std::size_t pieces = (amplitudes.size() + together - 1) / together;
  std::vector<ClosedLoop> loops(amplitudes.size());
  std::vector<section::Effort> efforts(pieces);
  side_by_side(pieces, [&](std::size_t piece) {
    end_if_asked(options.stop);
    const std::size_t first = piece * together;
    const auto own = amplitudes.subspan(first, std::min(together, amplitudes.size() - first));
    std::vector<double> lost(own.size(), 0.0);
    Batch batch(law, state.axial_strain, own);
    batch.bend(0, -1, options.steps / 2, lost);
    batch.bend(-1, 1, options.steps, lost);
    std::ranges::fill(lost, 0.0);
    batch.bend(1, -1, options.steps, lost);
    const std::vector<double> moments = batch.moments();
    for (std::size_t i = 0; i < own.size(); ++i) loops[first + i] = {.loss = 2 * lost[i], .moment = -moments[i]};
    efforts[piece] = batch.effort();
  });
  for (const section::Effort& own : efforts) effort += own;
  return loops;
}

std::vector<double> loss_per_cycle(const section::Law& law, const SectionState& state,
                                   std::span<const double> amplitudes, const LossOptions& options,
                                   section::Effort& effort) {
  std::vector<double> lost;
  for (const ClosedLoop& loop : closed_loops(law, state, amplitudes, options, effort)) lost.push_back(loop.loss);
  return lost;
}

SectionalLoss::SectionalLoss(const section::Law& law, const SectionState& state, const CurvatureRange& range,
                             const LossOptions& options) {
  const CurvatureRange searched = {.lowest = below_lowest * range.lowest, .highest = range.highest};
  onset_ = find_onset(law, state, searched, effort_);
  const double sticks = onset_ > 0 ? onset_ : searched.lowest;
  Batch sticking(law, state.axial_strain, std::span(&sticks, 1));
  sticking.first_step();
  sticking_ = sticking.moments().front() / sticks;
  const double lowest = onset_ > 0 ? above_onset * onset_ : searched.lowest;
  const double highest = range.highest - onset_;
  if (highest <= lowest) {  // nothing slips, or so little that it would be lost in rounding
    onset_ = range.highest;
    return;
  }
  const auto count = std::max(2.0, std::ceil(std::log10(highest / lowest) * options.knots_per_decade));
  const double step = std::log(highest / lowest) / count;
  std::vector<double> places;
  for (int i = 0; i <= static_cast<int>(count); ++i) places.push_back(std::log(lowest) + i * step);
  add_knots(law, state, places, options);
  fill(law, state, options);
}

SectionalLoss::SectionalLoss(const LossTable& table)
    : onset_(table.onset),
      sticking_(table.sticking),
      effort_{.evaluations = table.evaluations, .sweeps = table.sweeps} {
  for (std::size_t i = 0; i < table.places.size(); ++i) insert(table.places[i], table.losses[i], table.secants[i]);
  if (!place_.empty()) slope_ = monotone_slopes(place_, value_);
}

LossTable SectionalLoss::table() const {
  return {.onset = onset_,
          .sticking = sticking_,
          .places = place_,
          .losses = losses_,
          .secants = secants_,
          .evaluations = effort_.evaluations,
          .sweeps = effort_.sweeps};
}

bool LossTable::is_sound() const {
  const auto finite = [](double x) { return std::isfinite(x); };
  const std::size_t knots = places.size();
  return finite(onset) && onset >= 0 && finite(sticking) && std::ranges::all_of(places, finite) &&
         std::ranges::all_of(losses, finite) && std::ranges::all_of(secants, finite) && losses.size() == knots &&
         secants.size() == knots && knots != 1 &&
         std::ranges::adjacent_find(places, std::greater_equal<>()) == places.end();
}

void SectionalLoss::fill(const section::Law& law, const SectionState& state, const LossOptions& options) {
  std::vector<std::array<double, 2>> intervals;
  for (std::size_t i = 0; i + 1 < place_.size(); ++i) intervals.push_back({place_[i], place_[i + 1]});
  for (int pass = 0; pass < options.passes && !intervals.empty(); ++pass) {
    std::vector<double> middles, guesses;
    for (const auto& [left, right] : intervals) {
      middles.push_back((left + right) / 2);
      guesses.push_back(value_at(middles.back()));
    }
    add_knots(law, state, middles, options);
    std::vector<std::array<double, 2>> rough;
    for (std::size_t i = 0; i < intervals.size(); ++i) {
      if (std::abs(value_at(middles[i]) - guesses[i]) < options.tolerance) continue;
      rough.push_back({intervals[i][0], middles[i]});
      rough.push_back({middles[i], intervals[i][1]});
    }
    intervals = std::move(rough);
  }
}

void SectionalLoss::add_knots(const section::Law& law, const SectionState& state, std::vector<double> places,
                              const LossOptions& options) {
  std::vector<double> amplitudes(places.size());
  std::ranges::transform(places, amplitudes.begin(), [this](double u) { return onset_ + std::exp(u); });
  const std::vector<ClosedLoop> loops = closed_loops(law, state, amplitudes, options, effort_);
  for (std::size_t i = 0; i < places.size(); ++i) insert(places[i], loops[i].loss, loops[i].moment / amplitudes[i]);
  slope_ = monotone_slopes(place_, value_);
}

void SectionalLoss::insert(double place, double loss, double secant) {
  const auto at = std::ranges::lower_bound(place_, place) - place_.begin();
  place_.insert(place_.begin() + at, place);
  amplitudes_.insert(amplitudes_.begin() + at, onset_ + std::exp(place));
  losses_.insert(losses_.begin() + at, loss);
  secants_.insert(secants_.begin() + at, secant);
  value_.insert(value_.begin() + at, std::log(std::max(loss, std::numeric_limits<double>::min())));
}

double SectionalLoss::value_at(double place) const {
  if (place <= place_.front()) return value_.front() + slope_.front() * (place - place_.front());
  if (place >= place_.back()) return value_.back() + slope_.back() * (place - place_.back());
  const auto i = static_cast<std::size_t>(std::ranges::upper_bound(place_, place) - place_.begin()) - 1;
  const double h = place_[i + 1] - place_[i];
  const double t = (place - place_[i]) / h;
  const double s = 1 - t;
  return s * s * (1 + 2 * t) * value_[i] + t * t * (1 + 2 * s) * value_[i + 1] +
         s * t * h * (s * slope_[i] - t * slope_[i + 1]);
}

double SectionalLoss::secant(double amplitude) const {
  if (losses_.empty() || !(amplitude > onset_)) return sticking_;
  const double place = std::log(amplitude - onset_);
  if (place <= place_.front()) return secants_.front();
  if (place >= place_.back()) return secants_.back();
  const auto i = static_cast<std::size_t>(std::ranges::upper_bound(place_, place) - place_.begin()) - 1;
  const double t = (place - place_[i]) / (place_[i + 1] - place_[i]);
  return (1 - t) * secants_[i] + t * secants_[i + 1];
}

double SectionalLoss::at(double amplitude) const {
  if (!(amplitude > onset_) || losses_.empty()) return 0;
  return std::exp(value_at(std::log(amplitude - onset_)));
}

}  // namespace strandyn::self_damping
