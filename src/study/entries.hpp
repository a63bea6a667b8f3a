#pragma once
/// \file The analyses: each is prepared by one function; analyses.cpp has their table.

#include "strandyn/study/analysis.hpp"

namespace strandyn::study {

using Prepare = std::unique_ptr<Analysis>(const casefile::Scene& scene);

Prepare prepare_section, prepare_axial_torsion, prepare_static, prepare_modes, prepare_decay, prepare_forced,
    prepare_transient, prepare_sweep, prepare_self_damping;

}  // namespace strandyn::study
