#include <doctest/doctest.h>

#include <stdexcept>

#include "casefile/texts.hpp"
#include "strandyn/build/span.hpp"

using namespace strandyn;
using section::Component;
using section::Dimension;
using section::Field;

TEST_CASE("laws of a case: each word makes a law of that name, and has wires to look at where it says so") {
  casefile::Scene scene = test::read(test::lab_span);
  scene.section.EA = 1e7;
  for (const auto& word : choices<casefile::Law>) {
    scene.section.law = word.value;
    const auto law = build::build_law(scene, Dimension::planar);
    CHECK(law->name() == word.name);
    Field strains(Dimension::planar, 1);
    strains[Component::axial][0] = 1e-3;
    const section::History history = law->start(strains);
    if (build::has_wires(word.value)) {
      CHECK(law->wires(history, strains, 0).layers.size() + 1 == scene.conductor->strand.layers.size());
    } else {
      CHECK_THROWS_AS(law->wires(history, strains, 0), std::logic_error);
    }
  }
}
