#include "completion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "strandyn/conductor/catalogue.hpp"
#include "strandyn/core/error.hpp"
#include "strandyn/core/near_words.hpp"

namespace strandyn::app {
namespace {

struct OptionLine {
  std::string name;  ///< "--json"
  std::string help;
  bool takes = false;  ///< an argument
};

struct Verb {
  std::string name, help;
  std::vector<OptionLine> options;
  bool of_conductors = false;  ///< its arguments are names of the catalogue, else files
};

std::vector<OptionLine> options_of(const CLI::App& app) {
  std::vector<OptionLine> lines;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) {
      lines.push_back({"--" + name, option->get_description(), option->get_items_expected_max() > 0});
    }
  }
  return lines;
}

std::vector<Verb> verbs_of(const CLI::App& program) {
  std::vector<Verb> verbs;
  for (const CLI::App* app : program.get_subcommands([](const CLI::App*) { return true; })) {
    verbs.push_back({.name = app->get_name(),
                     .help = app->get_description(),
                     .options = options_of(*app),
                     .of_conductors = app->get_name() == "conductors"});
  }
  return verbs;
}

/// Without what ends a word between single quotes.
std::string quoted(std::string text) {
  for (std::size_t i = text.find('\''); i != std::string::npos; i = text.find('\'', i + 4)) text.replace(i, 1, "'\\''");
  return '\'' + text + '\'';
}

std::string conductor_names() {
  std::string names;
  for (const conductor::CatalogueEntry& entry : conductor::catalogue()) {
    names += (names.empty() ? "" : " ") + std::string(entry.name);
  }
  return names;
}

std::string joined(const std::vector<OptionLine>& options) {
  std::string words;
  for (const OptionLine& option : options) words += (words.empty() ? "" : " ") + option.name;
  return words;
}

std::string for_bash(const CLI::App& program) {
  std::string verbs, cases;
  for (const Verb& verb : verbs_of(program)) {
    verbs += verb.name + ' ';
    cases += fmt::format("    {}) words={};{} ;;\n", verb.name, quoted(joined(verb.options)),
                         verb.of_conductors ? " names=" + quoted(conductor_names()) : "");
  }
  return fmt::format(
      "# bash completion of strandyn: source it, or put it into /etc/bash_completion.d\n"
      "_strandyn() {{\n"
      "  local word=${{COMP_WORDS[COMP_CWORD]}} words= names=\n"
      "  COMPREPLY=()\n"
      "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
      "    COMPREPLY=($(compgen -W {} -- \"$word\"))\n"
      "    return\n"
      "  fi\n"
      "  case ${{COMP_WORDS[1]}} in\n{}"
      "  esac\n"
      "  case $word in\n"
      "    -*) COMPREPLY=($(compgen -W \"$words\" -- \"$word\")) ;;\n"
      "    *) [ -n \"$names\" ] && COMPREPLY=($(compgen -W \"$names\" -- \"$word\")) ;;\n"
      "  esac\n"
      "}}\n"
      "complete -o default -F _strandyn strandyn\n",
      quoted(verbs + joined(options_of(program))), cases);
}

/// Of zsh's _arguments and _describe, where `:` and `[` separate.
std::string plain(std::string text) {
  std::replace(text.begin(), text.end(), ':', ';');
  std::replace(text.begin(), text.end(), '[', '(');
  std::replace(text.begin(), text.end(), ']', ')');
  return text;
}

std::string for_zsh(const CLI::App& program) {
  std::string verbs, cases;
  for (const Verb& verb : verbs_of(program)) {
    verbs += fmt::format("    {}\n", quoted(verb.name + ':' + plain(verb.help)));
    cases += fmt::format("    {})\n      _arguments", verb.name);
    for (const OptionLine& option : verb.options) {
      cases += fmt::format(" \\\n        {}", quoted(fmt::format("{}[{}]{}", option.name, plain(option.help),
                                                                 option.takes ? ":value:_files" : "")));
    }
    cases += fmt::format(" \\\n        {}\n      ;;\n",
                         quoted(verb.of_conductors ? "*:conductor:(" + conductor_names() + ')' : "*:file:_files"));
  }
  return fmt::format(
      "#compdef strandyn\n"
      "# zsh completion of strandyn: put it as _strandyn into a folder of $fpath\n"
      "_strandyn() {{\n"
      "  local -a verbs=(\n{}  )\n"
      "  if (( CURRENT == 2 )); then\n"
      "    _describe verb verbs\n"
      "    return\n"
      "  fi\n"
      "  local verb=$words[2]\n"
      "  shift words\n"
      "  (( CURRENT-- ))\n"
      "  case $verb in\n{}"
      "  esac\n"
      "}}\n"
      "if [ \"$funcstack[1]\" = _strandyn ]; then _strandyn \"$@\"; else compdef _strandyn strandyn; fi\n",
      verbs, cases);
}

std::string for_fish(const CLI::App& program) {
  std::string text = "# fish completion of strandyn: put it as strandyn.fish into ~/.config/fish/completions\n";
  for (const Verb& verb : verbs_of(program)) {
    text += fmt::format("complete -c strandyn -n __fish_use_subcommand -f -a {} -d {}\n", verb.name, quoted(verb.help));
    const std::string here = fmt::format("-n '__fish_seen_subcommand_from {}'", verb.name);
    for (const OptionLine& option : verb.options) {
      text += fmt::format("complete -c strandyn {} -l {}{} -d {}\n", here, option.name.substr(2),
                          option.takes ? " -r" : "", quoted(option.help));
    }
    if (verb.of_conductors) {
      text += fmt::format("complete -c strandyn {} -f -a {}\n", here, quoted(conductor_names()));
    }
  }
  return text;
}

/// A text for troff: no line of it is taken for a request, dashes stay as they are typed.
std::string troff(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    if (c == '-') {
      safe += "\\-";
    } else if (c == '\\') {
      safe += "\\e";
    } else {
      safe += c;
    }
  }
  return safe.starts_with('.') || safe.starts_with('\'') ? "\\&" + safe : safe;
}

/// "CASE.toml [--out TEXT] ..." of a verb.
std::string synopsis_of(const CLI::App& verb) {
  std::string text;
  for (const CLI::Option* option : verb.get_options()) {
    if (option->get_positional()) {
      const std::string name = option->get_name(true);
      text += ' ' + (option->get_required() ? name : '[' + name + ']');
    }
  }
  return text;
}

}  // namespace

std::string completion(const CLI::App& program, const std::string& shell) {
  if (shell == "bash") return for_bash(program);
  if (shell == "zsh") return for_zsh(program);
  if (shell == "fish") return for_fish(program);
  const auto near = near_word(shell, {"bash", "zsh", "fish"});
  throw InputError(fmt::format("there is no completion for `{}`; {}", shell,
                               near ? fmt::format("did you mean `{}`?", *near) : "give bash, zsh or fish"));
}

std::string manual(const CLI::App& program, const std::string& version) {
  std::string text = fmt::format(".TH STRANDYN 1 \"\" \"strandyn {}\" \"User Commands\"\n", troff(version));
  text += fmt::format(".SH NAME\nstrandyn \\- {}\n", troff(program.get_description()));
  text += ".SH SYNOPSIS\n.B strandyn\n.I VERB\n.RI [ ARGUMENTS ]\n.SH VERBS\n";
  for (const CLI::App* verb : program.get_subcommands([](const CLI::App*) { return true; })) {
    text += fmt::format(".SS strandyn {}{}\n{}\n", troff(verb->get_name()), troff(synopsis_of(*verb)),
                        troff(verb->get_description()));
    for (const CLI::Option* option : verb->get_options()) {
      const std::string name = option->get_positional() ? option->get_name(true) : option->get_name();
      const bool takes = !option->get_positional() && option->get_items_expected_max() > 0;
      text +=
          fmt::format(".TP\n.B {}{}\n{}\n", troff(name), takes ? " \\fI" + troff(option->get_type_name()) + "\\fR" : "",
                      troff(option->get_description()));
    }
  }
  text +=
      ".SH EXIT STATUS\n.TP\n.B 0\ndone\n.TP\n.B 2\nthe input is wrong\n.TP\n.B 3\nnot converged, or a bound or an "
      "acceptance of the case was broken\n.TP\n.B 4\na file could not be read or written\n.TP\n.B 130\ninterrupted; "
      "what "
      "was computed is kept\n";
  return text;
}

}  // namespace strandyn::app
