// A checkpoint, and the first step of the run that goes on from it.
#include "answer.hpp"
#include "results/scratch_folder.hpp"
#include "strandyn/casefile/read.hpp"
#include "strandyn/solver/time/integrator.hpp"
#include "strandyn/study/run_case.hpp"
#include "target.hpp"

namespace strandyn::fuzz {
namespace {

struct Run {
  const char* law;       ///< of the section, with its keys
  const char* method;    ///< of the integrator
  const char* analysis;  ///< with what acts
};

constexpr const char* wires = "[conductor]\ncatalogue = \"curlew\"\n[section]\npoints = 12\nlaw = ";
constexpr const char* decay = "[analysis]\ntype = \"decay\"\nmode = 1\nantinode_amplitude_mm = 5\ncycles = 3\n";
constexpr const char* forced =
    "[[load]]\ntype = \"harmonic-force\"\nat_m = 1\namplitude_N = 50\ndirection = [0, 1, 0]\nfrequency = \"mode 1\"\n"
    "[analysis]\ntype = \"forced\"\ncycles = 3\n";

std::vector<casefile::Scene> make_scenes() {
  const std::string strand = wires;
  std::vector<casefile::Scene> scenes;
  const auto add = [&](const std::string& law, const char* method, const char* analysis) {
    const std::string span = "[span]\nlength_m = 4\ntension_kN = 20\nelements = 4\n";
    const std::string integrator =
        std::string("[integrator]\nsteps_per_cycle = 40\ncheckpoint_every_s = 1000\nmethod = \"") + method + "\"\n";
    scenes.push_back(casefile::read_scene_text(law + span + integrator + analysis, "case.toml"));
  };
  add("[section]\nlaw = \"elastic\"\nEA_N = 4e7\nEI_N_m2 = 1500\nmass_kg_per_m = 1.5\n", "generalized-alpha", decay);
  add(strand + "\"return-map\"\n", "generalized-alpha", forced);
  add(strand + "\"masing\"\n", "generalized-alpha", decay);
  add(strand + "\"compliant\"\n", "generalized-alpha", forced);
  if (!solver::ida_has_checkpoints()) return scenes;
  add(strand + "\"return-map\"\n", "ida", decay);
  add(strand + "\"masing\"\n", "ida", forced);
  return scenes;
}

const std::vector<casefile::Scene>& scenes() {
  static const std::vector<casefile::Scene> made = make_scenes();
  return made;
}

const test::ScratchFolder& scratch() {
  static const test::ScratchFolder folder;
  return folder;
}

/// Runs for so many steps.
void run(const casefile::Scene& scene, bool resume, int steps) {
  int taken = 0;
  study::run_case(scene, {.stop = [&] { return taken >= steps; },
                          .progress = [&](double, std::string_view) { ++taken; },
                          .folder = scratch().path(),
                          .resume = resume});
}

}  // namespace

/// The first letter chooses the run.
void take(std::string_view bytes) {
  if (bytes.empty()) return;
  const auto& scene = scenes()[static_cast<unsigned char>(bytes.front()) % scenes().size()];
  put((scratch() / study::checkpoint_name).string(), bytes.substr(1));
  answered([&] { run(scene, true, 1); });
}

std::vector<std::string> seeds() {
  std::vector<std::string> files;
  for (std::size_t i = 0; i < scenes().size(); ++i) {
    for (const int steps : {10, 70}) {
      run(scenes()[i], false, steps);
      files.push_back(static_cast<char>(i) + bytes_of((scratch() / study::checkpoint_name).string()));
    }
  }
  return files;
}

}  // namespace strandyn::fuzz
