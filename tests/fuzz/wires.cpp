// Wires per layer in a CSV file, up to the table that a case reads.
#include <stdexcept>

#include "answer.hpp"
#include "strandyn/casefile/import_wires.hpp"
#include "strandyn/casefile/read.hpp"
#include "target.hpp"

namespace strandyn::fuzz {

void take(std::string_view bytes) {
  answered([&] {
    const std::string table = casefile::import_wires_text(std::string(bytes), "wires.csv");
    try {
      casefile::read_scene_text(table + "[analysis]\ntype = \"axial-torsion\"\n", "case.toml");
    } catch (const InputError& error) {
      // What can hardly be is a case's to refuse; a table that is none is not.
      if (std::string(error.what()).find("this is not TOML") != std::string::npos) throw std::logic_error(table);
    }
  });
}

std::vector<std::string> seeds() {
  return {
      "wires,diameter_mm,metal,lay_ratio\n1,3.454,ST6C,\n6,3.454,ST6C,20\n10,4.442,AL1,-13\n16,4.442,AL1,12\n",
      "wires; diameter_mm; shape; area_mm2; young_GPa; lay_angle_deg\n1; 4; round; ; 190; 0\n8; 4; trapezoidal; 11; "
      "69; 10\n",
      "# a comment\nwires,diameter_mm,young_GPa,poisson,density_kg_per_m3,lay_length_mm,friction\n1,4,2e2,.3,7780,,\n"
      "\n6,4,+200,0.3,7780,150,0.5\n"};
}

}  // namespace strandyn::fuzz
