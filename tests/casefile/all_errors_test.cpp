#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "texts.hpp"

using strandyn::test::beam;
using strandyn::test::contains;
using strandyn::test::lab_span;
using strandyn::test::refusal;

namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  text.replace(text.find(from), from.size(), to);
  return text;
}

}  // namespace

TEST_CASE("all that is wrong with the keys of a case is told at once, a message each") {
  std::string text = replaced(lab_span, "length_m = 30", "length_m = -30");
  text = replaced(text, "points = 36", "points = 37\nlaw = \"sticky\"");
  text = replaced(text, "catalogue = \"curlew\"", "catalogue = \"curliew\"");
  text = replaced(text, "cycles = 200", "cycels = 200");
  text = replaced(text, "amplitude_N = 20", "amplitude_N = \"much\"");
  const std::vector<std::string> lines = lines_of(refusal(text));
  REQUIRE(lines.size() == 6);
  for (const char* said : {"span.length_m = -30: must be above 0", "section.points = 37: must be a multiple of 4",
                           "section.law = \"sticky\": is not a choice", "conductor.catalogue = \"curliew\"",
                           "unknown key `analysis.cycels`; did you mean `analysis.cycles`?",
                           "load[0].amplitude_N = \"much\": must be a number"}) {
    CAPTURE(said);
    CHECK(std::ranges::count_if(lines, [&](const std::string& line) { return contains(line, said); }) == 1);
  }
  const auto number_of = [](const std::string& line) {
    return std::stoi(line.substr(std::string("case.toml:").size()));
  };
  for (const std::string& line : lines) CHECK(line.starts_with("case.toml:"));
  CHECK(std::ranges::is_sorted(lines, {}, number_of));
}

TEST_CASE("a misspelt key is not said to be missing as well") {
  const std::string said = refusal(replaced(lab_span, "length_m = 30", "lenght_m = 30"));
  CHECK(lines_of(said).size() == 1);
  CHECK(contains(said, "did you mean `span.length_m`?"));
}

TEST_CASE("keys of a choice that was refused are not held against another choice") {
  const std::string said = refusal(replaced(lab_span, "type = \"harmonic-force\"", "type = \"harmonic-farce\""));
  CHECK(lines_of(said).size() == 1);
  CHECK(contains(said, "load[0].type = \"harmonic-farce\": is not a choice"));
  CHECK(lines_of(refusal(replaced(lab_span, "type = \"forced\"", "type = \"farced\""))).size() == 1);
}

TEST_CASE("what is wrong between keys is told at once too, each layer, load and acceptance by itself") {
  const std::string loads =
      "[[load]]\ntype = \"static-force\"\nat_m = 40\nforce_N = 3\n[[load]]\ntype = \"static-force\"\nat_m = 50\n"
      "force_N = 3\n[accept]\n\"a[first]\" = { below = 1, reason = \"r\" }\n";
  const std::vector<std::string> lines = lines_of(refusal(beam + loads));
  REQUIRE(lines.size() == 3);
  CHECK(contains(lines[0], "load[0].at_m = 40"));
  CHECK(contains(lines[1], "load[1].at_m = 50"));
  CHECK(contains(lines[2], "[first] is none of"));
}

TEST_CASE("after ten messages only their number is told") {
  std::string text = beam + "[accept]\n";
  for (int i = 0; i < 14; ++i) text += fmt::format("\"q{}\" = {{ expected = 1, reason = \"r\" }}\n", i);
  const std::vector<std::string> lines = lines_of(refusal(text));
  REQUIRE(lines.size() == 11);
  CHECK(lines.back() == "and 4 more like these");
}
