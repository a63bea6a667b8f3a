#include "strandyn/build/section_law.hpp"

#include "strandyn/conductor/constants.hpp"
#include "strandyn/section/compliant.hpp"
#include "strandyn/section/linear_law.hpp"
#include "strandyn/section/masing.hpp"
#include "strandyn/section/multilinear.hpp"
#include "strandyn/section/return_map.hpp"
#include "strandyn/section/spatial_return_map.hpp"

namespace strandyn::build {
namespace {

bool has_own_constants(const casefile::Scene& scene) {
  return scene.section.law == casefile::Law::elastic || scene.section.law == casefile::Law::multilinear;
}

section::MultilinearSection multilinear_section(const casefile::Section& s) {
  section::MultilinearSection out{
      .EA = s.EA.value_or(0), .GJ = s.GJ.value_or(0), .EI = s.EI.value_or(0), .springs = {}};
  for (const casefile::Spring& spring : s.springs)
    out.springs.push_back({.stiffness = spring.stiffness, .yield = spring.yield});
  return out;
}

}  // namespace

SectionNumbers section_numbers(const casefile::Scene& scene) {
  SectionNumbers n;
  if (scene.conductor) n.diameter = scene.conductor->strand.outer_diameter();
  if (has_own_constants(scene)) {
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

std::shared_ptr<const section::Law> build_law(const casefile::Scene& scene, section::Dimension dimension,
                                              const conductor::Strand* strand) {
  const SectionNumbers n = section_numbers(scene);
  const bool planar = dimension == section::Dimension::planar;
  const auto linear = [&](const char* name, double EI) {
    return std::make_shared<section::LinearLaw>(
        name, dimension, section::LinearStiffness{.EA = n.EA, .GJ = n.GJ, .C_AT = n.C_AT, .EI = EI});
  };
  if (!strand && scene.conductor) strand = &scene.conductor->strand;
  switch (scene.section.law) {
    case casefile::Law::stick:
      return linear("stick", n.EI_max);
    case casefile::Law::slip:
      return linear("slip", n.EI_min);
    case casefile::Law::elastic:
      return linear("elastic", n.EI_max);
    case casefile::Law::multilinear:
      return std::make_shared<section::MultilinearLaw>(multilinear_section(scene.section), dimension);
    case casefile::Law::masing:
      if (planar) return std::make_shared<section::MasingLaw>(*strand);
      casefile::refuse(scene.source, "section.law", "\"masing\" bends in one plane only",
                       "use return-map for twist or for bending about two axes");
    case casefile::Law::return_map:
      if (planar && !scene.section.axial_resultants) {
        return std::make_shared<section::PlanarReturnMap>(*strand, scene.section.points);
      }
      if (planar) {
        casefile::refuse(scene.source, "section.axial_resultants", "a planar run leaves the bending part of N out",
                         "use it in a section analysis");
      }
      return std::make_shared<section::SpatialReturnMap>(
          *strand, section::SpatialReturnMapOptions{.points = scene.section.points,
                                                    .axial_resultants = scene.section.axial_resultants});
    case casefile::Law::compliant:
      break;
  }
  if (!planar) {
    casefile::refuse(scene.source, "section.law", "\"compliant\" bends in one plane only",
                     "use return-map for twist or for bending about two axes");
  }
  const section::CompliantOptions options{.points = scene.section.points,
                                          .springs = scene.section.contact_springs,
                                          .compliance_scale = scene.section.compliance_scale};
  if (const auto fault = section::find_fault(options)) {
    casefile::refuse(scene.source, "section.law", *fault, "change contact_springs or compliance_scale");
  }
  return std::make_shared<section::CompliantLaw>(*strand, options);
}

}  // namespace strandyn::build
