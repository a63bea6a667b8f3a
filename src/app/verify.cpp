#include "strandyn/study/verify.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "shipped.hpp"
#include "strandyn/report/text_table.hpp"
#include "strandyn/results/json.hpp"
#include "strandyn/results/record.hpp"
#include "strandyn/version.hpp"
#include "streams.hpp"
#include "verbs.hpp"

namespace strandyn::app {
namespace {

using study::VerifiedCase;

/// A quantity as `verify --json` prints it.
struct QuantityRow {
  std::string quantity, wanted, found;
  std::optional<double> digits{};
  bool passed = false;
  std::string source, reason;
};
template <class V>
void members(V& v, QuantityRow& q) {
  v.value("quantity", q.quantity, {.what = "path into the summary"});
  v.value("wanted", q.wanted, {.what = "what the case expects"});
  v.value("found", q.found, {.what = "what stands there"});
  v.value("digits", q.digits, {.what = "correct decimal digits"});
  v.value("passed", q.passed, {.what = "whether it holds"});
  v.value("source", q.source, {.what = "where the expected value comes from"});
  v.value("reason", q.reason, {.what = "why it must hold"});
}
struct CaseRow {
  std::string name, title;
  bool passed = false;
  std::optional<std::string> error{};
  std::vector<QuantityRow> quantities{};
};
template <class V>
void members(V& v, CaseRow& c) {
  v.value("case", c.name, {.what = "path below the folder of cases"});
  v.value("title", c.title, {.what = "of the case"});
  v.value("passed", c.passed, {.what = "whether all holds"});
  v.value("error", c.error, {.what = "why it could not be run"});
  v.list("quantities", c.quantities, {.what = "each entry of [accept]"});
}

CaseRow row_of(const VerifiedCase& c) {
  CaseRow row{.name = c.name, .title = c.title, .passed = c.passed()};
  if (!c.error.empty()) row.error = c.error;
  for (const casefile::Verdict& v : c.verdicts) {
    row.quantities.push_back({.quantity = v.path,
                              .wanted = v.wanted,
                              .found = v.found,
                              .digits = v.digits,
                              .passed = v.passed,
                              .source = v.source,
                              .reason = v.reason});
  }
  return row;
}

void print_case(const VerifiedCase& c) {
  using report::Align;
  print("\n{}: {}\n", c.name, c.title);
  if (!c.error.empty()) print("FAILED: {}\n", c.error);
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
  print("{}", table.str());
}

/// Where the expected value comes from; an entry without a source says why it must hold.
std::string ground_of(const casefile::Verdict& v) {
  std::string text = v.source.empty() ? v.reason : v.source;
  for (auto bar = text.find('|'); bar != std::string::npos; bar = text.find('|', bar + 2)) text.insert(bar, 1, '\\');
  return text;
}

void print_markdown(const std::vector<VerifiedCase>& cases) {
  std::string folder;
  for (const VerifiedCase& c : cases) {
    const std::string here = c.name.substr(0, c.name.find('/') == std::string::npos ? 0 : c.name.find('/'));
    if (here != folder || &c == &cases.front()) print("\n## {}\n", here.empty() ? "cases" : "cases/" + here);
    folder = here;
    print("\n### {}\n\n`cases/{}.toml`{}\n", c.title, c.name, c.error.empty() ? "" : ": **FAILED**, " + c.error);
    if (c.verdicts.empty()) continue;
    print("\n| quantity | expected | found | digits |  | source, or why |\n| --- | --- | --- | ---: | --- | --- |\n");
    for (const casefile::Verdict& v : c.verdicts) {
      print("| `{}` | {} | {} | {} | {} | {} |\n", v.path, v.wanted, v.found,
            v.digits ? fmt::format("{:.1f}", *v.digits) : "", v.passed ? "passed" : "**FAILED**", ground_of(v));
    }
  }
}

}  // namespace

ExitCode verify(const VerifyArguments& arguments) {
  if (!arguments.names.empty() && arguments.names.front() == "extremes") return verify_extremes(arguments);
  const std::filesystem::path folder =
      arguments.folder.empty() ? shipped("cases", "share/strandyn/cases") : arguments.folder;
  const std::vector<VerifiedCase> cases =
      study::verify_cases(folder, arguments.names, [](const std::string& name) { tell("running {}\n", name); });
  if (cases.empty()) throw InputError("no case with an [accept] table has such a name; `ls cases` shows what there is");
  const auto passed = std::count_if(cases.begin(), cases.end(), [](const VerifiedCase& c) { return c.passed(); });
  if (arguments.json) {
    std::vector<CaseRow> rows;
    for (const VerifiedCase& c : cases) rows.push_back(row_of(c));
    print_raw(results::to_text(results::to_value(rows)) + '\n');
  } else if (arguments.markdown) {
    print_markdown(cases);
    print("\n{} of {} cases hold what they promise (strandyn {}, {}).\n", passed, cases.size(), program_version,
          program_revision);
  } else {
    for (const VerifiedCase& c : cases) print_case(c);
    print("\n{} of {} cases hold what they promise\n", passed, cases.size());
  }
  return passed == static_cast<std::ptrdiff_t>(cases.size()) ? ExitCode::done : ExitCode::not_converged;
}

}  // namespace strandyn::app
