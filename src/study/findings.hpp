#pragma once
/// \file What an analysis has found, in sentences: the numbers that a reader came for, and what must be known before
/// one of them is used.

#include "clamp_stress.hpp"
#include "loop_row.hpp"
#include "steady_row.hpp"
#include "strandyn/self_damping/balance.hpp"
#include "strandyn/self_damping/fit.hpp"
#include "strandyn/self_damping/grid_fit.hpp"
#include "strandyn/span/modes.hpp"

namespace strandyn::study {

/// "446 mW/m": three digits and a prefix of the unit.
std::string amount(double value, std::string_view unit);

/// Of a decay or a forced vibration.
std::vector<std::string> findings_of(const SteadyRow& row, const observe::Profile& profile, double length);
/// Of the widest loop of a section, and of what bounds slip.
std::vector<std::string> findings_of(const std::vector<LoopRow>& loops);
/// Of the frequencies of a span.
std::vector<std::string> findings_of(const std::vector<span::ModeRow>& modes);
/// Of the points of a self-damping study.
std::vector<std::string> findings_of(const self_damping::Fits& fits, const self_damping::GridFits& grids);

/// Of the first point that a test bench has read in four ways.
std::vector<std::string> findings_of_bench(const std::vector<self_damping::PointRow>& points);
/// Of the vibration in the wind: the largest, and where nothing holds it.
std::vector<std::string> findings_of(const std::vector<self_damping::BalanceRow>& balances);

}  // namespace strandyn::study
