#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cctype>
#include <initializer_list>
#include <string>
#include <type_traits>
#include <vector>

#include "keys.hpp"
#include "plain_number.hpp"
#include "strandyn/casefile/schema.hpp"

namespace strandyn::casefile {
namespace {

/// A cell of a Markdown table.
std::string cell(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    if (c == '|') safe += '\\';
    safe += c;
  }
  return safe;
}

std::string words_of(double x) {
  return fmt::format("{:.12g}", plain_number(x));
}

std::string range_of(const Number& number) {
  std::vector<std::string> parts;
  if (number.above) parts.push_back(fmt::format("above {}", words_of(*number.above)));
  if (number.at_least) parts.push_back(fmt::format("from {}", words_of(*number.at_least)));
  if (number.below) parts.push_back(fmt::format("below {}", words_of(*number.below)));
  if (number.at_most) parts.push_back(fmt::format("to {}", words_of(*number.at_most)));
  if (number.not_zero) parts.emplace_back("not 0");
  if (number.multiple_of > 0) parts.push_back(fmt::format("a multiple of {}", number.multiple_of));
  return fmt::format("{}", fmt::join(parts, ", "));
}

template <class E>
std::string names_of() {
  std::string names;
  for (const auto& named : choices<E>) names += fmt::format("{}`\"{}\"`", names.empty() ? "" : ", ", named.name);
  return names;
}

/// The visitor that describes one table and, behind it, the tables in it. Defaults are read off a fresh struct.
class KeyLister {
 public:
  explicit KeyLister(std::string path) : path_(std::move(path)) {}

  void number(const char* key, double value, const Number& spec) {
    add(key, describe(spec), spec.required ? "" : words_of(spec.unit.from_si(value)), range_of(spec), spec.required);
  }
  void number(const char* key, int value, const Number& spec) {
    add(key, describe(spec), spec.required ? "" : fmt::format("{}", value), range_of(spec), spec.required);
  }
  template <class T>
  void number(const char* key, const std::optional<T>&, const Number& spec) {
    std::string otherwise;
    if (spec.otherwise) otherwise = words_of(*spec.otherwise);
    if (spec.word) otherwise = fmt::format("\"{}\"", spec.word);
    add(key, describe(spec), otherwise, range_of(spec), spec.required);
  }
  void numbers(const char* key, const std::vector<double>&, const Number& spec) {
    add(key, describe(spec), "", range_of(spec), spec.required);
  }
  void vector(const char* key, const std::optional<Vector3>&, const Plain& spec) { add(key, spec, "", "[x, y, z]"); }
  template <std::size_t N>
  void rows(const char* key, const std::vector<std::array<double, N>>&, const std::array<Number, N>& columns,
            const Plain& spec) {
    std::vector<std::string> names;
    for (const Number& column : columns) names.push_back(describe(column));
    add(key, spec, "", fmt::format("rows of [{}]", fmt::join(names, ", ")));
  }
  template <class E>
  void choice(const char* key, const E& value, const Plain& spec) {
    const bool has_default = !spec.required && !spec.depends;
    add(key, spec, has_default ? fmt::format("\"{}\"", name_of(value)) : "", names_of<E>());
  }
  template <class E>
  void choice(const char* key, const std::optional<E>&, const Plain& spec) {
    add(key, spec, "", names_of<E>());
  }
  template <class T>
  void text(const char* key, const T&, const Plain& spec) {
    add(key, spec, "", "words");
  }
  void flag(const char* key, bool value, const Plain& spec) { add(key, spec, value ? "true" : "false", "true, false"); }
  void flag(const char* key, const std::optional<bool>&, const Plain& spec) { add(key, spec, "", "true, false"); }
  void scalar(const char* key, const std::optional<Scalar>&, const Plain& spec) {
    add(key, spec, "", "a number, a word, true or false");
  }
  void scalars(const char* key, const std::vector<Scalar>&, const Plain& spec) {
    add(key, spec, "", "a list of values");
  }
  void mode_word(const char* key, const std::optional<int>&, const Plain& spec) { add(key, spec, "", "\"mode 12\""); }
  void catalogue(const char* key, const Conductor&, const Plain& spec) { add(key, spec, "", "a name"); }
  void conductor_file(const char* key, const Conductor&, const Plain& spec) { add(key, spec, "", "a file"); }

  void criteria(const char* key, Acceptance&, const Plain& spec) {
    Criterion fresh{};
    inner(fmt::format("[{}] \"path.into.summary\" = {{ ... }}", below(key)), below(key), spec, fresh);
  }
  template <class T>
  void table(const char* key, T&, const Plain& spec) {
    T fresh{};
    inner(fmt::format("[{}]", below(key)), below(key), spec, fresh);
  }
  template <class T>
  void table(const char* key, std::optional<T>&, const Plain& spec) {
    T fresh{};
    inner(fmt::format("[{}]", below(key)), below(key), spec, fresh);
  }
  template <class T>
  void tables(const char* key, std::vector<T>&, const Plain& spec) {
    T fresh{};
    inner(fmt::format("[[{}]]", below(key)), below(key), spec, fresh);
  }

  void one_of(std::initializer_list<const char*> group, const OneOf& spec) {
    notes_ += fmt::format("{} of `{}`.\n", spec.required ? "Exactly one" : "At most one", fmt::join(group, "`, `"));
  }

  template <class... Kinds>
  void kinds(const char* key, const std::variant<Kinds...>&, const Plain& spec) {
    std::string names;
    ((names += fmt::format("{}`\"{}\"`", names.empty() ? "" : ", ", Kinds::word)), ...);
    add(key, spec.help, "", names, spec.required);
    (write_kind<Kinds>(key), ...);
  }
  template <class E, class Keys>
  void when(const char* selector, const E&, std::initializer_list<E> wanted, Keys write_keys) {
    std::vector<std::string> names;
    for (const E choice : wanted) names.push_back(fmt::format("\"{}\"", name_of(choice)));
    const std::string before = std::move(condition_);
    condition_ = fmt::format(" (with {} = {})", selector, fmt::join(names, " or "));
    write_keys();
    condition_ = before;
  }

  /// The table and what is in it.
  std::string text_of(const std::string& heading, const std::string& help) const {
    std::string text = heading.empty() ? "" : fmt::format("\n## {}\n\n{}.\n", heading, capital(help));
    if (!notes_.empty()) text += "\n" + notes_;
    if (!lines_.empty()) text += "\n| key | what it is | default | range |\n| --- | --- | --- | --- |\n" + lines_;
    return text + inner_;
  }

 private:
  static std::string capital(std::string text) {
    if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    return text;
  }
  std::string below(const char* key) const { return path_.empty() ? key : path_ + "." + key; }
  void add(const char* key, const std::string& help, const std::string& otherwise, const std::string& range,
           bool required) {
    lines_ += fmt::format("| `{}` | {}{} | {} | {} |\n", key, cell(help), condition_, required ? "required" : otherwise,
                          cell(range));
  }
  void add(const char* key, const Plain& spec, const std::string& otherwise, const std::string& range) {
    add(key, spec.help, otherwise, range, spec.required);
  }
  template <class T>
  void inner(const std::string& heading, const std::string& path, const Plain& spec, T& fresh) {
    const char* told = std::is_same_v<T, Conductor> ? "conductor" : std::is_same_v<T, DamperKeys> ? "damper" : nullptr;
    if (told && path != told) {
      inner_ += fmt::format("\n## `{}`\n\n{}: keys as in `[{}]`.\n", heading, capital(spec.help), told);
      return;
    }
    KeyLister lister(path);
    keys(lister, fresh);
    inner_ += lister.text_of(fmt::format("`{}`", heading), spec.help);
  }
  template <class Kind>
  void write_kind(const char* selector) {
    KeyLister lister(path_);
    Kind fresh{};
    keys(lister, fresh);
    inner_ +=
        lister.text_of(fmt::format("`[{}]` with {} = \"{}\"", path_, selector, Kind::word), "keys of this analysis");
  }

  std::string path_, condition_, notes_, lines_, inner_;
};

}  // namespace

std::string key_reference() {
  KeyLister lister("");
  Scene scene;
  keys(lister, scene);
  return "# Keys of a case file\n\n`strandyn schema --keys` prints this page. The unit stands in the name of a key; "
         "what is "
         "absent takes its default, an unknown key is an error.\n\n## The file\n" +
         lister.text_of("", "");
}

}  // namespace strandyn::casefile
