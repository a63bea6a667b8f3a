#include "strandyn/casefile/schema.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <initializer_list>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <type_traits>

#include "keys.hpp"
#include "plain_number.hpp"
#include "strandyn/conductor/catalogue.hpp"

namespace strandyn::casefile {
namespace {

using nlohmann::ordered_json;

ordered_json json_number(double x) {
  const double y = plain_number(x);
  if (is_whole(y)) return static_cast<std::int64_t>(y);
  return y;
}

ordered_json number_schema(const Number& number, bool whole) {
  ordered_json schema = {{"type", whole ? "integer" : "number"}};
  if (number.above) schema["exclusiveMinimum"] = json_number(*number.above);
  if (number.at_least) schema["minimum"] = json_number(*number.at_least);
  if (number.below) schema["exclusiveMaximum"] = json_number(*number.below);
  if (number.at_most) schema["maximum"] = json_number(*number.at_most);
  if (number.not_zero) schema["not"] = {{"const", 0}};
  if (number.multiple_of > 0) schema["multipleOf"] = number.multiple_of;
  return schema;
}

ordered_json scalar_schema() {
  return {{"type", {"number", "boolean", "string"}}};
}

template <class E>
ordered_json choice_schema() {
  ordered_json names = ordered_json::array();
  for (const auto& named : choices<E>) names.push_back(named.name);
  return {{"enum", names}};
}

/// The visitor that describes one table. Defaults are read off the fields of a fresh struct.
class SchemaWriter {
 public:
  void number(const char* key, double value, const Number& spec) {
    ordered_json schema = number_schema(spec, false);
    if (!spec.required) schema["default"] = json_number(spec.unit.from_si(value));
    add(key, schema, describe(spec), spec.required);
  }
  void number(const char* key, int value, const Number& spec) {
    ordered_json schema = number_schema(spec, true);
    if (!spec.required) schema["default"] = value;
    add(key, schema, describe(spec), spec.required);
  }
  template <class T>
  void number(const char* key, const std::optional<T>&, const Number& spec) {
    ordered_json schema = number_schema(spec, std::is_same_v<T, int>);
    if (spec.word) schema = {{"anyOf", {schema, {{"const", spec.word}}}}, {"default", spec.word}};
    if (spec.otherwise) schema["default"] = *spec.otherwise;
    add(key, schema, describe(spec), spec.required);
  }

  void numbers(const char* key, const std::vector<double>&, const Number& spec) {
    const ordered_json one = number_schema(spec, false);
    const ordered_json list = {{"type", "array"}, {"items", one}, {"minItems", 1}};
    add(key, {{"anyOf", {one, list}}}, describe(spec), spec.required);
  }

  void vector(const char* key, const std::optional<Vector3>&, const Plain& spec) {
    add(key, {{"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", 3}, {"maxItems", 3}}, spec);
  }

  template <std::size_t N>
  void rows(const char* key, const std::vector<std::array<double, N>>&, const std::array<Number, N>& columns,
            const Plain& spec) {
    ordered_json cells = ordered_json::array();
    for (const Number& column : columns) {
      cells.push_back(number_schema(column, column.whole));
      cells.back()["description"] = describe(column);
    }
    const ordered_json row = {{"type", "array"}, {"prefixItems", cells}, {"minItems", N}, {"maxItems", N}};
    add(key, {{"type", "array"}, {"items", row}, {"minItems", 1}}, spec);
  }

  template <class E>
  void choice(const char* key, const E& value, const Plain& spec) {
    ordered_json schema = choice_schema<E>();
    if (!spec.required && !spec.depends) schema["default"] = name_of(value);
    add(key, schema, spec);
    if (spec.old_name) add_old_name(key, choice_schema<E>(), spec);
  }
  template <class E>
  void choice(const char* key, const std::optional<E>&, const Plain& spec) {
    add(key, choice_schema<E>(), spec);
    if (spec.old_name) add_old_name(key, choice_schema<E>(), spec);
  }

  template <class T>
  void text(const char* key, const T&, const Plain& spec) {
    add(key, {{"type", "string"}, {"minLength", 1}}, spec);
  }
  void flag(const char* key, bool value, const Plain& spec) {
    add(key, {{"type", "boolean"}, {"default", value}}, spec);
  }
  void flag(const char* key, const std::optional<bool>&, const Plain& spec) { add(key, {{"type", "boolean"}}, spec); }
  void scalar(const char* key, const std::optional<Scalar>&, const Plain& spec) { add(key, scalar_schema(), spec); }
  void scalars(const char* key, const std::vector<Scalar>&, const Plain& spec) {
    add(key, {{"type", "array"}, {"items", scalar_schema()}, {"minItems", 1}}, spec);
  }
  void mode_word(const char* key, const std::optional<int>&, const Plain& spec) {
    add(key, {{"type", "string"}, {"pattern", "^mode 0*[1-9][0-9]*$"}}, spec);
  }
  void catalogue(const char* key, const Conductor&, const Plain& spec);
  void conductor_file(const char* key, const Conductor& field, const Plain& spec) { text(key, field.file, spec); }

  void criteria(const char* key, Acceptance&, const Plain& spec) {
    add(key, {{"type", "object"}, {"additionalProperties", write<Criterion>()}}, spec);
  }
  template <class T>
  void table(const char* key, T&, const Plain& spec) {
    add(key, write<T>(), spec);
  }
  template <class T>
  void table(const char* key, std::optional<T>&, const Plain& spec) {
    add(key, write<T>(), spec);
  }
  template <class T>
  void tables(const char* key, std::vector<T>&, const Plain& spec) {
    add(key, {{"type", "array"}, {"items", write<T>()}, {"minItems", 1}}, spec);
  }

  void one_of(std::initializer_list<const char*> group, const OneOf& spec) {
    ordered_json alternatives = ordered_json::array();
    for (const char* key : group) alternatives.push_back({{"required", {key}}});
    const ordered_json rule = {{"oneOf", alternatives}};
    if (spec.required) {
      rules_->push_back(rule);
    } else {
      rules_->push_back({{"anyOf", {rule, {{"not", {{"anyOf", alternatives}}}}}}});
    }
  }

  template <class... Kinds>
  void kinds(const char* key, const std::variant<Kinds...>&, const Plain& spec) {
    add(key, {{"enum", {Kinds::word...}}}, spec);
    (write_kind<Kinds>(key), ...);
  }

  template <class E, class Keys>
  void when(const char* selector, const E& value, std::initializer_list<E> wanted, Keys write_keys) {
    ordered_json names = ordered_json::array();
    bool by_default = false;
    for (const E choice : wanted) {
      names.push_back(name_of(choice));
      by_default = by_default || choice == value;
    }
    write_under(selector, names, by_default, write_keys);
  }

  template <class T>
  static ordered_json write() {
    SchemaWriter writer;
    T fresh{};
    keys(writer, fresh);
    return writer.object();
  }

 private:
  template <class Kind>
  void write_kind(const char* selector) {
    write_under(selector, ordered_json::array({Kind::word}), false, [&] {
      Kind fresh{};
      keys(*this, fresh);
    });
  }

  /// Keys that stand under some words of an earlier key only, which may be left out where one of them is its default.
  template <class Keys>
  void write_under(const char* selector, const ordered_json& names, bool by_default, Keys write_keys) {
    ordered_json condition = {{"properties", {{selector, {{"enum", names}}}}}};
    if (!by_default) condition["required"] = {selector};

    // What the keys of this choice demand holds under the condition only.
    ordered_json rules = ordered_json::array(), required = ordered_json::array();
    choice_ = condition;
    rules_ = &rules;
    required_ = &required;
    write_keys();
    choice_ = nullptr;
    rules_ = &all_rules_;
    required_ = &all_required_;
    ordered_json then = ordered_json::object();
    if (!required.empty()) then["required"] = required;
    if (!rules.empty()) then["allOf"] = rules;
    if (!then.empty()) all_rules_.push_back({{"if", condition}, {"then", then}});
  }

  void add_old_name(const char* key, ordered_json schema, const Plain& spec) {
    schema["deprecated"] = true;
    add(spec.old_name, std::move(schema), fmt::format("old name of `{}`", key), false);
  }

  void add(const char* key, ordered_json schema, const Plain& spec) {
    add(key, std::move(schema), spec.help, spec.required);
  }

  void add(const char* key, ordered_json schema, const std::string& description, bool required) {
    if (!properties_.contains(key)) {
      schema["description"] = description;
      properties_[key] = std::move(schema);
    }
    if (required) required_->push_back(key);
    if (!choice_.is_null()) conditions_[key].push_back(choice_);
  }

  ordered_json object() {
    for (const auto& [key, conditions] : conditions_) {
      const ordered_json any = conditions.size() == 1 ? conditions.front() : ordered_json{{"anyOf", conditions}};
      all_rules_.push_back({{"if", {{"required", {key}}}}, {"then", any}});
    }
    ordered_json schema = {{"type", "object"}, {"additionalProperties", false}, {"properties", properties_}};
    if (!all_required_.empty()) schema["required"] = all_required_;
    if (!all_rules_.empty()) schema["allOf"] = all_rules_;
    return schema;
  }

  ordered_json properties_ = ordered_json::object();
  ordered_json all_rules_ = ordered_json::array();
  ordered_json all_required_ = ordered_json::array();
  ordered_json* rules_ = &all_rules_;
  ordered_json* required_ = &all_required_;
  ordered_json choice_;                             ///< condition of the keys being written, or null
  std::map<std::string, ordered_json> conditions_;  ///< by key: under which it may stand
};

void SchemaWriter::catalogue(const char* key, const Conductor&, const Plain& spec) {
  ordered_json names = ordered_json::array();
  for (const conductor::CatalogueEntry& entry : conductor::catalogue()) names.push_back(entry.name);
  add(key, {{"enum", names}}, spec);
}

}  // namespace

std::string case_schema() {
  ordered_json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                         {"title", "A case of strandyn"},
                         {"description", "Units stand in the names of the keys."}};
  schema.update(SchemaWriter::write<Scene>());
  return schema.dump(2);
}

}  // namespace strandyn::casefile
