#include "strandyn/casefile/echo.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include "strandyn/results/json.hpp"

#include <initializer_list>
#include <string>

#include "json_number.hpp"
#include "keys.hpp"

namespace strandyn::casefile {
namespace {

using nlohmann::ordered_json;

ordered_json to_json(const Scalar& scalar) {
  if (const double* x = std::get_if<double>(&scalar)) return json_number(*x);
  return std::visit([](const auto& value) { return ordered_json(value); }, scalar);
}

/// The visitor that writes one table.
class Echo {
 public:
  ordered_json object = ordered_json::object();

  void number(const char* key, double x, const Number& spec) { object[key] = json_number(spec.unit.from_si(x)); }
  void number(const char* key, int x, const Number&) { object[key] = x; }
  template <class T>
  void number(const char* key, const std::optional<T>& x, const Number& spec) {
    if (x) {
      number(key, *x, spec);
    } else if (spec.word) {
      object[key] = spec.word;
    }
  }

  void numbers(const char* key, const std::vector<double>& list, const Number& spec) {
    for (const double x : list) object[key].push_back(json_number(spec.unit.from_si(x)));
  }

  void vector(const char* key, const std::optional<Vector3>& components, const Plain&) {
    if (!components) return;
    for (const double x : *components) object[key].push_back(json_number(x));
  }

  template <std::size_t N>
  void rows(const char* key, const std::vector<std::array<double, N>>& list, const std::array<Number, N>& columns,
            const Plain&) {
    for (const auto& row : list) {
      ordered_json cells = ordered_json::array();
      for (std::size_t j = 0; j < N; ++j) cells.push_back(json_number(columns[j].unit.from_si(row[j])));
      object[key].push_back(cells);
    }
  }

  template <class E>
  void choice(const char* key, const E& value, const Plain&) {
    object[key] = name_of(value);
  }
  template <class E>
  void choice(const char* key, const std::optional<E>& value, const Plain&) {
    if (value) object[key] = name_of(*value);
  }

  void text(const char* key, const std::string& value, const Plain&) { object[key] = value; }
  void text(const char* key, const std::optional<std::string>& value, const Plain&) {
    if (value) object[key] = *value;
  }

  void flag(const char* key, bool value, const Plain&) { object[key] = value; }
  void flag(const char* key, const std::optional<bool>& value, const Plain&) {
    if (value) object[key] = *value;
  }

  void scalar(const char* key, const std::optional<Scalar>& value, const Plain&) {
    if (value) object[key] = to_json(*value);
  }
  void mode_word(const char* key, const std::optional<int>& mode, const Plain&) {
    if (mode) object[key] = fmt::format("mode {}", *mode);
  }
  void catalogue(const char* key, const Conductor& conductor, const Plain& spec) {
    text(key, conductor.catalogue, spec);
  }

  void criteria(const char* key, Acceptance& acceptance, const Plain&) {
    for (Criterion& criterion : acceptance.criteria) object[key][criterion.path] = write(criterion);
  }

  template <class T>
  void table(const char* key, T& value, const Plain&) {
    object[key] = write(value);
  }
  template <class T>
  void table(const char* key, std::optional<T>& value, const Plain&) {
    if (value) object[key] = write(*value);
  }
  template <class T>
  void tables(const char* key, std::vector<T>& list, const Plain&) {
    for (T& value : list) object[key].push_back(write(value));
  }

  void one_of(std::initializer_list<const char*>, const OneOf&) {}

  template <class E, class Keys>
  void when(const char*, const E& value, std::initializer_list<E> wanted, Keys write_keys) {
    for (const E choice : wanted) {
      if (choice == value) write_keys();
    }
  }

  template <class T>
  static ordered_json write(T& value) {
    Echo echo;
    keys(echo, value);
    return std::move(echo.object);
  }
};

}  // namespace

results::Value case_as_run(const Scene& scene) {
  Scene copy = scene;  // the declarations of the keys bind to what a reader may fill
  return results::from_text(Echo::write(copy).dump(), "");
}

}  // namespace strandyn::casefile
