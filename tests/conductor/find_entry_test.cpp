#include <doctest/doctest.h>

#include <string>

#include "strandyn/conductor/catalogue.hpp"
#include "strandyn/conductor/metals.hpp"

using namespace strandyn::conductor;

namespace {

std::string found(std::string_view name) {
  const CatalogueEntry* entry = find_entry(name);
  return entry ? std::string(entry->name) : "";
}

std::string near(std::string_view name) {
  const CatalogueEntry* entry = near_entry(name);
  return entry ? std::string(entry->name) : "";
}

}  // namespace

TEST_CASE("a conductor is found however people write its name") {
  for (const char* name : {"drake", "Drake", "DRAKE", "ACSR Drake", "acsr-drake", "ACSR Drake 26/7", "acsr_drake "}) {
    CAPTURE(name);
    CHECK(found(name) == "drake");
  }
  CHECK(found("Aster 570") == "aster-570");
  CHECK(found("AAAC Aster-570") == "aster-570");
  CHECK(found("Curlew 54/7") == "curlew-54-7");
}

TEST_CASE("another type of the same name is another conductor") {
  CHECK(found("ACSS Drake") == "");
  CHECK(found("AAC Drake") == "");
  CHECK(found("") == "");
  CHECK(found("ACSR") == "");
}

TEST_CASE("a misspelt name finds what was meant, with the type in front or not") {
  CHECK(near("drak") == "drake");
  CHECK(near("ACSR Darke") == "drake");
  CHECK(near("Zebre") == "zebra");
  CHECK(near("aster 571") == "aster-570");
  CHECK(near("ACSS Drake") == "drake");
  CHECK(near("completely else") == "");
}

TEST_CASE("the table of a case has the comment of the file above it and its layers below the conductor") {
  const std::string table = case_table(*find_entry("drake"));
  CHECK(table.starts_with("# Lay lengths"));
  CHECK(table.find("\n[conductor]\ntitle = \"ACSR Drake 26/7\"\n") != std::string::npos);
  CHECK(table.find("\n[[conductor.layer]]  # steel\n") != std::string::npos);
  CHECK(table.find("\n[[layer]]") == std::string::npos);
}

TEST_CASE("a metal is found by its grade") {
  CHECK(find_metal("AL1")->young == 68e9);
  CHECK(find_metal("al4")->density == 2703);
  CHECK(find_metal("ST6C")->young == 207e9);
  CHECK(find_metal("20SA")->density == 6590);
  for (const char* name : {"", "AL", "AL8", "copper", "STEEL"}) CHECK(find_metal(name) == nullptr);
}
