// checkpoint.bin with other numbers and a checksum that fits them.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cstring>
#include <random>

#include "results/scratch_folder.hpp"
#include "scenes.hpp"
#include "strandyn/core/archive.hpp"
#include "strandyn/core/error.hpp"
#include "strandyn/results/folder.hpp"
#include "strandyn/study/run_case.hpp"
#include "strandyn/version.hpp"

using namespace strandyn;

namespace {

/// As src/study/checkpoint.cpp seals it.
struct Sealed {
  std::string writer = fmt::format("strandyn {} ({})", program_version, program_revision);
  Seal seal{.kind = "checkpoint", .version = 4, .writer = writer};
};

casefile::Scene decay_scene(const std::string& law) {
  return test::span_scene(
      "[integrator]\nmethod = \"generalized-alpha\"\nsteps_per_cycle = 40\ncheckpoint_every_s = 1000\n"
      "[analysis]\ntype = \"decay\"\nmode = 2\nantinode_amplitude_mm = 8\ncycles = 4\n",
      {"section.law=" + law, "section.points=12", "span.elements=8"});
}

/// So many steps, from the beginning or from the checkpoint.
void run(const casefile::Scene& scene, const std::filesystem::path& folder, int steps, bool resume) {
  int taken = 0;
  study::run_case(scene, {.stop = [&] { return taken >= steps; },
                          .progress = [&](double, std::string_view) { ++taken; },
                          .folder = folder,
                          .resume = resume});
}

/// The content of the checkpoint after some steps.
std::string content_of_checkpoint(const casefile::Scene& scene, const std::filesystem::path& folder) {
  run(scene, folder, 100, false);
  return unseal(Sealed().seal, results::read_file(folder / study::checkpoint_name));
}

/// What is said of the content with eight bytes of it changed, sealed again.
std::string said_of(const casefile::Scene& scene, const std::filesystem::path& folder, std::string content,
                    std::size_t at, double to) {
  std::memcpy(content.data() + at, &to, sizeof to);
  results::write_file(folder / study::checkpoint_name, seal(Sealed().seal, content));
  return test::message_of<InputError>([&] { run(scene, folder, 1, true); });
}

}  // namespace

TEST_CASE("checkpoint: numbers that do not belong together are refused although the checksum fits") {
  const casefile::Scene scene = decay_scene("return-map");
  const test::ScratchFolder folder;
  const std::string content = content_of_checkpoint(scene, folder.path());
  const std::size_t end = content.size();
  // The last three numbers are the time, the kinetic and the stored energy.
  for (const std::size_t at : {end - 24, end - 16, end - 8}) {
    double x = 0;
    std::memcpy(&x, content.data() + at, sizeof x);
    CHECK(x > 0);
    for (const double y : {1.01 * x, -x, 1e300}) {
      const std::string said = said_of(scene, folder.path(), content, at, y);
      CAPTURE(y);
      CHECK(said.find((folder / study::checkpoint_name).string()) != std::string::npos);
      CHECK(said.find("it is no state that this case can be in") != std::string::npos);
      CHECK(said.find("take it away, or run without --resume") != std::string::npos);
    }
    CHECK(said_of(scene, folder.path(), content, at, x).empty());
  }
}

TEST_CASE("checkpoint: whatever number stands anywhere in it, a run answers") {
  std::mt19937_64 random(5);
  for (const std::string law : {"masing", "return-map", "compliant", "stick"}) {
    std::size_t refused = 0;
    const casefile::Scene scene = decay_scene(law);
    const test::ScratchFolder folder;
    const std::string content = content_of_checkpoint(scene, folder.path());
    for (int i = 0; i < 100; ++i) {
      const std::size_t at = random() % (content.size() - sizeof(double));
      const double values[] = {0, -1, 1e300, -1e-3, 5e-324, 1e9};
      try {
        refused += said_of(scene, folder.path(), content, at, values[random() % std::size(values)]).empty() ? 0 : 1;
      } catch (const ComputationError&) {
        ++refused;
      } catch (const FileError&) {
        ++refused;
      }
    }
    MESSAGE(law << ": " << refused << " of 100 refused");
    // Most bytes are those of the last factors, from which the next step is solved again until it holds.
    CHECK(refused > 0);
  }
}

TEST_CASE("checkpoint: a law that remembers more reversals than at the start goes on") {
  // A decay leaves two reversals a cycle behind; the memory has room for eight at first.
  const casefile::Scene scene = test::span_scene(
      "[integrator]\nmethod = \"generalized-alpha\"\nsteps_per_cycle = 40\ncheckpoint_every_s = 1000\n"
      "[analysis]\ntype = \"decay\"\nmode = 2\nantinode_amplitude_mm = 20\ncycles = 12\n",
      {"section.law=masing", "span.elements=8"});
  const test::ScratchFolder whole, stopped;
  run(scene, whole.path(), 1000, false);
  run(scene, stopped.path(), 400, false);
  run(scene, stopped.path(), 1000, true);
  CHECK(results::read_file(stopped / "cycles.csv") == results::read_file(whole / "cycles.csv"));
}
