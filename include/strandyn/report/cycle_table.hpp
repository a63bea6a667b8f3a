#pragma once
/// \file The energy of each cycle, from `cycles` of summary.json.

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "strandyn/report/format.hpp"

namespace strandyn::report {

/// One cycle as both the terminal and the page show it. What the summary does not have stays empty.
struct CycleRow {
  std::size_t cycle = 0;                     ///< from 1
  std::optional<double> t;                   ///< [s]
  std::optional<double> antinode_amplitude;  ///< [m]
  std::optional<double> external;            ///< [J] work of the loads
  std::optional<double> stored;              ///< [J] change of kinetic and elastic energy
  std::optional<double> friction;            ///< [J]
  std::optional<double> viscous;             ///< [J]
  std::optional<double> numerical;           ///< [J] what the others leave over: the integrator's error
  std::optional<double> numerical_share;     ///< [-] |numerical| / (friction + viscous); empty where that sum is zero
  std::optional<double> elements_slipping;   ///< [-]
};

/// All cycles. The stored change is what closes the ledger: external - friction - viscous - numerical.
std::vector<CycleRow> cycle_rows(const nlohmann::ordered_json& cycles);

/// The prefix that all energies of these cycles share, set by the largest: parts of one ledger are read side by side.
Prefix energy_prefix(const std::vector<CycleRow>& rows);

/// At most `most` indices of 0 ... count-1: the first, the last, and evenly spaced ones between.
std::vector<std::size_t> evenly_spaced(std::size_t count, std::size_t most);

/// A table of at most `most_rows` cycles, the numerical part always beside the friction part. Empty text where there
/// are no cycles.
std::string cycle_table(const nlohmann::ordered_json& cycles, std::size_t most_rows = 20);

}  // namespace strandyn::report
