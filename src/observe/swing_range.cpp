#include "strandyn/observe/swing_range.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace strandyn::observe {
namespace {

constexpr double lowest = std::numeric_limits<double>::lowest();

template <std::size_t N>
std::array<std::array<double, 2>, N> half_turn() {
  std::array<std::array<double, 2>, N> unit;
  for (std::size_t i = 0; i < N; ++i) {
    const double angle = std::numbers::pi * static_cast<double>(i) / N;
    unit[i] = {std::cos(angle), std::sin(angle)};
  }
  return unit;
}

}  // namespace

void SwingRange::restart(const DeflectionPoints& places) {
  planes_ = places.planes();
  if (planes_ == 1) {
    low_.assign(places.size(), std::numeric_limits<double>::max());
    high_.assign(places.size(), lowest);
  } else {
    farthest_.assign(places.size() / planes_ * 2 * directions, {.along = lowest});
  }
}

void SwingRange::widen(const DeflectionPoints& places, const double* u) {
  if (planes_ == 1) {
    for (std::size_t i = 0; i < low_.size(); ++i) {
      const double y = places.at(u, i);
      low_[i] = std::min(low_[i], y);
      high_[i] = std::max(high_[i], y);
    }
    return;
  }
  static const auto unit = half_turn<directions>();
  Farthest* place = farthest_.data();
  for (std::size_t i = 0; i < places.size(); i += planes_, place += 2 * directions) {
    const double y = places.at(u, i), z = places.at(u, i + 1);
    for (std::size_t d = 0; d < directions; ++d) {
      const double along = unit[d][0] * y + unit[d][1] * z;
      if (along > place[2 * d].along) place[2 * d] = {.along = along, .y = y, .z = z};
      if (-along > place[2 * d + 1].along) place[2 * d + 1] = {.along = -along, .y = y, .z = z};
    }
  }
}

double SwingRange::largest() const {
  double most = 0;
  for (std::size_t i = 0; i < low_.size(); ++i) most = std::max(most, high_[i] - low_[i]);
  for (std::size_t first = 0; first < farthest_.size(); first += 2 * directions) {
    if (farthest_[first].along == lowest) continue;
    for (std::size_t a = first; a < first + 2 * directions; ++a) {
      for (std::size_t b = first; b < a; ++b) {
        most = std::max(most, std::hypot(farthest_[a].y - farthest_[b].y, farthest_[a].z - farthest_[b].z));
      }
    }
  }
  return most / 2;
}

}  // namespace strandyn::observe
