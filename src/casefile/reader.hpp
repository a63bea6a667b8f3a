#pragma once
/// \file The visitor that reads one table of TOML into its struct and refuses what is wrong with it.

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <initializer_list>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "keys.hpp"
#include "refusals.hpp"
#include "strandyn/casefile/source.hpp"

namespace strandyn::casefile {

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;

/// T of T and of std::optional<T>.
template <class T>
struct ValueOf {
  using type = T;
};
template <class T>
struct ValueOf<std::optional<T>> {
  using type = T;
};
template <class T>
using value_of = typename ValueOf<T>::type;

/// What the readers of a case and of its tables find.
struct Findings {
  std::vector<std::string> notes;  ///< of old names that are used
  Refusals refusals;               ///< of keys; a key that is refused keeps the reader from no other
  std::map<std::string, Source::Entry, std::less<>> places;  ///< of the keys of a conductor's own file
};

class Reader {
 public:
  /// `path` is the key path of the table, empty for the whole file.
  Reader(const Source& source, const toml::table& table, std::string path, Findings& findings)
      : source_(source), table_(table), path_(std::move(path)), findings_(findings) {}

  /// Reads the table: first which keys it knows, so that a slip of the pen is named before what it leaves missing.
  template <class T>
  void read(T& field) {
    mode_ = Mode::list;
    T probe{};
    keys(*this, probe);
    refuse_unknown_keys();
    mode_ = Mode::read;
    keys(*this, field);
    refuse_keys_of_other_choices();
  }

  template <class T>
  void number(const char* key, T& field, Number spec) {
    spec.whole = std::is_same_v<value_of<T>, int>;
    attempt(key, [&] {
      const toml::node* node = take(key, spec.required, "give " + describe(spec));
      if (!node) return;
      if constexpr (is_optional<T>) {
        if (spec.word && node->value<std::string>() == spec.word) {
          field.reset();
          return;
        }
      }
      field = static_cast<value_of<T>>(to_number(*node, path_of(key), spec));
    });
  }

  /// A list, or a single number for a list of one.
  void numbers(const char* key, std::vector<double>& field, const Number& spec);

  void vector(const char* key, std::optional<Vector3>& field, const Plain& spec);

  template <std::size_t N>
  void rows(const char* key, std::vector<std::array<double, N>>& field, const std::array<Number, N>& columns,
            const Plain& spec) {
    attempt(key, [&] {
      const toml::node* node = take(key, spec.required, "give " + std::string(spec.help));
      if (!node) return;
      const std::string path = path_of(key);
      field.clear();
      for (const toml::array* row : to_rows(*node, path, N, spec)) {
        const std::size_t i = field.size();
        std::array<double, N>& values = field.emplace_back();
        for (std::size_t j = 0; j < N; ++j) {
          values[j] = to_number(
              *row->get(j), [&] { return path + index(i) + index(j); }, columns[j]);
        }
      }
    });
  }

  template <class T>
  void choice(const char* key, T& field, const Plain& spec) {
    using E = value_of<T>;
    std::vector<std::string> names;
    for (const auto& named : choices<E>) names.emplace_back(named.name);
    attempt(key, [&] {
      const toml::node* node = take(key, spec.required, choice_remedy(spec, names), spec.old_name);
      if (!node) return;
      const bool by_old_name = spec.old_name && table_.get(spec.old_name) == node;
      const std::string word = to_choice(*node, path_of(by_old_name ? spec.old_name : key), spec, names);
      for (const auto& named : choices<E>) {
        if (named.name == word) field = named.value;
      }
    });
  }

  template <class T>
  void text(const char* key, T& field, const Plain& spec) {
    attempt(key, [&] {
      if (const toml::node* node = take(key, spec.required, "give " + std::string(spec.help) + " in quotes")) {
        field = to_text(*node, path_of(key), spec);
      }
    });
  }

  template <class T>
  void flag(const char* key, T& field, const Plain& spec) {
    attempt(key, [&] {
      if (const toml::node* node = take(key, spec.required, "give true or false")) {
        field = to_flag(*node, path_of(key), spec);
      }
    });
  }

  void scalar(const char* key, std::optional<Scalar>& field, const Plain& spec);
  void scalars(const char* key, std::vector<Scalar>& field, const Plain& spec);
  void mode_word(const char* key, std::optional<int>& field, const Plain& spec);
  /// Reads the entry of the catalogue, or the file beside the case, into `field`; the keys that follow lie on top of
  /// it.
  void catalogue(const char* key, Conductor& field, const Plain& spec);
  void conductor_file(const char* key, Conductor& field, const Plain& spec);
  void criteria(const char* key, Acceptance& field, const Plain& spec);

  template <class T>
  void table(const char* key, T& field, const Plain& spec) {
    attempt(key, [&] {
      const toml::node* node = take(key, spec.required, table_remedy(key, spec));
      if (!node) return;
      if constexpr (is_optional<T>) {
        Reader(source_, to_table(*node, path_of(key)), path_of(key), findings_).read(field.emplace());
      } else {
        Reader(source_, to_table(*node, path_of(key)), path_of(key), findings_).read(field);
      }
    });
  }

  template <class T>
  void tables(const char* key, std::vector<T>& field, const Plain& spec) {
    attempt(key, [&] {
      const toml::node* node = take(key, spec.required, table_remedy(key, spec));
      if (!node) return;
      field.clear();
      for (const toml::table* element : to_tables(*node, path_of(key))) {
        const std::string path = path_of(key) + index(field.size());
        Reader(source_, *element, path, findings_).read(field.emplace_back());
      }
    });
  }

  void one_of(std::initializer_list<const char*> group, const OneOf& spec);

  /// One of several kinds of a table: the word under `key` chooses it, and its keys follow.
  template <class... Kinds>
  void kinds(const char* key, std::variant<Kinds...>& field, const Plain& spec) {
    const std::vector<std::string> names = {std::string(Kinds::word)...};
    std::string chosen;  // none of them where the word is refused
    attempt(key, [&] {
      const toml::node* node = take(key, spec.required, choice_remedy(spec, names));
      chosen = node ? to_choice(*node, path_of(key), spec, names) : names.front();
    });
    (read_kind<Kinds>(key, chosen, field), ...);
  }

  template <class E, class Keys>
  void when(const char* selector, const E& value, std::initializer_list<E> wanted, Keys read_keys) {
    const Mode before = mode_;
    if (mode_ == Mode::read) {
      bool chosen = false;
      for (const E choice : wanted) chosen = chosen || choice == value;
      chosen = chosen && !refused_.contains(selector);
      if (!chosen) {
        mode_ = Mode::skip;
        skipped_ = {selector, std::string(name_of(value)), {}};
        for (const E choice : wanted) skipped_.names.emplace_back(name_of(choice));
      }
    }
    read_keys();
    mode_ = before;
  }

 private:
  /// list: note which keys exist; read; skip: note the keys of a choice that was not made.
  enum class Mode { list, read, skip };

  /// The choices that a key belongs to, and the one that was made instead.
  struct Choices {
    std::string selector;
    std::string chosen;
    std::vector<std::string> names;
  };

  /// Reads a key; what is refused of it is told with all the rest at the end.
  template <class Read>
  void attempt(const char* key, Read read_key) {
    if (!findings_.refusals.hold(read_key)) refused_.insert(key);
  }

  template <class Kind, class Variant>
  void read_kind(const char* selector, const std::string& chosen, Variant& field) {
    const Mode before = mode_;
    const bool here = chosen == Kind::word;
    if (mode_ == Mode::read && !here) {
      mode_ = Mode::skip;
      skipped_ = {selector, chosen, {std::string(Kind::word)}};
    }
    Kind kind{};
    keys(*this, kind);
    if (before == Mode::read && here) field = std::move(kind);
    mode_ = before;
  }

  static std::string index(std::size_t i) { return fmt::format("[{}]", i); }
  static std::string table_remedy(const char* key, const Plain& spec);
  static std::string choice_remedy(const Plain& spec, const std::vector<std::string>& names);

  std::string path_of(std::string_view key) const;
  bool overridden(std::string_view key) const;
  /// Whether the file or an override gives the key.
  bool given(const char* key, const OneOf& spec) const;

  /// The node to read for a key, or nothing; refuses the absence of a required key.
  const toml::node* take(const char* key, bool required, const std::string& remedy, const char* old_name = nullptr);
  /// The node under either name; an override wins over the file, and two of a kind are refused.
  const toml::node* under_either_name(const char* key, const char* old_name) const;
  void refuse_unknown_keys();
  void refuse_keys_of_other_choices();
  /// What the file says of its own conductor is not said of one that the command line puts in its place.
  void displace_own_conductor(const char* key);

  /// `path` is made only where the number is refused: a table may have a hundred thousand rows.
  template <class Path>
  double to_number(const toml::node& node, const Path& path, const Number& spec) const {
    double x = 0;
    const auto fault = read_number(node, spec, x);
    if (!fault) return x;
    if constexpr (std::is_invocable_v<Path>) {
      refuse(source_, path(), *fault, "give " + describe(spec));
    } else {
      refuse(source_, path, *fault, "give " + describe(spec));
    }
  }
  /// In SI, or what is wrong with it.
  static std::optional<std::string> read_number(const toml::node& node, const Number& spec, double& x);
  Scalar to_scalar(const toml::node& node, const std::string& path, const Plain& spec) const;
  std::string to_text(const toml::node& node, const std::string& path, const Plain& spec) const;
  bool to_flag(const toml::node& node, const std::string& path, const Plain& spec) const;
  std::string to_choice(const toml::node& node, const std::string& path, const Plain& spec,
                        const std::vector<std::string>& names) const;
  std::vector<const toml::array*> to_rows(const toml::node& node, const std::string& path, std::size_t columns,
                                          const Plain& spec) const;
  const toml::table& to_table(const toml::node& node, const std::string& path) const;
  std::vector<const toml::table*> to_tables(const toml::node& node, const std::string& path) const;

  const Source& source_;
  const toml::table& table_;
  std::string path_;
  Findings& findings_;
  Mode mode_ = Mode::read;
  std::vector<std::string> known_;
  std::vector<std::string> old_names_;
  std::set<std::string, std::less<>> taken_;
  std::set<std::string, std::less<>> displaced_;  ///< keys of the file that an override excludes
  std::set<std::string, std::less<>> refused_;    ///< keys that were refused, or misspelt: they are not also missing
  Choices skipped_;
  std::map<std::string, Choices, std::less<>> elsewhere_;
};

}  // namespace strandyn::casefile
