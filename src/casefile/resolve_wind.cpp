#include <fmt/format.h>

#include <algorithm>

#include "resolve.hpp"

namespace strandyn::casefile {

namespace {

void check_rows(const std::vector<std::array<double, 2>>& rows, const char* key, const char* what, const Scene& scene) {
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i][0] > rows[i - 1][0]) continue;
    refuse(scene.source, fmt::format("wind[0].{}[{}]", key, i),
           fmt::format("its {} does not come after the one before", what), fmt::format("give rows of rising {}", what));
  }
}

}  // namespace

void check_wind(const Scene& scene) {
  if (scene.winds.empty()) return;
  if (scene.winds.size() > 1) {
    refuse(scene.source, "wind[1]", "is a second wind, and a span stands in one", "give one [[wind]] table");
  }
  if (!scene.is<ForcedAnalysis>() && !scene.is<TransientAnalysis>()) {
    refuse(scene.source, "wind",
           fmt::format("blows in runs in time, not in analysis.type = \"{}\"", word_of(scene.analysis)),
           "remove the table, or choose \"forced\" or \"transient\"; a self-damping study has "
           "[[analysis.energy_balance]]");
  }
  const WindKeys& wind = scene.winds.front();
  if (scene.air) {
    refuse(scene.source, "air", "excludes [[wind]]: what the wind gives was measured with the air around the cylinder",
           "remove one of the two tables");
  }
  if (!wind.diameter && !scene.conductor) {
    refuse(scene.source, "wind[0].diameter_mm", "is missing, and there is no conductor to take it from",
           "give the diameter in millimetres");
  }
  if (scene.accuracy) {
    refuse(scene.source, "accuracy", "chooses no settings for a span in the wind",
           "remove it, and give [span] elements and [integrator] steps_per_cycle");
  }
  check_rows(wind.history, "history", "time", scene);
  check_rows(wind.shear, "shear", "place", scene);
  if (wind.model == WindModel::wake_oscillator && wind.history.empty() && !wind.speed) {
    refuse(scene.source, "wind[0].speed_m_per_s", "is missing", "give the speed of the wind in metres per second");
  }
}

}  // namespace strandyn::casefile
