#include <fmt/format.h>

#include "entries.hpp"
#include "findings.hpp"
#include "strandyn/build/section_law.hpp"
#include "strandyn/conductor/constants.hpp"
#include "strandyn/exact/costello.hpp"

namespace strandyn::study {

using casefile::Scene;

namespace {

struct TheoryRow {
  double k1 = 0;
  std::optional<double> k2{};
};
template <class V>
void members(V& v, TheoryRow& t) {
  v.value("k1_N", t.k1, {.what = "tension over axial strain", .shown = "tension over strain"});
  v.value("k2_per_m", t.k2, {.what = "tension over moment"});
}
struct EndRow {
  TheoryRow seed;
  std::optional<TheoryRow> costello{};
};
template <class V>
void members(V& v, EndRow& e) {
  v.record("seed", e.seed, {.what = "by Foti and Martinelli"});
  v.record("costello", e.costello, {.what = "by Costello, for a core and one layer"});
}
struct AxialTorsionSummary {
  EndRow fixed_end, free_end;
};
template <class V>
void members(V& v, AxialTorsionSummary& s) {
  v.record("fixed_end", s.fixed_end, {.what = "twist held"});
  v.record("free_end", s.free_end, {.what = "free to twist"});
}

class AxialTorsion final : public Analysis {
 public:
  explicit AxialTorsion(const Scene& scene) : scene_(scene) {
    if (!scene.conductor) {
      refuse(scene.source, "analysis.type", "tension and torsion need the wires of a strand", "give a [conductor]");
    }
    build::build_law(scene, scene.section.axial_resultants ? section::Dimension::spatial : section::Dimension::planar);
  }

  Outlook outlook() override { return {}; }  // closed forms

  void run(const Hooks&, Outcome& outcome) override {
    const conductor::Strand& strand = scene_.conductor->strand;
    const conductor::SectionConstants c = conductor::section_constants(strand);
    const double strain = scene_.as<casefile::AxialTorsionAnalysis>().axial_strain;
    AxialTorsionSummary summary{.fixed_end = {.seed = {.k1 = c.EA}}, .free_end = {.seed = {.k1 = c.EA_free_end()}}};
    if (c.C_AT != 0) summary.fixed_end.seed.k2 = c.EA / c.C_AT;
    if (strand.layers.size() == 2) {
      // Costello's equations in the form used here are those of a core and one layer.
      const auto held = exact::costello(strand, {.strain = strain, .twist = 0}, exact::Contraction::poisson);
      const auto loose = exact::costello_free_end(strand, strain, exact::Contraction::poisson);
      summary.fixed_end.costello = TheoryRow{.k1 = held.k1(), .k2 = held.k2()};
      summary.free_end.costello = TheoryRow{.k1 = loose.k1()};
    }
    outcome.tell(summary);
    outcome.findings.push_back(
        fmt::format("Pulled with its ends held against twist the strand has {} of axial stiffness, "
                    "free to twist {}.",
                    amount(c.EA, "N"), amount(c.EA_free_end(), "N")));
    if (const auto& other = summary.fixed_end.costello) {
      outcome.findings.push_back(fmt::format("Costello's theory says {} and {}.", amount(other->k1, "N"),
                                             amount(summary.free_end.costello->k1, "N")));
    }
    add_table(summary, strain, outcome);
  }

 private:
  /// Tension over strain up to the one of the case, by both theories.
  static void add_table(const AxialTorsionSummary& s, double strain, Outcome& outcome) {
    std::vector<std::string> names = {"axial_strain", "fixed_end_N", "free_end_N"};
    std::vector<double> slopes = {1, s.fixed_end.seed.k1, s.free_end.seed.k1};
    if (s.fixed_end.costello) {
      names.insert(names.end(), {"fixed_end_costello_N", "free_end_costello_N"});
      slopes.insert(slopes.end(), {s.fixed_end.costello->k1, s.free_end.costello->k1});
    }
    results::Table table(names);
    constexpr int steps = 10;
    for (int i = 0; i <= steps; ++i) {
      std::vector<double> row;
      for (const double slope : slopes) row.push_back(slope * strain * i / steps);
      table.append(row);
    }
    outcome.tables.push_back({.file = "axial_torsion.csv", .table = std::move(table)});
    outcome.figures.push_back({.name = "axial_torsion",
                               .title = "Tension over strain",
                               .table = "axial_torsion.csv",
                               .x = "axial_strain",
                               .y = {names.begin() + 1, names.end()},
                               .caption = "With the end held against twist, and free to twist."});
  }

  const Scene& scene_;
};

}  // namespace

std::vector<results::MemberNote> notes_of_axial_torsion() {
  return results::ReferenceWriter::of<AxialTorsionSummary>();
}

std::unique_ptr<Analysis> prepare_axial_torsion(const Scene& scene) {
  return std::make_unique<AxialTorsion>(scene);
}

}  // namespace strandyn::study
