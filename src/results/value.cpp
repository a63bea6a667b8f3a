#include "strandyn/results/value.hpp"

#include <algorithm>

namespace strandyn::results {

void Value::set(std::string_view key, Value value) {
  if (is_null()) data_ = Object();
  Object& members = std::get<Object>(data_);
  const auto found = std::ranges::find(members, key, &Member::first);
  if (found != members.end()) {
    found->second = std::move(value);
  } else {
    members.emplace_back(key, std::move(value));
  }
}

void Value::append(Value value) {
  if (is_null()) data_ = List();
  std::get<List>(data_).push_back(std::move(value));
}

void Value::merge(const Value& other) {
  for (const auto& [key, value] : other.members()) set(key, value);
}

std::optional<double> Value::number() const {
  if (const double* x = std::get_if<double>(&data_)) return *x;
  if (const auto* x = std::get_if<std::int64_t>(&data_)) return static_cast<double>(*x);
  if (const auto* x = std::get_if<std::uint64_t>(&data_)) return static_cast<double>(*x);
  return std::nullopt;
}

std::optional<bool> Value::flag() const {
  if (const bool* x = std::get_if<bool>(&data_)) return *x;
  return std::nullopt;
}

const Value::List& Value::entries() const {
  static const List none;
  const List* list = std::get_if<List>(&data_);
  return list ? *list : none;
}

const Value::Object& Value::members() const {
  static const Object none;
  const Object* object = std::get_if<Object>(&data_);
  return object ? *object : none;
}

const Value* Value::find(std::string_view key) const {
  const Object& all = members();
  const auto found = std::ranges::find(all, key, &Member::first);
  return found == all.end() ? nullptr : &found->second;
}

const char* Value::kind() const {
  if (is_null()) return "null";
  if (is_object()) return "an object";
  if (is_list()) return "a list";
  if (words()) return "a text";
  return flag() ? "true or false" : "a number";
}

}  // namespace strandyn::results
