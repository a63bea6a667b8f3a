#include "strandyn/section/masing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "masing_kernel.hpp"
#include "strandyn/conductor/constants.hpp"
#include "strandyn/conductor/contact.hpp"
#include "strandyn/core/error.hpp"

namespace strandyn::section {

using enum Component;

namespace {

/// A point of the friction moment's path.
struct PathPoint {
  double chi = 0;   ///< [1/m]
  double M = 0;     ///< [N m] friction part
  double U = 0;     ///< [J/m] stored by the friction part
  double loss = 0;  ///< [J/m] dissipated since the beginning of the branch that led here
};
constexpr std::size_t path_point_rows = 4;

/// Layout of a block of the history: these rows of `block_lanes` doubles, then c of each layer, then the stack.
enum Row : std::size_t {
  committed = 0,            ///< a path point
  depth = path_point_rows,  ///< [-] reversal points on the stack
  stick,                    ///< [1/m] smallest c of the layers that have friction: nothing slips below it
  EI_stick,                 ///< [N m^2] sum of EI_c of the layers that have friction
  elastic_low,              ///< [1/m] from here ...
  elastic_high,             ///< [1/m] ... to here nothing slips: M = elastic_M + EI_stick (chi - elastic_chi)
  elastic_chi,              ///< [1/m]
  elastic_M,                ///< [N m]
  first_layer
};

constexpr std::size_t rows_before_stack(std::size_t layers) {
  return first_layer + layers;
}
constexpr std::size_t initial_capacity = 8;

/// Reversal points that the history has room for, per section.
std::size_t capacity_of(const History& history, std::size_t layers) {
  const std::size_t rows = history.data.size() / std::max(padded(history.points), block_lanes);
  return rows > rows_before_stack(layers) ? (rows - rows_before_stack(layers)) / path_point_rows : 0;
}

std::size_t block_size(std::size_t layers, std::size_t capacity) {
  return (rows_before_stack(layers) + capacity * path_point_rows) * block_lanes;
}

/// One section of a block; T is double or const double.
template <class T>
class Lane {
 public:
  Lane(T* block, std::size_t lane, std::size_t layers) : at_(block + lane), stack_(rows_before_stack(layers)) {}

  T& operator[](std::size_t row) const { return at_[row * block_lanes]; }
  PathPoint committed_point() const { return read(committed); }
  PathPoint reversal(std::size_t i) const { return read(stack_ + i * path_point_rows); }
  std::size_t remembered() const { return static_cast<std::size_t>((*this)[depth]); }
  void set_committed(const PathPoint& p) const { write(committed, p); }
  void set_reversal(std::size_t i, const PathPoint& p) const { write(stack_ + i * path_point_rows, p); }

 private:
  PathPoint read(std::size_t row) const {
    return {.chi = (*this)[row], .M = (*this)[row + 1], .U = (*this)[row + 2], .loss = (*this)[row + 3]};
  }
  void write(std::size_t row, const PathPoint& p) const {
    (*this)[row] = p.chi;
    (*this)[row + 1] = p.M;
    (*this)[row + 2] = p.U;
    (*this)[row + 3] = p.loss;
  }

  T* at_;
  std::size_t stack_;
};

/// The branch on which a trial curvature lies, and what the way there did to the memory.
struct Branch {
  PathPoint origin;            ///< where it begins
  double scale = 1;            ///< 1: the virgin curve, 2: a branch after a reversal
  std::size_t depth = 0;       ///< reversal points that remain, the origin of this branch being the last
  bool turned_here = false;    ///< that last one is the committed point, not yet on the stack
  double loss_on_the_way = 0;  ///< [J/m] D of the step = loss on this branch + this
};

/// Follows the straight path from the committed point to `chi`. The full loss of a branch that closes its loop is the
/// loss of the branch that opened it, so no closed form is evaluated on the way.
template <class T>
Branch follow(const Lane<T>& lane, double chi) {
  const PathPoint here = lane.committed_point();
  const std::size_t before = lane.remembered();
  const auto entry = [&](std::size_t i) { return i < before ? lane.reversal(i) : here; };

  const double from = before > 0 ? lane.reversal(before - 1).chi : 0;
  const bool slipped = std::abs(here.chi - from) > (before > 0 ? 2 : 1) * lane[stick];
  const bool turns = slipped && chi != here.chi && (chi < here.chi) == (from < here.chi);

  Branch branch;
  std::size_t count = before + (turns ? 1 : 0);
  branch.loss_on_the_way = turns ? 0 : -here.loss;
  while (count > 0) {
    const PathPoint top = entry(count - 1);
    const PathPoint below = count > 1 ? entry(count - 2) : PathPoint{.chi = -top.chi, .M = 0, .U = 0, .loss = 0};
    const bool rising = below.chi > top.chi;
    if (rising ? chi >= below.chi : chi <= below.chi) {
      // The loop closes. From the first reversal it takes twice the virgin curve's loss to get to the other side.
      branch.loss_on_the_way += top.loss - below.loss;
      count -= std::min<std::size_t>(count, 2);
    } else if (rising ? chi < top.chi : chi > top.chi) {
      // Back over a turn after which nothing had slipped.
      branch.loss_on_the_way -= top.loss;
      count -= 1;
    } else {
      break;
    }
  }
  branch.depth = count;
  branch.turned_here = count > before;
  if (count > 0) {
    branch.origin = entry(count - 1);
    branch.scale = 2;
  }
  return branch;
}

/// Where the next move slips nothing: ahead of the branch's origin as long as nothing slipped on it, else behind the
/// committed point, which would become the next reversal. Twice the smallest limit, on the virgin curve once to each
/// side.
void set_elastic_range(const Lane<double>& lane) {
  const PathPoint here = lane.committed_point();
  const std::size_t depth_now = lane.remembered();
  const double reach = lane[stick];
  const PathPoint origin = depth_now > 0 ? lane.reversal(depth_now - 1) : PathPoint{};
  const bool slipped = std::abs(here.chi - origin.chi) > (depth_now > 0 ? 2 : 1) * reach;
  const PathPoint& anchor = slipped ? here : origin;
  lane[elastic_chi] = anchor.chi;
  lane[elastic_M] = anchor.M;
  if (!slipped && depth_now == 0) {
    lane[elastic_low] = -reach;
    lane[elastic_high] = reach;
    return;
  }
  const double end = slipped ? origin.chi : (depth_now > 1 ? lane.reversal(depth_now - 2).chi : -origin.chi);
  lane[elastic_low] = end < anchor.chi ? anchor.chi - 2 * reach : anchor.chi;
  lane[elastic_high] = end < anchor.chi ? anchor.chi : anchor.chi + 2 * reach;
}

/// The friction part of a block of sections at trial curvatures.
struct Trial {
  std::array<Branch, block_lanes> branch;
  masing_kernel::VirginCurve curve;  ///< at (chi - origin)/scale
  std::size_t swept = 0;             ///< sections that slip on their branch, padding not counted
};

/// Leaves out the lanes that `skip` marks.
Trial try_block(std::span<const double> EI_layer, const double* block, const double* chi, std::size_t real_lanes,
                const std::array<bool, block_lanes>& skip) {
  Trial trial;
  alignas(64) std::array<double, block_lanes> h{};
  std::array<bool, block_lanes> sticks;
  bool someone_slips = false;
  for (std::size_t i = 0; i < block_lanes; ++i) {
    sticks[i] = true;
    if (skip[i]) continue;
    const Lane<const double> lane(block, i, EI_layer.size());
    trial.branch[i] = follow(lane, chi[i]);
    h[i] = (chi[i] - trial.branch[i].origin.chi) / trial.branch[i].scale;
    sticks[i] = std::abs(h[i]) <= lane[stick];
    someone_slips = someone_slips || !sticks[i];
    trial.swept += i < real_lanes && !sticks[i] ? 1 : 0;
  }
  if (someone_slips) masing_kernel::virgin_curve(EI_layer, block + first_layer * block_lanes, h.data(), trial.curve);
  for (std::size_t i = 0; i < block_lanes; ++i) {
    if (!sticks[i]) continue;
    const double EI = block[EI_stick * block_lanes + i];
    trial.curve.moment[i] = EI * h[i];
    trial.curve.tangent[i] = EI;
    trial.curve.stored[i] = 0.5 * EI * h[i] * h[i];
    trial.curve.dissipated[i] = 0;
  }
  return trial;
}

/// Doubles the room for reversal points.
void grow(History& history, std::size_t layers) {
  const std::size_t capacity = capacity_of(history, layers);
  const std::size_t old_size = block_size(layers, capacity);
  const std::size_t new_size = block_size(layers, 2 * capacity);
  const std::size_t blocks = history.data.size() / old_size;
  AlignedVector roomier(blocks * new_size, 0.0);
  for (std::size_t b = 0; b < blocks; ++b) {
    std::copy_n(history.data.data() + b * old_size, old_size, roomier.data() + b * new_size);
  }
  history.data = std::move(roomier);
}

/// Sections of the block that starts at `first` that are no padding.
std::size_t real_lanes(std::size_t points, std::size_t first) {
  return std::min(block_lanes, points - first);
}

}  // namespace

MasingLaw::MasingLaw(conductor::Strand strand) : strand_(std::move(strand)) {
  const conductor::SectionConstants constants = conductor::section_constants(strand_);
  const std::vector<conductor::ContactGeometry> contact = conductor::contact_geometry(strand_);
  EA_ = constants.EA;
  EI_min_ = constants.EI_min;
  for (std::size_t j = 1; j < strand_.layers.size(); ++j) {
    EI_layer_.push_back(constants.EI_friction[j]);
    k_of_layer_.push_back(strand_.layers[j].EA_wire() * contact[j].cos_lay * contact[j].cos_lay * contact[j].sin_lay);
  }
}

History MasingLaw::start(const Field& strains) const {
  constexpr double without_bound = 1e300;
  const std::size_t layers = EI_layer_.size();
  const std::size_t size = block_size(layers, initial_capacity);
  History history{.points = strains.points(), .data = {}};
  history.data.assign(padded(strains.points()) / block_lanes * size, 0.0);
  for (std::size_t i = 0; i < padded(strains.points()); ++i) {
    const Lane<double> lane(history.data.data() + i / block_lanes * size, i % block_lanes, layers);
    const auto force = conductor::axial_wire_forces(strand_, strains[axial][i], 0);
    const auto contact = conductor::contact_forces(strand_, force);
    lane[stick] = without_bound;
    for (std::size_t j = 0; j < layers; ++j) {
      const double c = contact[j + 1].q_lim / k_of_layer_[j];
      lane[first_layer + j] = c;
      if (c == 0) continue;
      lane[stick] = std::min(lane[stick], c);
      lane[EI_stick] += EI_layer_[j];
    }
  }
  StepEnergy ignored(strains.points());  // the way to the start is not a step
  commit(history, strains, ignored);
  return history;
}

Effort MasingLaw::respond(const History& history, const Field& strains, Field& stresses, TangentField* tangents) const {
  const std::size_t points = strains.points();
  const std::size_t size = block_size(EI_layer_.size(), capacity_of(history, EI_layer_.size()));
  Effort effort{.evaluations = points, .sweeps = 0};
  for (std::size_t first = 0; first < padded(points); first += block_lanes) {
    const double* block = history.data.data() + first / block_lanes * size;
    const double* chi = strains[bending2].data() + first;
    double* M = stresses[bending2].data() + first;
    double* dM = tangents ? (*tangents)(bending2, bending2).data() + first : nullptr;
    std::array<bool, block_lanes> elastic;
    bool all_elastic = true;
    for (std::size_t i = 0; i < block_lanes; ++i) {
      const double* row = block + i;
      const double EI = row[EI_stick * block_lanes];
      M[i] = EI_min_ * chi[i] + (row[elastic_M * block_lanes] + EI * (chi[i] - row[elastic_chi * block_lanes]));
      if (dM) dM[i] = EI_min_ + EI;
      elastic[i] = chi[i] >= row[elastic_low * block_lanes] && chi[i] <= row[elastic_high * block_lanes];
      all_elastic = all_elastic && elastic[i];
    }
    if (all_elastic) continue;
    const Trial trial = try_block(EI_layer_, block, chi, real_lanes(points, first), elastic);
    effort.sweeps += trial.swept;
    for (std::size_t i = 0; i < block_lanes; ++i) {
      if (elastic[i]) continue;
      M[i] = EI_min_ * chi[i] + (trial.branch[i].origin.M + trial.branch[i].scale * trial.curve.moment[i]);
      if (dM) dM[i] = EI_min_ + trial.curve.tangent[i];
    }
  }
  for (std::size_t i = 0; i < strains[axial].size(); ++i) stresses[axial][i] = EA_ * strains[axial][i];
  if (tangents) std::fill((*tangents)(axial, axial).begin(), (*tangents)(axial, axial).end(), EA_);
  return effort;
}

Effort MasingLaw::commit(History& history, const Field& strains, StepEnergy& energy) const {
  const std::size_t points = strains.points();
  const std::size_t layers = EI_layer_.size();
  // A step adds one reversal point at most.
  if (deepest_memory(history) == capacity_of(history, layers)) grow(history, layers);
  const std::size_t size = block_size(layers, capacity_of(history, layers));
  Effort effort{.evaluations = points, .sweeps = 0};
  for (std::size_t first = 0; first < padded(points); first += block_lanes) {
    double* block = history.data.data() + first / block_lanes * size;
    const double* chi = strains[bending2].data() + first;
    const double* eps = strains[axial].data() + first;
    const Trial trial = try_block(EI_layer_, block, chi, real_lanes(points, first), {});
    effort.sweeps += trial.swept;
    for (std::size_t i = 0; i < block_lanes; ++i) {
      const Lane<double> lane(block, i, layers);
      const Branch& branch = trial.branch[i];
      const PathPoint before = lane.committed_point();
      const double scale = branch.scale;
      const PathPoint after{.chi = chi[i],
                            .M = branch.origin.M + scale * trial.curve.moment[i],
                            .U = branch.origin.U + (chi[i] - branch.origin.chi) * branch.origin.M +
                                 scale * (scale * trial.curve.stored[i] + (scale - 1) * trial.curve.dissipated[i]),
                            .loss = scale * trial.curve.dissipated[i]};
      const double dissipated = std::max(0.0, after.loss + branch.loss_on_the_way);
      const double trapezoid = 0.5 * (before.M + after.M) * (after.chi - before.chi);
      energy.stored[first + i] = after.U + 0.5 * (EA_ * eps[i] * eps[i] + EI_min_ * chi[i] * chi[i]);
      energy.dissipated[first + i] = dissipated;
      // Without slip the path is straight and the trapezoid exact: no rounding is booked.
      energy.quadrature_error[first + i] =
          dissipated > 0 ? std::max(0.0, after.U - before.U + dissipated - trapezoid) : 0.0;

      if (branch.turned_here) lane.set_reversal(branch.depth - 1, before);
      lane[depth] = static_cast<double>(branch.depth);
      lane.set_committed(after);
      set_elastic_range(lane);
    }
  }
  return effort;
}

std::size_t MasingLaw::deepest_memory(const History& history) const {
  const std::size_t capacity = capacity_of(history, EI_layer_.size());
  const std::size_t size = block_size(EI_layer_.size(), capacity);
  // A history may come from a file, and its depths say where the law reads.
  const auto none_of_this_law = [] {
    return InputError("the memory of a section is none that the law \"masing\" can have");
  };
  if (capacity < initial_capacity || history.data.size() != padded(history.points) / block_lanes * size) {
    throw none_of_this_law();
  }
  double deepest = 0;
  for (std::size_t block = 0; block < history.data.size(); block += size) {
    const double* row = history.data.data() + block + depth * block_lanes;
    const auto [least, most] = std::minmax_element(row, row + block_lanes);
    if (!(*least >= 0 && *most <= static_cast<double>(capacity))) throw none_of_this_law();
    deepest = std::max(deepest, *most);
  }
  return static_cast<std::size_t>(deepest);
}

}  // namespace strandyn::section
