#pragma once
/// \file The tables of a self-damping study, and what is worth drawing of them.

#include "strandyn/analysis/power_law.hpp"
#include "strandyn/self_damping/balance.hpp"
#include "strandyn/self_damping/quadrature.hpp"
#include "strandyn/study/analysis.hpp"

namespace strandyn::study {

/// points_<method>.csv, one line per point that has numbers, and its figures; of the study's own method with the fitted
/// law and the range of the published ones beside it.
void add_point_tables(const casefile::Scene& scene, const std::vector<self_damping::PointRow>& rows,
                      const std::optional<analysis::PowerLaw>& fitted, Outcome& outcome);
/// local_exponents.csv: of all that is lost, at each point of a grid.
void add_local_exponents(const casefile::Scene& scene, const std::vector<self_damping::PointRow>& rows,
                         Outcome& outcome);
/// bench_readings.csv: the four readings of each bench, side by side.
void add_readings(const std::vector<self_damping::PointRow>& rows, Outcome& outcome);
/// sectional_loss.csv
void add_loss_table(const self_damping::Quadrature& quadrature, Outcome& outcome);
/// energy_balance.csv
void add_balances(const std::vector<self_damping::BalanceRow>& rows, Outcome& outcome);

}  // namespace strandyn::study
