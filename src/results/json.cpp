#include "strandyn/results/json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "strandyn/core/error.hpp"
#include "strandyn/results/folder.hpp"

namespace strandyn::results {

using nlohmann::ordered_json;

namespace {

ordered_json to_json(const Value& value) {
  return value.visit([](const auto& data) -> ordered_json {
    using T = std::remove_cvref_t<decltype(data)>;
    if constexpr (std::is_same_v<T, std::monostate>) {
      return nullptr;
    } else if constexpr (std::is_same_v<T, Value::List>) {
      ordered_json list = ordered_json::array();
      for (const Value& entry : data) list.push_back(to_json(entry));
      return list;
    } else if constexpr (std::is_same_v<T, Value::Object>) {
      ordered_json object = ordered_json::object();
      for (const auto& [key, member] : data) object.push_back({key, to_json(member)});
      return object;
    } else {
      return data;
    }
  });
}

Value from_json(const ordered_json& json) {
  switch (json.type()) {
    case ordered_json::value_t::boolean:
      return json.get<bool>();
    case ordered_json::value_t::number_integer:
      return json.get<std::int64_t>();
    case ordered_json::value_t::number_unsigned:
      return json.get<std::uint64_t>();
    case ordered_json::value_t::number_float:
      return json.get<double>();
    case ordered_json::value_t::string:
      return json.get<std::string>();
    case ordered_json::value_t::array: {
      Value list = Value::list();
      for (const ordered_json& entry : json) list.append(from_json(entry));
      return list;
    }
    case ordered_json::value_t::object: {
      Value::Object members;
      for (const auto& [key, member] : json.items()) members.emplace_back(key, from_json(member));
      return Value::object(std::move(members));
    }
    default:
      return {};
  }
}

/// Deeper than anything that this program writes; what goes deeper would exhaust the stack.
constexpr int greatest_depth = 64;

bool is_too_deep(std::string_view text) {
  int depth = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted && c == '\\') ++i;
    if (c == '"') quoted = !quoted;
    if (quoted) continue;
    if ((c == '[' || c == '{') && ++depth > greatest_depth) return true;
    if (c == ']' || c == '}') --depth;
  }
  return false;
}

/// Where the first number stands that is not finite, as a path into the document.
std::optional<std::string> find_non_finite(const Value& value, const std::string& place) {
  const auto number = value.number();
  if (number && !std::isfinite(*number)) return place;
  for (std::size_t i = 0; i < value.entries().size(); ++i) {
    if (auto found = find_non_finite(value.entries()[i], fmt::format("{}[{}]", place, i))) return found;
  }
  for (const auto& [key, member] : value.members()) {
    if (auto found = find_non_finite(member, place.empty() ? key : place + "." + key)) return found;
  }
  return std::nullopt;
}

}  // namespace

std::string to_text(const Value& value, int indent) {
  return to_json(value).dump(indent, ' ', false, ordered_json::error_handler_t::replace);
}

Value from_text(std::string_view text, const std::string& name) {
  if (is_too_deep(text)) throw InputError(fmt::format("{}: more than {} levels deep", name, greatest_depth));
  try {
    return from_json(ordered_json::parse(text));
  } catch (const ordered_json::parse_error& error) {
    const std::string_view words = error.what();
    const auto place = words.find("parse error");
    throw InputError(fmt::format("{}: {}", name, place == std::string_view::npos ? words : words.substr(place)));
  } catch (const ordered_json::out_of_range&) {
    throw InputError(fmt::format("{}: a number in it is beyond what a double holds", name));
  }
}

std::optional<Value> from_line(std::string_view text) {
  if (is_too_deep(text)) return std::nullopt;
  const ordered_json json = ordered_json::parse(text, nullptr, false);
  if (json.is_discarded()) return std::nullopt;
  return from_json(json);
}

void write_json(const std::filesystem::path& path, const Value& value) {
  if (const auto place = find_non_finite(value, "")) {
    throw FileError(fmt::format("refused to write {}: {} is not a finite number", path.string(),
                                place->empty() ? "the document" : *place));
  }
  write_file(path, to_text(value) + "\n");
}

}  // namespace strandyn::results
