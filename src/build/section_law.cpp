#include "strandyn/build/section_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "strandyn/conductor/constants.hpp"
#include "strandyn/section/compliant.hpp"
#include "strandyn/section/linear_law.hpp"
#include "strandyn/section/masing.hpp"
#include "strandyn/section/multilinear.hpp"
#include "strandyn/section/return_map.hpp"
#include "strandyn/section/spatial_compliant.hpp"
#include "strandyn/section/spatial_return_map.hpp"

namespace strandyn::build {

SectionNumbers section_numbers(const casefile::Scene& scene) {
  SectionNumbers n;
  if (scene.conductor) n.diameter = scene.conductor->strand.outer_diameter();
  if (!casefile::needs_strand(scene.section.law)) {
    n.EA = scene.section.EA.value_or(0);
    n.GJ = scene.section.GJ.value_or(0);
    n.EI_min = n.EI_max = scene.section.EI.value_or(0);
    for (const casefile::Spring& spring : scene.section.springs) n.EI_max += spring.stiffness;
    return n;
  }
  const conductor::SectionConstants c = conductor::section_constants(scene.conductor->strand);
  n.EA = c.EA;
  n.GJ = c.GJ;
  n.C_AT = c.C_AT;
  n.EI_min = c.EI_min;
  n.EI_max = c.EI_max;
  return n;
}

namespace {

using Made = std::shared_ptr<const section::Law>;

struct Request {
  const casefile::Scene& scene;
  section::Dimension dimension;
  const conductor::Strand* strand;  // null where the law needs none
};

template <double SectionNumbers::*EI>
Made linear(const Request& r) {
  const SectionNumbers n = section_numbers(r.scene);
  return std::make_shared<section::LinearLaw>(
      name_of(r.scene.section.law), r.dimension,
      section::LinearStiffness{.EA = n.EA, .GJ = n.GJ, .C_AT = n.C_AT, .EI = n.*EI});
}

Made multilinear(const Request& r) {
  const casefile::Section& s = r.scene.section;
  section::MultilinearSection own{
      .EA = s.EA.value_or(0), .GJ = s.GJ.value_or(0), .EI = s.EI.value_or(0), .springs = {}};
  for (const casefile::Spring& spring : s.springs)
    own.springs.push_back({.stiffness = spring.stiffness, .yield = spring.yield});
  return std::make_shared<section::MultilinearLaw>(std::move(own), r.dimension);
}

Made masing(const Request& r) {
  return std::make_shared<section::MasingLaw>(*r.strand);
}

Made return_map(const Request& r) {
  const casefile::Section& s = r.scene.section;
  if (r.dimension == section::Dimension::spatial) {
    return std::make_shared<section::SpatialReturnMap>(
        *r.strand, section::SpatialReturnMapOptions{.points = s.points, .axial_resultants = s.axial_resultants});
  }
  if (s.axial_resultants) {
    casefile::refuse(r.scene.source, "section.axial_resultants", "a planar run leaves the bending part of N out",
                     "use it in a section analysis");
  }
  return std::make_shared<section::PlanarReturnMap>(*r.strand, s.points);
}

Made compliant(const Request& r) {
  const casefile::Section& s = r.scene.section;
  const bool in_space = r.dimension == section::Dimension::spatial;
  if (r.strand->layers.size() > section::most_compliant_layers + 1) {
    casefile::refuse(r.scene.source, "section.law",
                     fmt::format("takes {} layers around the core at most", section::most_compliant_layers),
                     "use return-map");
  }
  section::CompliantOptions options{.points = s.points, .compliance_scale = s.compliance_scale};
  if (in_space) options.springs = section::springs_in_space;
  options.springs = s.contact_springs.value_or(options.springs);
  if (const auto fault = section::find_fault(options)) {
    casefile::refuse(r.scene.source, "section.law", *fault, "change contact_springs or compliance_scale");
  }
  if (in_space) return std::make_shared<section::SpatialCompliantLaw>(*r.strand, options);
  return std::make_shared<section::CompliantLaw>(*r.strand, options);
}

/// All that a run knows of a law before it has one. A new law is a word in casefile/section.hpp and a row here.
struct LawRow {
  casefile::Law law;
  Made (*make)(const Request&);
  bool bends_in_space = true;  ///< else in one plane only
  bool has_wires = false;      ///< answers section::Law::wires
};

constexpr LawRow laws[] = {{.law = casefile::Law::stick, .make = linear<&SectionNumbers::EI_max>},
                           {.law = casefile::Law::slip, .make = linear<&SectionNumbers::EI_min>},
                           {.law = casefile::Law::elastic, .make = linear<&SectionNumbers::EI_max>},
                           {.law = casefile::Law::multilinear, .make = multilinear},
                           {.law = casefile::Law::masing, .make = masing, .bends_in_space = false},
                           {.law = casefile::Law::return_map, .make = return_map, .has_wires = true},
                           {.law = casefile::Law::compliant, .make = compliant}};
static_assert(std::size(laws) == choices<casefile::Law>.size(), "one row for each word");

const LawRow& row_of(casefile::Law law) {
  return *std::ranges::find(laws, law, &LawRow::law);
}

}  // namespace

bool has_wires(casefile::Law law) {
  return row_of(law).has_wires;
}

bool slips_by_points(casefile::Law law) {
  return law == casefile::Law::return_map || law == casefile::Law::compliant;
}

std::optional<int> finer_points(int points) {
  constexpr std::array steps = {12, 20, 36, 72};
  const auto finer = std::ranges::upper_bound(steps, points);
  return finer == steps.end() ? std::nullopt : std::optional(*finer);
}

std::shared_ptr<const section::Law> build_law(const casefile::Scene& scene, section::Dimension dimension,
                                              const conductor::Strand* strand) {
  const LawRow& row = row_of(scene.section.law);
  if (!row.bends_in_space && dimension == section::Dimension::spatial) {
    casefile::refuse(scene.source, "section.law", fmt::format("\"{}\" bends in one plane only", name_of(row.law)),
                     "use return-map or compliant for twist or for bending about two axes");
  }
  if (!strand && scene.conductor) strand = &scene.conductor->strand;
  return row.make({.scene = scene, .dimension = dimension, .strand = strand});
}

}  // namespace strandyn::build
