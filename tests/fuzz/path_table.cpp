// The table of a path through which a section is led, and the way along it.
#include "answer.hpp"
#include "results/scratch_folder.hpp"
#include "strandyn/casefile/read.hpp"
#include "strandyn/study/run_case.hpp"
#include "target.hpp"

namespace strandyn::fuzz {
namespace {

constexpr std::size_t most_bytes = 4096;  // a longer path takes longer, and is read by the same lines

const test::ScratchFolder& scratch() {
  static const test::ScratchFolder folder;
  return folder;
}

casefile::Scene scene_of(const char* law) {
  return casefile::read_scene_text(
      std::string("[conductor]\ncatalogue = \"curlew\"\n[section]\npoints = 12\nlaw = \"") + law +
          "\"\n[analysis]\ntype = \"section\"\ntension_rts = 0.15\npath = \"path.csv\"\n",
      (scratch() / "case.toml").string());
}

}  // namespace

/// The first letter chooses the law.
void take(std::string_view bytes) {
  static const casefile::Scene scenes[] = {scene_of("return-map"), scene_of("masing"), scene_of("compliant")};
  if (bytes.empty() || bytes.size() > most_bytes) return;
  put((scratch() / "path.csv").string(), bytes.substr(1));
  answered([&] { study::run_case(scenes[static_cast<unsigned char>(bytes.front()) % std::size(scenes)]); });
}

std::vector<std::string> seeds() {
  return {"0curvature_2_per_m\n0\n0.01\n0.02\n-0.02\n0.02\n", "1curvature_2_per_m\n0\n0.01\n0.02\n-0.02\n0.02\n",
          "2axial_strain,curvature_2_per_m\n1e-4,0\n2e-4,0.01\n",
          "0tension_N,torsion_per_m,curvature_2_per_m,curvature_3_per_m\r\n2e4,0,0,0\r\n3e4,0.01,0.005,-0.004\r\n",
          "0\xEF\xBB\xBF"
          "axial_strain , torsion_per_m\n\n0,0\n1e-3 ,\t2e-2\n"};
}

}  // namespace strandyn::fuzz
