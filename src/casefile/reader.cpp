#include "reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <system_error>

#include "document.hpp"
#include "strandyn/conductor/catalogue.hpp"
#include "strandyn/core/error.hpp"
#include "strandyn/core/near_words.hpp"
#include "text_file.hpp"

namespace strandyn::casefile {

std::string Reader::table_remedy(const char* key, const Plain& spec) {
  return fmt::format("give the table `{}`: {}", key, spec.help);
}

std::string Reader::choice_remedy(const Plain& spec, const std::vector<std::string>& names) {
  return fmt::format("choose one of {} ({})", list_words(names, '"'), spec.help);
}

std::string Reader::path_of(std::string_view key) const {
  return path_.empty() ? spell_key(key) : fmt::format("{}.{}", path_, spell_key(key));
}

bool Reader::overridden(std::string_view key) const {
  const Source::Entry* entry = source_.find(path_of(key));
  return entry && entry->overridden;
}

bool Reader::given(const char* key, const OneOf& spec) const {
  const toml::node* node = table_.get(key);
  return node && (spec.false_counts || node->value_exact<bool>() != false);
}

const toml::node* Reader::under_either_name(const char* key, const char* old_name) const {
  const toml::node* node = table_.get(key);
  const toml::node* old = old_name ? table_.get(old_name) : nullptr;
  if (!old) return node;
  if (node && overridden(key) == overridden(old_name)) {
    refuse(source_, path_of(old_name), fmt::format("is the old name of `{}`, and both are given", path_of(key)),
           "remove one of the two");
  }
  if (node && overridden(key)) return node;
  findings_.notes.push_back(
      fmt::format("{}: `{}` is now called `{}`", source_.place(path_of(old_name)), path_of(old_name), path_of(key)));
  return old;
}

const toml::node* Reader::take(const char* key, bool required, const std::string& remedy, const char* old_name) {
  if (mode_ == Mode::list) {
    if (std::ranges::find(known_, key) == known_.end()) known_.emplace_back(key);
    if (old_name) old_names_.emplace_back(old_name);
    return nullptr;
  }
  if (mode_ == Mode::skip) {
    for (const char* name : {key, old_name}) {
      if (!name) continue;
      Choices& choices_of_key = elsewhere_[name];
      choices_of_key.selector = skipped_.selector;
      choices_of_key.chosen = skipped_.chosen;
      choices_of_key.names.insert(choices_of_key.names.end(), skipped_.names.begin(), skipped_.names.end());
    }
    return nullptr;
  }
  taken_.insert(key);
  if (old_name) taken_.insert(old_name);
  if (displaced_.contains(key)) return nullptr;
  const toml::node* node = under_either_name(key, old_name);
  if (!node && required && !refused_.contains(key)) refuse(source_, path_of(key), "is missing", remedy);
  return node;
}

void Reader::refuse_unknown_keys() {
  for (const auto& [key, node] : table_) {
    if (std::ranges::find(known_, key.str()) != known_.end()) continue;
    if (std::ranges::find(old_names_, key.str()) != old_names_.end()) continue;
    const std::string path = path_of(key.str());
    const auto near = near_word(key.str(), known_);
    const std::string remedy =
        near ? fmt::format("did you mean `{}`?", path_of(*near))
             : fmt::format("{} knows {}", path_.empty() ? "a case" : '`' + path_ + '`', list_words(known_));
    const char* kind = path_.empty() && !node.is_value() ? "table" : "key";
    attempt(near ? near->c_str() : "",
            [&] { throw InputError(fmt::format("{}: unknown {} `{}`; {}", source_.place(path), kind, path, remedy)); });
  }
}

void Reader::refuse_keys_of_other_choices() {
  for (const auto& [key, node] : table_) {
    const auto entry = elsewhere_.find(key.str());
    if (entry == elsewhere_.end() || taken_.contains(key.str())) continue;
    const Choices& other = entry->second;
    if (refused_.contains(other.selector)) continue;
    if (overridden(other.selector) && !overridden(key.str())) continue;
    attempt(other.selector.c_str(), [&, name = std::string(key.str())] {
      refuse(source_, path_of(name),
             fmt::format("belongs to {} = {}, and {} is \"{}\" here", other.selector, list_words(other.names, '"'),
                         other.selector, other.chosen),
             fmt::format("remove it or change `{}`", path_of(other.selector)));
    });
  }
}

void Reader::one_of(std::initializer_list<const char*> group, const OneOf& spec) {
  if (mode_ != Mode::read) return;
  std::vector<std::string> present, from_override;
  for (const char* key : group) {
    if (!given(key, spec)) continue;
    present.emplace_back(key);
    if (overridden(key)) from_override.emplace_back(key);
  }
  if (!from_override.empty() && from_override.size() < present.size()) {
    for (const std::string& key : present) {
      if (!overridden(key)) displaced_.insert(key);
    }
    present = from_override;
  }
  const std::vector<std::string> names(group.begin(), group.end());
  const bool misspelt = std::ranges::any_of(names, [&](const std::string& name) { return refused_.contains(name); });
  attempt(names.front().c_str(), [&] {
    if (present.size() > 1) {
      refuse(source_, path_of(present[1]), fmt::format("excludes `{}`, and both are given", path_of(present[0])),
             fmt::format("keep one of {}", list_words(names)));
    }
    if (present.empty() && spec.required && !misspelt) {
      const std::string table = path_.empty() ? "the case" : path_;
      throw InputError(fmt::format("{}: {}: one of {} is missing; give exactly one of them", source_.place(path_),
                                   table, list_words(names)));
    }
  });
}

std::optional<std::string> Reader::read_number(const toml::node& node, const Number& spec, double& x) {
  if (!node.is_number()) return spec.whole ? "must be a whole number" : "must be a number";
  x = node.is_integer() ? static_cast<double>(node.as_integer()->get()) : node.as_floating_point()->get();
  if (auto fault = find_fault(spec, x)) return fault;
  x = spec.unit.to_si(x);
  return std::nullopt;
}

void Reader::numbers(const char* key, std::vector<double>& field, const Number& spec) {
  attempt(key, [&] {
    const toml::node* node = take(key, spec.required, "give " + describe(spec));
    if (!node) return;
    const std::string path = path_of(key);
    field.clear();
    const toml::array* list = node->as_array();
    if (!list) {
      field.push_back(to_number(*node, path, spec));
      return;
    }
    if (list->empty()) refuse(source_, path, "must not be empty", "give " + describe(spec));
    for (const toml::node& element : *list) field.push_back(to_number(element, path + index(field.size()), spec));
  });
}

void Reader::vector(const char* key, std::optional<Vector3>& field, const Plain& spec) {
  attempt(key, [&] {
    const toml::node* node = take(key, spec.required, std::string("give ") + spec.help);
    if (!node) return;
    const std::string path = path_of(key);
    const toml::array* list = node->as_array();
    if (!list || list->size() != 3) {
      refuse(source_, path, "must be three numbers", std::string("give ") + spec.help + ", for example [0, 1, 0]");
    }
    field.emplace();
    for (std::size_t i = 0; i < 3; ++i)
      (*field)[i] = to_number(*list->get(i), path + index(i), {.help = "a component"});
  });
}

std::vector<const toml::array*> Reader::to_rows(const toml::node& node, const std::string& path, std::size_t columns,
                                                const Plain& spec) const {
  const std::string remedy = fmt::format("give {}", spec.help);
  const std::string wrong = fmt::format("must be a list of rows of {} numbers", columns);
  const toml::array* list = node.as_array();
  if (!list || list->empty()) refuse(source_, path, wrong, remedy);
  std::vector<const toml::array*> rows;
  for (const toml::node& element : *list) {
    const toml::array* row = element.as_array();
    if (!row || row->size() != columns) {
      refuse(source_, path + index(rows.size()), fmt::format("must be a row of {} numbers", columns), remedy);
    }
    rows.push_back(row);
  }
  return rows;
}

std::string Reader::to_text(const toml::node& node, const std::string& path, const Plain& spec) const {
  const auto text = node.value_exact<std::string>();
  if (!text) refuse(source_, path, "must be a text", fmt::format("give {} in quotes", spec.help));
  if (text->find_first_not_of(" \t\n") == std::string::npos) {
    refuse(source_, path, "must not be empty", fmt::format("give {}", spec.help));
  }
  return *text;
}

bool Reader::to_flag(const toml::node& node, const std::string& path, const Plain& spec) const {
  const auto flag = node.value_exact<bool>();
  if (!flag) refuse(source_, path, "must be true or false", fmt::format("say {}, without quotes", spec.help));
  return *flag;
}

std::string Reader::to_choice(const toml::node& node, const std::string& path, const Plain& spec,
                              const std::vector<std::string>& names) const {
  const auto word = node.value_exact<std::string>();
  if (!word) refuse(source_, path, "must be a word in quotes", choice_remedy(spec, names));
  if (std::ranges::find(names, *word) == names.end()) {
    refuse(source_, path, "is not a choice", choice_remedy(spec, nearest_first(*word, names)));
  }
  return *word;
}

const toml::table& Reader::to_table(const toml::node& node, const std::string& path) const {
  const toml::table* table = node.as_table();
  if (!table) refuse(source_, path, "must be a table", fmt::format("write [{}] and its keys below", path));
  return *table;
}

std::vector<const toml::table*> Reader::to_tables(const toml::node& node, const std::string& path) const {
  const toml::array* list = node.as_array();
  if (!list || list->empty() || !list->is_array_of_tables()) {
    refuse(source_, path, "must be a list of tables", fmt::format("write [[{}]] above the keys of each", path));
  }
  std::vector<const toml::table*> tables;
  for (const toml::node& element : *list) tables.push_back(element.as_table());
  return tables;
}

Scalar Reader::to_scalar(const toml::node& node, const std::string& path, const Plain& spec) const {
  if (const auto flag = node.value_exact<bool>()) return *flag;
  if (node.is_string()) return to_text(node, path, spec);
  return to_number(node, path, {.help = spec.help});
}

void Reader::scalar(const char* key, std::optional<Scalar>& field, const Plain& spec) {
  attempt(key, [&] {
    const toml::node* node = take(key, spec.required, std::string("give ") + spec.help);
    if (node) field = to_scalar(*node, path_of(key), spec);
  });
}

void Reader::scalars(const char* key, std::vector<Scalar>& field, const Plain& spec) {
  attempt(key, [&] {
    const toml::node* node = take(key, spec.required, std::string("give ") + spec.help);
    if (!node) return;
    const std::string path = path_of(key);
    const toml::array* list = node->as_array();
    if (!list || list->empty()) refuse(source_, path, "must be a list", std::string("give ") + spec.help);
    field.clear();
    for (const toml::node& element : *list) field.push_back(to_scalar(element, path + index(field.size()), spec));
  });
}

void Reader::mode_word(const char* key, std::optional<int>& field, const Plain& spec) {
  attempt(key, [&] {
    const toml::node* node = take(key, spec.required, std::string("give ") + spec.help);
    if (!node) return;
    const std::string word = node->value_exact<std::string>().value_or("");
    constexpr std::string_view start = "mode ";
    int mode = 0;
    if (word.starts_with(start)) {
      const char* end = word.data() + word.size();
      const auto [stop, error] = std::from_chars(word.data() + start.size(), end, mode);
      if (error != std::errc{} || stop != end) mode = 0;
    }
    if (mode < 1) {
      refuse(source_, path_of(key), "must be \"mode \" and a number of at least 1",
             fmt::format("write {} = \"mode 12\", or frequency_Hz = 24 for a frequency in hertz", key));
    }
    field = mode;
  });
}

void Reader::displace_own_conductor(const char* key) {
  if (!overridden(key)) return;
  for (const char* own : {"title", "source", "mass_kg_per_m", "rated_strength_kN"}) {
    if (!overridden(own)) displaced_.insert(own);
  }
}

void Reader::catalogue(const char* key, Conductor& field, const Plain& spec) {
  attempt(key, [&] {
    const toml::node* node = take(key, spec.required, std::string("give ") + spec.help);
    if (!node) return;
    const std::string name = to_text(*node, path_of(key), spec);
    const conductor::CatalogueEntry* entry = conductor::find_entry(name);
    if (!entry) {
      const conductor::CatalogueEntry* near = conductor::near_entry(name);
      const std::size_t count = conductor::catalogue().size();
      refuse(source_, path_of(key), "is not in the catalogue",
             near ? fmt::format("did you mean `{}`? `strandyn conductors` lists all {}", near->name, count)
                  : fmt::format("the catalogue holds {} conductors, `strandyn conductors` lists them", count));
    }
    displace_own_conductor(key);
    const Document document = parse_document(entry->text, fmt::format("catalogue `{}`", entry->name), {});
    Reader(document.source, document.root, "", findings_).read(field);
    field.catalogue = entry->name;
  });
}

void Reader::conductor_file(const char* key, Conductor& field, const Plain& spec) {
  attempt(key, [&] {
    const toml::node* node = take(key, spec.required, std::string("give ") + spec.help);
    if (!node) return;
    const std::string name = to_text(*node, path_of(key), spec);
    const std::filesystem::path beside = std::filesystem::path(source_.file).parent_path();
    const std::filesystem::path path = beside / name;
    std::error_code status;
    if (!std::filesystem::is_regular_file(path, status)) {
      throw FileError(
          fmt::format("{}: {} = \"{}\": there is no file {}; give the name of a file with a [conductor] "
                      "table, as seen from the folder of the case",
                      source_.place(path_of(key)), path_of(key), name, path.string()));
    }
    displace_own_conductor(key);
    Document document = parse_document(read_text(path), path.string(), {});
    const toml::table* own = document.root["conductor"].as_table();
    const std::string table = own ? "conductor" : "";
    const toml::table& root = own ? *own : document.root;
    if (own && document.root.size() > 1) {
      throw InputError(
          fmt::format("{}:1:1: holds more than the table [conductor]; leave only that one", path.string()));
    }
    if (root.contains("file")) {
      refuse(document.source, own ? "conductor.file" : "file", "is a file that names another file",
             "write the layers here, or name a conductor of the catalogue");
    }
    Reader(document.source, root, table, findings_).read(field);
    // What is wrong with the layers together is found later, and told with the places of this file.
    for (auto& [path_there, entry] : document.source.entries) {
      findings_.places.emplace(own ? path_there : fmt::format("{}.{}", path_, path_there), entry);
    }
    field.file = name;
  });
}

void Reader::criteria(const char* key, Acceptance& field, const Plain& spec) {
  attempt(key, [&] {
    const toml::node* node = take(key, spec.required, table_remedy(key, spec));
    if (!node) return;
    for (const auto& [quantity, entry] : to_table(*node, path_of(key))) {
      const std::string path = fmt::format("{}.{}", path_of(key), spell_key(quantity.str()));
      const toml::table* table = entry.as_table();
      const bool nested = table && !table->empty() &&
                          std::ranges::all_of(*table, [](const auto& child) { return child.second.is_table(); });
      if (!table || nested) {
        refuse(source_, path, nested ? "is a path without quotes" : "must be a table",
               "write \"steady.damping_ratio\" = { below = 0.05, reason = \"...\" }, the path in quotes");
      }
      Criterion& criterion = field.criteria.emplace_back();
      criterion.path = quantity.str();
      Reader(source_, *table, path, findings_).read(criterion);
    }
  });
}

}  // namespace strandyn::casefile
