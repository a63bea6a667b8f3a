#include "slips.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "strandyn/core/near_words.hpp"

namespace strandyn::app {
namespace {

std::vector<std::string> options_of(const CLI::App& verb) {
  std::vector<std::string> names;
  for (const CLI::Option* option : verb.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

std::vector<std::string> verbs_of(const CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::App* verb : program.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(verb->get_name());
  }
  return names;
}

std::string near_or_all(const std::string& word, const std::vector<std::string>& known, const char* all) {
  const auto near = near_word(word, known);
  return near ? fmt::format("did you mean `{}`?", *near) : fmt::format("{} {}", all, list_words(known));
}

}  // namespace

std::optional<std::string> find_slip(const CLI::App& program, int argc, const char* const* argv) {
  const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  const auto first = std::ranges::find_if(words, [](const std::string& word) { return !word.starts_with('-'); });
  if (first == words.end()) return std::nullopt;
  const std::vector<std::string> verbs = verbs_of(program);
  if (std::ranges::find(verbs, *first) == verbs.end()) {
    return fmt::format("there is no verb `{}`; {}", *first, near_or_all(*first, verbs, "the verbs are"));
  }
  const CLI::App& verb = *program.get_subcommand(*first);
  const std::vector<std::string> known = options_of(verb);
  for (auto word = first + 1; word != words.end(); ++word) {
    const std::string option = word->substr(0, word->find('='));
    if (!option.starts_with("--") || option == "--") continue;
    const CLI::Option* before = verb.get_option_no_throw(*(word - 1));
    const bool argument = before && before->get_items_expected_max() > 0;
    if (argument || std::ranges::find(known, option) != known.end()) continue;
    return fmt::format("`{}` has no option `{}`; {}", *first, option, near_or_all(option, known, "it knows"));
  }
  return std::nullopt;
}

}  // namespace strandyn::app
