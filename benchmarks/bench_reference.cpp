// The beam by which programs are compared: work dissipated, and the score of the elastic case.
//   bench_reference [work] [plain] [score]      all of them unless named
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>

#include "plain_beam.hpp"
#include "reference_beam.hpp"
#include "strandyn/observe/histories.hpp"
#include "strandyn/observe/ledger.hpp"

using namespace strandyn;

namespace {

constexpr double duration = 5.0 / 3;  // [s]

// ---- work of the hysteretic case

struct Mesh {
  const char* dimension = "planar";
  int elements = 100;
  const char* grading = "uniform";
  int steps_per_second = 1200;
};

void print_work_row(const Mesh& mesh) {
  bench::Span span(fmt::format("benchmark/hysteretic_{}.toml", mesh.dimension),
                   {fmt::format("span.elements={}", mesh.elements), fmt::format("span.grading={}", mesh.grading)});
  bench::BendingWork bending;
  observe::Ledger ledger;
  observe::Observer* const observers[] = {&ledger, &bending};
  const auto steps = static_cast<std::size_t>(std::lround(duration * mesh.steps_per_second));
  bench::integrate(span, bench::sine_velocity(span, 12, 0.8), 1.0 / mesh.steps_per_second, steps, observers);
  const observe::Account& a = ledger.now();
  fmt::print("| {} | {}{} | 1/{} | {:.4f} | {:.4f} | {:.4f} | {:.4f} | {:+.1e} |\n", mesh.dimension, mesh.elements,
             mesh.grading == std::string("clamps") ? ", graded" : "", mesh.steps_per_second, bending.work(), a.friction,
             a.elastic, a.kinetic, a.numerical());
}

void print_work() {
  fmt::print(
      "\n| dimension | elements | step s | M dkappa | friction | stored | kinetic | numerical |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (int rate : {1200, 2400, 4800}) print_work_row({.steps_per_second = rate});
  print_work_row({.elements = 200, .steps_per_second = 4800});
  print_work_row({.elements = 200, .grading = "clamps", .steps_per_second = 4800});
  print_work_row({.elements = 400, .steps_per_second = 9600});
  print_work_row({.dimension = "spatial"});
}

void print_plain() {
  fmt::print(
      "\n| elements | sections of an element | tension acts on | M dkappa | friction |\n"
      "| --- | --- | --- | --- | --- |\n");
  for (int elements : {100, 200}) {
    for (int sections : {2, 3}) {
      for (bool inside : {true, false}) {
        const bench::PlainWork work =
            bench::plain_work({.elements = elements, .sections = sections, .tension_on_deflection = inside});
        fmt::print("| {} | {} | {} | {:.4f} | {:.4f} |\n", elements, sections, inside ? "the deflection" : "the chord",
                   work.bending, work.friction);
      }
    }
  }
}

// ---- score of the elastic case

constexpr double reference_frequency = 25.676;  // [Hz] converged

struct Variant {
  const char* name;
  const char* dimension;
  std::vector<std::string> keys;
};

struct Score {
  double frequency = 0;  // [Hz] mean over 40 periods
  double seconds = 0;    // of the processor, for the integration; the shorter of two

  double error() const { return frequency / reference_frequency - 1; }
};

Score score(const Variant& variant, int elements, int steps_per_cycle) {
  Score result{.seconds = 1e9};
  for (int round = 0; round < 2; ++round) {
    std::vector<std::string> keys = {fmt::format("span.elements={}", elements), "integrator.method=generalized-alpha",
                                     "integrator.rho_inf=1"};
    keys.insert(keys.end(), variant.keys.begin(), variant.keys.end());
    bench::Span span(fmt::format("beam/elastic_benchmark_{}.toml", variant.dimension), keys);
    observe::ProbeHistories probes({model::nearest_node(span.built.model, 13.8)});
    observe::Observer* const observers[] = {&probes};
    const system::Vector velocity = bench::sine_velocity(span, 12, 0.8);
    const std::clock_t start = std::clock();
    bench::integrate(span, velocity, 1 / (reference_frequency * steps_per_cycle),
                     static_cast<std::size_t>(41 * steps_per_cycle), observers);
    result.seconds = std::min(result.seconds, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    result.frequency = probes.frequency(0).value_or(0);
  }
  return result;
}

constexpr std::array element_counts = {24, 36, 48, 60, 100};
constexpr std::array step_counts = {32, 48, 64, 96};  // per cycle

/// Mesh and steps err in opposite directions. The score is the shortest time of those within 0.1 % that stay there with
/// more steps and with more elements: no luck counts.
void print_scores() {
  constexpr double wanted = 1e-3;
  const Variant variants[] = {{"planar", "planar", {}},
                              {"planar, axial unknowns condensed", "planar", {"span.condense_axial=true"}},
                              {"spatial, without twist", "spatial", {"span.torsion=false"}},
                              {"spatial", "spatial", {}}};
  fmt::print(
      "\n| beam | elements | steps per cycle | frequency Hz | error % | s | |\n"
      "| --- | --- | --- | --- | --- | --- | --- |\n");
  for (const Variant& variant : variants) {
    std::array<std::array<Score, step_counts.size()>, element_counts.size()> scores;
    for (std::size_t i = 0; i < element_counts.size(); ++i) {
      for (std::size_t j = 0; j < step_counts.size(); ++j) {
        scores[i][j] = score(variant, element_counts[i], step_counts[j]);
      }
    }
    const auto holds = [&](std::size_t i, std::size_t j) {
      bool all = true;
      for (std::size_t k = i; k < element_counts.size(); ++k) all = all && std::abs(scores[k][j].error()) <= wanted;
      for (std::size_t k = j; k < step_counts.size(); ++k) all = all && std::abs(scores[i][k].error()) <= wanted;
      return all;
    };
    double shortest = 1e9;
    for (std::size_t i = 0; i < element_counts.size(); ++i) {
      for (std::size_t j = 0; j < step_counts.size(); ++j) {
        if (holds(i, j)) shortest = std::min(shortest, scores[i][j].seconds);
      }
    }
    for (std::size_t i = 0; i < element_counts.size(); ++i) {
      for (std::size_t j = 0; j < step_counts.size(); ++j) {
        const Score& s = scores[i][j];
        fmt::print("| {} | {} | {} | {:.4f} | {:+.3f} | {:.4f} | {} |\n", variant.name, element_counts[i],
                   step_counts[j], s.frequency, 100 * s.error(), s.seconds,
                   holds(i, j) && s.seconds == shortest ? "score" : "");
      }
    }
  }
}

}  // namespace

int main(int count, char** arguments) {
  const std::vector<std::string> wanted(arguments + 1, arguments + count);
  const auto wants = [&](const char* name) { return wanted.empty() || std::ranges::count(wanted, name) > 0; };
  if (wants("work")) print_work();
  if (wants("plain")) print_plain();
  if (wants("score")) print_scores();
}
