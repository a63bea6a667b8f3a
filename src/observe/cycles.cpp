#include "strandyn/observe/cycles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace strandyn::observe {

using section::Component;

void CycleObserver::Range::restart(std::size_t size) {
  low.assign(size, std::numeric_limits<double>::max());
  high.assign(size, std::numeric_limits<double>::lowest());
}

void CycleObserver::Range::widen(std::size_t i, double value) {
  low[i] = std::min(low[i], value);
  high[i] = std::max(high[i], value);
}

void CycleObserver::begin(const system::System& system, const StepRecord& initial) {
  ledger_.begin(system, initial);
  before_ = cycle_start_ = ledger_.now();
  time_before_ = initial.time;
  places_.emplace(system.model(), options_.loop_length);
  system_is_planar_ = !model::is_spatial(system.model().freedom);
  restart(system);
  watch(system, initial);
}

void CycleObserver::restart(const system::System& system) {
  deflection_.restart(*places_);
  curvature_.restart(system.committed_strains().points());
  curvature_3_.restart(curvature_.low.size());
  friction_.assign(system.committed_strains().points(), 0.0);
  material_ = friction_;
}

void CycleObserver::watch(const system::System& system, const StepRecord& record) {
  deflection_.widen(*places_, record.u.data());
  const section::Field& strains = system.committed_strains();
  for (std::size_t point = 0; point < friction_.size(); ++point) {
    curvature_.widen(point, strains[Component::bending2][point]);
    if (!strains[Component::bending3].empty()) curvature_3_.widen(point, strains[Component::bending3][point]);
  }
}

void CycleObserver::step(const system::System& system, const StepRecord& record) {
  ledger_.step(system, record);
  const AlignedVector& dissipated = system.step_energy().dissipated;
  for (std::size_t point = 0; point < friction_.size(); ++point) friction_[point] += dissipated[point];
  if (!system.material().is_empty()) {
    const AlignedVector& of_metal = system.material().dissipated();
    for (std::size_t point = 0; point < material_.size(); ++point) material_[point] += of_metal[point];
  }
  watch(system, record);

  const double rounding = 1e-9 * options_.period;
  for (;;) {
    const double end = options_.period * static_cast<double>(count_ + 1);
    if (record.time < end - rounding) break;
    const double part = std::clamp((end - time_before_) / (record.time - time_before_), 0.0, 1.0);
    end_cycle(interpolate(before_, ledger_.now(), part), end);
    restart(system);
    watch(system, record);
  }
  before_ = ledger_.now();
  time_before_ = record.time;
}

void CycleObserver::archive(Archive& a) {
  a(ledger_, before_, cycle_start_, time_before_, cycles_, count_);
  a(deflection_, curvature_, curvature_3_, friction_, material_, kept_);
  if (a.reads()) check_read();
}

/// What the sizes of the rows leave open: cycles that have ended are as many as the time has periods.
void CycleObserver::check_read() const {
  const double ended = time_before_ / options_.period;
  const auto count = static_cast<double>(count_);
  const bool counted = count >= std::floor(ended) && count <= std::floor(ended + 1e-6);
  const bool kept =
      cycles_.size() <= count_ && (count_ == 0 || !cycles_.empty()) && kept_.size() == std::min(count_, options_.kept);
  const bool whole = std::ranges::all_of(kept_, [this](const PointRecord& record) {
    return record.friction.size() == friction_.size() && record.material.size() == friction_.size() &&
           record.curvature_amplitude.size() == friction_.size();
  });
  if (!counted || !kept || !whole) throw InputError("its cycles are not those of its time");
}

void CycleObserver::end_cycle(const Account& at_end, double time) {
  Cycle cycle{.end_time = time,
              .antinode_amplitude = deflection_.largest(),
              .external_work = at_end.external_work - cycle_start_.external_work,
              .wind = at_end.wind - cycle_start_.wind,
              .kinetic = at_end.kinetic,
              .elastic = at_end.elastic,
              .friction = at_end.friction - cycle_start_.friction,
              .material = at_end.material - cycle_start_.material,
              .viscous = at_end.viscous.total() - cycle_start_.viscous.total(),
              .viscous_parts =
                  system::of_each_term([&](auto term) { return at_end.viscous.*term - cycle_start_.viscous.*term; }),
              .air = at_end.air - cycle_start_.air,
              .attached = at_end.attached - cycle_start_.attached,
              .numerical = at_end.numerical() - cycle_start_.numerical(),
              .quadrature_error = at_end.quadrature_error - cycle_start_.quadrature_error,
              .internal_work = at_end.internal_work - cycle_start_.internal_work};
  PointRecord points{.friction = friction_, .material = material_, .curvature_amplitude = {}};
  for (std::size_t point = 0; point < friction_.size(); ++point) {
    const bool spatial = !system_is_planar_;
    points.curvature_amplitude.push_back(
        std::max(curvature_.amplitude(point), spatial ? curvature_3_.amplitude(point) : 0.0));
  }
  for (std::size_t first = 0; first < friction_.size(); first += beam::gauss_points) {
    const auto begin = friction_.begin() + static_cast<std::ptrdiff_t>(first);
    const bool slips = std::any_of(begin, begin + beam::gauss_points, [](double loss) { return loss > 0; });
    cycle.elements_slipping += slips ? 1 : 0;
  }
  kept_.push_back(std::move(points));
  if (kept_.size() > options_.kept) kept_.pop_front();
  cycles_.push_back(cycle);
  ++count_;
  // Cut in one piece now and then: a long run costs no memory.
  if (cycles_.size() / 2 > options_.most)
    cycles_.erase(cycles_.begin(), cycles_.end() - static_cast<std::ptrdiff_t>(options_.most));
  if (options_.each) options_.each(cycle);
  cycle_start_ = at_end;
}

Profile CycleObserver::profile(const system::System& system) const {
  const std::size_t points = system.committed_strains().points();
  Profile profile{.position = {},
                  .length = {},
                  .friction = std::vector<double>(points, 0.0),
                  .material = std::vector<double>(points, 0.0),
                  .curvature_amplitude = std::vector<double>(points, 0.0),
                  .cycles = kept_.size()};
  const std::vector<double> arc = model::arc_lengths(system.model());
  for (std::size_t point = 0; point < points; ++point) {
    const std::size_t element = point / beam::gauss_points;
    const double part = beam::gauss_position[point % beam::gauss_points];
    profile.position.push_back(arc[element] + part * (arc[element + 1] - arc[element]));
    profile.length.push_back(system.point_length(point));
    for (const PointRecord& record : kept_) {
      const double weight = 1 / static_cast<double>(kept_.size());
      profile.friction[point] += weight * record.friction[point];
      profile.material[point] += weight * record.material[point];
      profile.curvature_amplitude[point] += weight * record.curvature_amplitude[point];
    }
  }
  return profile;
}

}  // namespace strandyn::observe
