// Arguments of --set, one a line, on a case with tables and lists of all kinds.
#include <array>

#include "answer.hpp"
#include "strandyn/casefile/read.hpp"
#include "strandyn/study/analysis.hpp"
#include "target.hpp"

namespace strandyn::fuzz {
namespace {

constexpr std::size_t most_arguments = 4;

constexpr std::string_view base = R"([conductor]
catalogue = "curlew"
[section]
law = "return-map"
points = 12
[span]
length_m = 30
tension_rts = 0.15
elements = 12
[[load]]
type = "harmonic-force"
at_m = 0.7
amplitude_N = 60
direction = [0, 1, 0]
frequency = "mode 3"
[[load]]
type = "table"
at_m = 2
direction = [0, 1, 0]
history = [[0, 0], [1, 2]]
[[body]]
at_m = 3
mass_kg = 1
[damping]
modal = [[1, 0.001], [2, 0.002]]
[analysis]
type = "forced"
cycles = 20
)";

}  // namespace

void take(std::string_view bytes) {
  std::vector<std::string> arguments;
  while (!bytes.empty() && arguments.size() < most_arguments) {
    const std::size_t end = bytes.find('\0');
    arguments.emplace_back(bytes.substr(0, end));
    bytes.remove_prefix(end == std::string_view::npos ? bytes.size() : end + 1);
  }
  answered([&] { study::prepare(casefile::read_scene_text(base, "case.toml", arguments)); });
}

std::vector<std::string> seeds() {
  using namespace std::string_literals;
  return {"span.length_m=40",
          "span.tension_kN=20\0span.tension_rts=0.2"s,
          "load[0].amplitude_N=5\0load[1].at_m=3"s,
          "load[1].history[0][1]=-3e2",
          "load[1].history=[[0, 0], [0.5, 1], [2, 0]]",
          "damping.modal[1]=[3, 1e-3]",
          "section.law=masing\0section.points=24"s,
          "analysis.type=decay\0analysis.mode=3\0analysis.antinode_amplitude_mm=2"s,
          "analysis={type=\"modes\", count=3}",
          "accept.\"steady.numerical_share\"={below=1, reason=\"r\"}",
          "span.nodes_m=[[0,0,0],[10,0,0],[20,1,0]]",
          "title='a title'\0integrator.step=\"auto\""s};
}

}  // namespace strandyn::fuzz
