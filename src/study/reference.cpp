#include "strandyn/study/reference.hpp"

#include <fmt/format.h>

#include "entries.hpp"

namespace strandyn::study {
namespace {

std::string table_of(const std::vector<results::MemberNote>& notes) {
  std::string text = "| member | what it is |\n| --- | --- |\n";
  for (const results::MemberNote& note : notes) text += fmt::format("| `{}` | {} |\n", note.path, note.what);
  return text;
}

}  // namespace

std::string outputs_reference() {
  std::string text =
      "# What a run leaves\n\n"
      "`strandyn schema --results` prints this page. The unit stands in the name. An `[accept]` table takes these "
      "paths,\n"
      "with the number of an entry, or `max`, `min`, `sum`, in the brackets: `cycles[-1].kinetic_J`, "
      "`cycles[max].kinetic_J`.\n"
      "The columns of a CSV file are the members of the list that it is the file of: `cycles.csv` has those of "
      "`cycles[]`.\n"
      "What is not there was not computed.\n\n"
      "## In every summary.json\n\n";
  text += table_of(notes_of_frame());
  text += "\n## Where `accuracy` is given\n\n" + table_of(notes_of_accuracy());
  text += "\n## Where `accuracy` is given to a sweep\n\n" + table_of(notes_of_accurate_sweep());
  for (const Entry& entry : entries) {
    text += fmt::format("\n## `type = \"{}\"`\n\n", entry.word) + table_of(entry.notes());
  }
  return text;
}

}  // namespace strandyn::study
