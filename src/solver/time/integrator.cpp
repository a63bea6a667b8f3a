#include "strandyn/solver/time/integrator.hpp"

#include <algorithm>

namespace strandyn::solver {

std::vector<double> corner_times(const model::Model& model, double end_time) {
  constexpr std::size_t most_rows = 50;
  std::vector<double> times;
  const auto add = [&](const model::TimeFunction& history) {
    const auto* table = std::get_if<model::Tabulated>(&history);
    if (!table || table->time.size() > most_rows) return;
    for (double t : table->time) {
      if (t > 0 && t < end_time) times.push_back(t);
    }
  };
  for (const model::Load& load : model.loads) add(load.history);
  for (const model::PrescribedMotion& motion : model.motions) add(motion.history);
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  times.push_back(end_time);
  return times;
}

}  // namespace strandyn::solver
