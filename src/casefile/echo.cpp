#include "strandyn/casefile/echo.hpp"

#include <fmt/format.h>

#include <initializer_list>
#include <string>

#include "keys.hpp"
#include "plain_number.hpp"

namespace strandyn::casefile {
namespace {

using results::Value;

Value value_of_number(double x) {
  const double y = plain_number(x);
  if (is_whole(y)) return static_cast<std::int64_t>(y);
  return y;
}

Value value_of_scalar(const Scalar& scalar) {
  if (const double* x = std::get_if<double>(&scalar)) return value_of_number(*x);
  return std::visit([](const auto& value) { return Value(value); }, scalar);
}

/// The visitor that writes one table.
class Echo {
 public:
  Value object = Value::object();

  void number(const char* key, double x, const Number& spec) { object.set(key, value_of_number(spec.unit.from_si(x))); }
  void number(const char* key, int x, const Number&) { object.set(key, x); }
  template <class T>
  void number(const char* key, const std::optional<T>& x, const Number& spec) {
    if (x) {
      number(key, *x, spec);
    } else if (spec.word) {
      object.set(key, spec.word);
    }
  }

  void numbers(const char* key, const std::vector<double>& list, const Number& spec) {
    if (list.empty()) return;
    Value entries = Value::list();
    for (const double x : list) entries.append(value_of_number(spec.unit.from_si(x)));
    object.set(key, std::move(entries));
  }

  void vector(const char* key, const std::optional<Vector3>& components, const Plain&) {
    if (!components) return;
    Value entries = Value::list();
    for (const double x : *components) entries.append(value_of_number(x));
    object.set(key, std::move(entries));
  }

  template <std::size_t N>
  void rows(const char* key, const std::vector<std::array<double, N>>& list, const std::array<Number, N>& columns,
            const Plain&) {
    if (list.empty()) return;
    Value rows = Value::list();
    for (const auto& row : list) {
      Value cells = Value::list();
      for (std::size_t j = 0; j < N; ++j) cells.append(value_of_number(columns[j].unit.from_si(row[j])));
      rows.append(std::move(cells));
    }
    object.set(key, std::move(rows));
  }

  template <class E>
  void choice(const char* key, const E& value, const Plain&) {
    object.set(key, name_of(value));
  }
  template <class E>
  void choice(const char* key, const std::optional<E>& value, const Plain&) {
    if (value) object.set(key, name_of(*value));
  }

  void text(const char* key, const std::string& value, const Plain&) { object.set(key, value); }
  void text(const char* key, const std::optional<std::string>& value, const Plain&) {
    if (value) object.set(key, *value);
  }

  void flag(const char* key, bool value, const Plain&) { object.set(key, value); }
  void flag(const char* key, const std::optional<bool>& value, const Plain&) {
    if (value) object.set(key, *value);
  }

  void scalar(const char* key, const std::optional<Scalar>& value, const Plain&) {
    if (value) object.set(key, value_of_scalar(*value));
  }
  void scalars(const char* key, const std::vector<Scalar>& list, const Plain&) {
    if (list.empty()) return;
    Value entries = Value::list();
    for (const Scalar& scalar : list) entries.append(value_of_scalar(scalar));
    object.set(key, std::move(entries));
  }
  void mode_word(const char* key, const std::optional<int>& mode, const Plain&) {
    if (mode) object.set(key, fmt::format("mode {}", *mode));
  }
  void catalogue(const char* key, const Conductor& conductor, const Plain& spec) {
    text(key, conductor.catalogue, spec);
  }
  void conductor_file(const char* key, const Conductor& conductor, const Plain& spec) {
    text(key, conductor.file, spec);
  }

  void criteria(const char* key, Acceptance& acceptance, const Plain&) {
    if (acceptance.criteria.empty()) return;
    Value entries = Value::object();
    for (Criterion& criterion : acceptance.criteria) entries.set(criterion.path, write(criterion));
    object.set(key, std::move(entries));
  }

  template <class T>
  void table(const char* key, T& value, const Plain&) {
    object.set(key, write(value));
  }
  template <class T>
  void table(const char* key, std::optional<T>& value, const Plain&) {
    if (value) object.set(key, write(*value));
  }
  template <class T>
  void tables(const char* key, std::vector<T>& list, const Plain&) {
    if (list.empty()) return;
    Value entries = Value::list();
    for (T& value : list) entries.append(write(value));
    object.set(key, std::move(entries));
  }

  void one_of(std::initializer_list<const char*>, const OneOf&) {}

  template <class... Kinds>
  void kinds(const char* key, std::variant<Kinds...>& value, const Plain&) {
    std::visit(
        [&](auto& kind) {
          object.set(key, kind.word);
          keys(*this, kind);
        },
        value);
  }

  template <class E, class Keys>
  void when(const char*, const E& value, std::initializer_list<E> wanted, Keys write_keys) {
    for (const E choice : wanted) {
      if (choice == value) write_keys();
    }
  }

  template <class T>
  static Value write(T& value) {
    Echo echo;
    keys(echo, value);
    return std::move(echo.object);
  }
};

}  // namespace

results::Value case_as_run(const Scene& scene) {
  Scene copy = scene;  // the declarations of the keys bind to what a reader may fill
  return Echo::write(copy);
}

}  // namespace strandyn::casefile
