#include "strandyn/casefile/schema.hpp"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "strandyn/casefile/echo.hpp"
#include "strandyn/results/json.hpp"
#include "texts.hpp"

using nlohmann::ordered_json;
using strandyn::casefile::case_schema;

namespace {

/// Every key of `value` is a property that the schema describes.
void check_described(const ordered_json& value, const ordered_json& schema, const std::string& path) {
  CAPTURE(path);
  if (value.is_object()) {
    for (const auto& [key, child] : value.items()) {
      const bool known = schema.contains("properties") && schema["properties"].contains(key);
      const bool open = schema.contains("additionalProperties") && schema["additionalProperties"].is_object();
      CAPTURE(key);
      REQUIRE((known || open));
      check_described(child, known ? schema["properties"][key] : schema["additionalProperties"], path + "." + key);
    }
  } else if (value.is_array() && schema.contains("items")) {
    for (const auto& child : value) check_described(child, schema["items"], path + "[]");
  }
}

/// Calls `visit(key, schema)` for every property, at any depth.
template <class Visit>
void for_each_property(const ordered_json& schema, const Visit& visit) {
  if (schema.contains("properties")) {
    for (const auto& [key, child] : schema["properties"].items()) {
      visit(key, child);
      for_each_property(child, visit);
    }
  }
  for (const char* inside : {"items", "additionalProperties"}) {
    if (schema.contains(inside) && schema[inside].is_object()) for_each_property(schema[inside], visit);
  }
}

}  // namespace

TEST_CASE("the schema says unit, default, bounds, choices and need of a key") {
  const ordered_json schema = ordered_json::parse(case_schema());
  CHECK(schema["$schema"] == "https://json-schema.org/draft/2020-12/schema");
  CHECK(schema["required"] == ordered_json::array({"analysis"}));
  CHECK(schema["additionalProperties"] == false);
  const ordered_json& span = schema["properties"]["span"]["properties"];
  CHECK(span["length_m"]["exclusiveMinimum"] == 0);
  CHECK(span["length_m"]["description"] == "the distance between the supports in metres");
  CHECK(span["mass"]["default"] == "consistent");
  CHECK(span["left"]["enum"] == ordered_json::array({"clamped", "pinned", "roller", "free", "guided"}));
  CHECK(span["elements"]["anyOf"][1]["const"] == "auto");
  const ordered_json& points = schema["properties"]["section"]["properties"]["points"];
  CHECK(points["type"] == "integer");
  CHECK(points["multipleOf"] == 4);
  CHECK(points["default"] == 36);
}

TEST_CASE("the schema describes every key that a case as run shows") {
  using namespace strandyn::test;
  const ordered_json schema = ordered_json::parse(case_schema());
  for (const std::string& text : {lab_span, beam, three_layers, bend, pushed}) {
    check_described(
        ordered_json::parse(strandyn::results::to_text(strandyn::casefile::case_as_run(strandyn::test::read(text)))),
        schema, "");
  }
}

TEST_CASE("every key has a help text, and a unit in the text stands in the name of the key") {
  int keys = 0;
  for_each_property(ordered_json::parse(case_schema()), [&](const std::string& key, const ordered_json& schema) {
    ++keys;
    CAPTURE(key);
    const std::string help = schema.value("description", "");
    CHECK(help.size() > 3);
    for (const auto& [words, suffix] :
         {std::pair{" in millimetres", "_mm"}, std::pair{" in kilonewtons", "_kN"},
          std::pair{" in gigapascals", "_GPa"}, std::pair{" in degrees", "_deg"}, std::pair{" in hertz", "_Hz"},
          std::pair{" in newtons per millimetre", "_N_per_mm"}}) {
      const bool named = key.ends_with(suffix) && !key.ends_with(std::string("_per") + suffix);
      CHECK((help.find(words) != std::string::npos) == named);
    }
  });
  CHECK(keys > 80);
}

TEST_CASE("the schema ties a key to the choice that it belongs to") {
  const ordered_json rules = ordered_json::parse(case_schema())["properties"]["analysis"]["allOf"];
  bool found = false;
  for (const auto& rule : rules) {
    if (rule.value("if", ordered_json{}) != ordered_json{{"required", {"count"}}}) continue;
    found = rule["then"]["properties"]["type"]["enum"] == ordered_json::array({"modes"});
  }
  CHECK(found);
}

TEST_CASE("the schema knows motions and bodies with their bounds") {
  const ordered_json schema = ordered_json::parse(case_schema());
  const ordered_json& motion = schema["properties"]["motion"]["items"];
  CHECK(motion["required"] == ordered_json::array({"type"}));
  CHECK(motion["properties"]["at"]["enum"] == ordered_json::array({"left", "right"}));
  CHECK(motion["properties"]["rotation_deg"]["description"] == "the rotation in degrees");
  CHECK(motion["properties"]["history"]["items"]["prefixItems"][1]["description"] ==
        "displacement in millimetres (degrees with rotation = true)");
  const ordered_json& body = schema["properties"]["body"]["items"];
  CHECK(body["required"] == ordered_json::array({"at_m"}));
  CHECK(body["properties"]["mass_kg"]["minimum"] == 0);
  CHECK(body["properties"]["mass_kg"]["default"] == 0);
}

TEST_CASE("the schema forbids 0 where a number must not be 0 and asks for it under its choice only") {
  const ordered_json control = ordered_json::parse(case_schema())["properties"]["static"];
  CHECK(control["properties"]["displacement_mm"]["not"] == ordered_json{{"const", 0}});
  CHECK_FALSE(control.contains("required"));
  bool asked = false;
  for (const auto& rule : control["allOf"])
    asked = asked || rule["then"].value("required", ordered_json{}) == ordered_json::array({"displacement_mm"});
  CHECK(asked);
}
