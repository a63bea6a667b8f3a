#include "strandyn/study/verify.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "strandyn/report/text_table.hpp"
#include "verbs.hpp"

namespace strandyn::app {
namespace {

using study::VerifiedCase;

nlohmann::ordered_json verified_json(const std::vector<VerifiedCase>& cases) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const VerifiedCase& c : cases) {
    nlohmann::ordered_json entry = {{"case", c.name}, {"title", c.title}, {"passed", c.passed()}};
    if (!c.error.empty()) entry["error"] = c.error;
    entry["quantities"] = nlohmann::ordered_json::array();
    for (const casefile::Verdict& v : c.verdicts) {
      nlohmann::ordered_json quantity = {{"quantity", v.path}, {"wanted", v.wanted}, {"found", v.found}};
      if (v.digits) quantity["digits"] = *v.digits;
      quantity["passed"] = v.passed;
      quantity["source"] = v.source;
      quantity["reason"] = v.reason;
      entry["quantities"].push_back(quantity);
    }
    list.push_back(entry);
  }
  return list;
}

void print_case(const VerifiedCase& c) {
  using report::Align;
  fmt::print("\n{}: {}\n", c.name, c.title);
  if (!c.error.empty()) fmt::print("FAILED: {}\n", c.error);
  if (c.verdicts.empty()) return;
  report::TextTable table({{.header = "quantity", .align = Align::left},
                           {.header = "wanted"},
                           {.header = "got"},
                           {.header = "digits", .digits = 2},
                           {.header = "", .align = Align::left},
                           {.header = "source", .align = Align::left}});
  for (const casefile::Verdict& v : c.verdicts) {
    table.add_row({v.path, v.wanted, v.found, v.digits, v.passed ? "passed" : "FAILED", v.source});
  }
  fmt::print("{}", table.str());
}

}  // namespace

ExitCode verify(const VerifyArguments& arguments) {
  std::filesystem::path folder = arguments.folder;
  // A program that was built where its cases lie finds them from anywhere.
  if (folder.empty()) folder = std::filesystem::is_directory("cases") ? "cases" : STRANDYN_SOURCE_DIR "/cases";
  const std::vector<VerifiedCase> cases = study::verify_cases(
      folder, arguments.names, [](const std::string& name) { fmt::print(stderr, "running {}\n", name); });
  if (cases.empty()) throw InputError("no case with an [accept] table has such a name; `ls cases` shows what there is");
  const auto passed = std::count_if(cases.begin(), cases.end(), [](const VerifiedCase& c) { return c.passed(); });
  if (arguments.json) {
    fmt::print("{}\n", verified_json(cases).dump(2));
  } else {
    for (const VerifiedCase& c : cases) print_case(c);
    fmt::print("\n{} of {} cases hold what they promise\n", passed, cases.size());
  }
  return passed == static_cast<std::ptrdiff_t>(cases.size()) ? ExitCode::done : ExitCode::not_converged;
}

}  // namespace strandyn::app
