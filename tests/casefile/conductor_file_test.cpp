#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

#include "strandyn/casefile/import_wires.hpp"
#include "strandyn/conductor/catalogue.hpp"
#include "strandyn/core/error.hpp"
#include "support/check_close.hpp"
#include "texts.hpp"

using namespace strandyn;
using strandyn::test::check_close;
using strandyn::test::contains;

namespace {

/// A folder with a case and what stands beside it.
class Folder {
 public:
  Folder() : path_(std::filesystem::temp_directory_path() / "strandyn_conductor_file") {
    std::filesystem::create_directories(path_ / "sub");
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name) << text;
    return (path_ / name).string();
  }
  casefile::Scene read(const std::string& conductor, const std::vector<std::string>& overrides = {}) const {
    return casefile::read_scene(write("case.toml", conductor + "[analysis]\ntype = \"axial-torsion\"\n"), overrides);
  }
  std::string refusal(const std::string& conductor) const {
    try {
      read(conductor);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  }

 private:
  std::filesystem::path path_;
};

std::string import_refusal(const std::string& csv) {
  try {
    casefile::import_wires_text(csv, "wires.csv");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

const std::string strand = R"(title = "mine"
mass_kg_per_m = 1.5
[[layer]]
wires = 1
diameter_mm = 4
young_GPa = 200
[[layer]]
wires = 6
diameter_mm = 4
young_GPa = 200
lay_ratio = 16
)";

const std::string wires = R"(wires,diameter_mm,metal,lay_ratio
# the steel core
1,3.454,ST6C,
6,3.454,ST6C,20

10,4.442,AL1,-13
16,4.442,AL1,12
)";

}  // namespace

TEST_CASE("every conductor that is printed can be pasted into a case, and is the same one there") {
  for (const conductor::CatalogueEntry& entry : conductor::catalogue()) {
    CAPTURE(entry.name);
    const std::string analysis = "[analysis]\ntype = \"axial-torsion\"\n";
    const auto pasted = *test::read(conductor::case_table(entry) + analysis).conductor;
    const auto named =
        *test::read("[conductor]\ncatalogue = \"" + std::string(entry.name) + "\"\n" + analysis).conductor;
    CHECK(pasted.title == named.title);
    CHECK(pasted.strand.mass_per_length == named.strand.mass_per_length);
    CHECK(pasted.strand.rated_strength == named.strand.rated_strength);
    REQUIRE(pasted.strand.layers.size() == named.strand.layers.size());
    for (std::size_t j = 0; j < pasted.strand.layers.size(); ++j) {
      CHECK(pasted.strand.layers[j].lay_angle == named.strand.layers[j].lay_angle);
      CHECK(pasted.strand.layers[j].diameter == named.strand.layers[j].diameter);
    }
  }
}

TEST_CASE("a lay ratio is the lay length over the outer diameter of its layer") {
  const Folder folder;
  folder.write("mine.toml", strand);
  const auto by_ratio = folder.read("[conductor]\nfile = \"mine.toml\"\n").conductor->strand;
  std::string by_length = strand;  // outer diameter 12 mm
  by_length.replace(by_length.find("lay_ratio = 16"), 14, "lay_length_mm = 192");
  folder.write("mine.toml", by_length);
  const auto length = folder.read("[conductor]\nfile = \"mine.toml\"\n").conductor->strand;
  check_close(by_ratio.layers[1].lay_angle, length.layers[1].lay_angle, {.relative = 1e-14}, "lay angle");
  check_close(std::tan(by_ratio.layers[1].lay_angle), 2 * 3.14159265358979 * 4 / 192, {.relative = 1e-12}, "tangent");
  CHECK(
      contains(test::refusal(test::three_layers, {"conductor.layer[1].lay_ratio=0"}), "lay_ratio = 0: must not be 0"));
  std::string both = test::three_layers;
  both.insert(both.find("lay_angle_deg = 10"), "lay_ratio = 12\n");
  CHECK(contains(test::refusal(both), "case.toml:11:1: conductor.layer[1].lay_ratio = 12: excludes"));
  CHECK(contains(test::refusal(test::three_layers, {"conductor.layer[0].lay_ratio=12"}), "is a lay of the core"));
}

TEST_CASE("a conductor is read from a file beside the case, with [conductor] above it or not") {
  const Folder folder;
  folder.write("mine.toml", strand);
  const casefile::Scene scene = folder.read("[conductor]\nfile = \"mine.toml\"\nfriction = 0.7\nmass_kg_per_m = 1.6\n");
  CHECK(scene.conductor->strand.name == "mine");
  CHECK(scene.conductor->strand.mass_per_length == 1.6);  // the case's own keys lie on top
  CHECK(scene.conductor->strand.layers[1].friction_inner == 0.7);

  folder.write("sub/table.toml", conductor::case_table(*conductor::find_entry("drake")));
  const auto drake = folder.read("[conductor]\nfile = \"sub/table.toml\"\n").conductor->strand;
  CHECK(drake.layers.size() == 4);
  CHECK(drake.rated_strength == 140.1e3);
}

TEST_CASE("an override puts a file in the place of the case's conductor") {
  const Folder folder;
  folder.write("mine.toml", strand);
  const auto scene =
      folder.read("[conductor]\ncatalogue = \"curlew\"\nmass_kg_per_m = 3\n", {"conductor.file=mine.toml"});
  CHECK(scene.conductor->strand.layers.size() == 2);
  CHECK(scene.conductor->strand.mass_per_length == 1.5);
}

TEST_CASE("what is wrong with a conductor file is said with its own place, key and remedy") {
  const Folder folder;
  const std::string use = "[conductor]\nfile = \"mine.toml\"\n";
  std::string text = strand;
  text.replace(text.find("lay_ratio"), 9, "lay_rato ");
  folder.write("mine.toml", text);
  CHECK(contains(folder.refusal(use), "mine.toml:11:1: unknown key `layer[1].lay_rato`; did you mean"));

  text = strand;
  text.replace(text.find("wires = 6"), 9, "wires = 9");  // nine do not fit: found when the layers are put together
  folder.write("mine.toml", text);
  CHECK(contains(folder.refusal(use), "mine.toml:7:1: conductor.layer[1]: "));
  CHECK(contains(folder.refusal(use), "9 wires of 4 mm do not fit"));

  folder.write("mine.toml", "file = \"mine.toml\"\n");
  CHECK(contains(folder.refusal(use), "mine.toml:1:1: file = \"mine.toml\": is a file that names another file"));
  folder.write("mine.toml", "[conductor]\ncatalogue = \"drake\"\n[span]\nlength_m = 3\n");
  CHECK(contains(folder.refusal(use), "holds more than the table [conductor]"));
  folder.write("mine.toml", "wires = [");
  CHECK(contains(folder.refusal(use), "mine.toml:1:"));
  CHECK(contains(folder.refusal(use + "catalogue = \"drake\"\n"), "excludes `conductor.catalogue`"));
  CHECK_THROWS_AS(folder.read("[conductor]\nfile = \"none.toml\"\n"), FileError);
}

TEST_CASE("wires of a CSV file become the table of a case") {
  const std::string table = casefile::import_wires_text(wires, "tables/drake.csv");
  const auto mine = *test::read(table + "[analysis]\ntype = \"axial-torsion\"\n").conductor;
  CHECK(mine.title == "drake");
  REQUIRE(mine.strand.layers.size() == 4);
  const auto theirs =
      test::read("[conductor]\ncatalogue = \"drake\"\n[analysis]\ntype = \"axial-torsion\"\n").conductor;
  for (std::size_t j = 0; j < 4; ++j) {
    CHECK(mine.strand.layers[j].wires == theirs->strand.layers[j].wires);
    CHECK(mine.strand.layers[j].young == theirs->strand.layers[j].young);
    // The catalogue rounds lay lengths to 0.1 mm of some 200.
    check_close(mine.strand.layers[j].lay_angle, theirs->strand.layers[j].lay_angle, {.relative = 5e-4}, "lay angle");
  }
  check_close(mine.strand.mass_per_length, 1.628, {.relative = 0.005}, "mass");
}

TEST_CASE("semicolons separate cells too, and a line's own constants win over those of its metal") {
  const std::string table =
      casefile::import_wires_text("wires; diameter_mm; metal; young_GPa\n1; 4; ST; 190\n", "w.csv");
  const auto strand_of_one = test::read(table + "[analysis]\ntype = \"axial-torsion\"\n").conductor->strand;
  CHECK(strand_of_one.layers[0].young == 190e9);
  CHECK(strand_of_one.layers[0].density == 7780);
}

TEST_CASE("what is wrong with a CSV of wires is said with file, line, column and what would be right") {
  CHECK(contains(import_refusal(""), "wires.csv:1:1: holds no layers; write a line"));
  CHECK(contains(import_refusal("wires,diametre_mm\n1,3\n"),
                 "wires.csv:1:7: unknown column `diametre_mm`; did you mean `diameter_mm`?"));
  CHECK(contains(import_refusal("wires,wires\n1,3\n"), "wires.csv:1:7: the column `wires` is given twice"));
  CHECK(contains(import_refusal("wires,diameter_mm,metal\n1,3.2,iron\n"),
                 "wires.csv:2:7: metal = iron: is no metal known here; give one of AL1"));
  CHECK(contains(import_refusal("wires;diameter_mm;metal\n1;3,2;ST\n"),
                 "wires.csv:2:3: diameter_mm = 3,2: must be a number"));
  CHECK(contains(import_refusal("wires,diameter_mm,metal\n1,3,2,ST\n"), "4 cells, but the first line names 3 columns"));
  for (const char* number : {"nan", "inf", "1e999", "0x3", "3 mm"}) {
    CHECK(contains(import_refusal(std::string("wires,diameter_mm,metal\n1,") + number + ",ST\n"), "must be a number"));
  }
  CHECK(contains(import_refusal("wires,diameter_mm,shape\n1,3,ro\"und\n"), "wires.csv:2:5: shape = ro\"und: is not"));
  CHECK(contains(import_refusal("wires,diameter_mm,metal\n1,-3,ST\n"),
                 "wires.csv:2:3: conductor.layer[0].diameter_mm = -3: must be above 0"));
  CHECK(contains(import_refusal("wires,diameter_mm,metal\n1,3,ST\n6,3,ST\n"),
                 "wires.csv:3:1: conductor.layer[1]: its lay is missing"));
  CHECK(contains(import_refusal("wires,diameter_mm,metal,lay_ratio\n1,3,ST,\n9,3,ST,12\n"), "wires.csv:3:1: "));
}
