#include "toml_guard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace strandyn::casefile {
namespace {

/// Walks over a text as TOML does, as far as strings, comments and brackets go. What is wrong in any other way is left
/// to the library, which stops there: whatever is read behind such a place does no harm.
class Scan {
 public:
  explicit Scan(std::string_view text) : text_(text) {}

  std::optional<Unreadable> run() {
    while (i_ < text_.size() && !found_) step();
    return found_;
  }

 private:
  char at(std::size_t i) const { return i < text_.size() ? text_[i] : '\0'; }

  void step() {
    const char c = text_[i_];
    if (c == '\n') {
      ++i_;
      if (depth_ == 0) begins_ = true;
      parts_ = 1;
    } else if (c == ' ' || c == '\t' || c == '\r') {
      ++i_;
    } else if (c == '#') {
      i_ = std::min(text_.find('\n', i_), text_.size());
    } else if (c == '"' || c == '\'') {
      begins_ = false;
      skip_string(c);
    } else if (begins_ && c == '[') {
      begins_ = false;
      open_header();
    } else {
      begins_ = false;
      count(c);
      ++i_;
    }
  }

  void count(char c) {
    if (static_cast<unsigned char>(c) >= 0x80) {
      return refuse("a letter beyond a to z stands outside of quotes", "put it into quotes, or behind a #");
    }
    if (c == '.' && ++parts_ > most_key_parts) {
      return refuse(fmt::format("a key of more than {} parts", most_key_parts), "no key of a case is as long");
    }
    if (c == '=' || c == ',' || c == '[' || c == ']' || c == '{' || c == '}') parts_ = 1;
    if ((c == '[' || c == '{') && ++depth_ > most_levels) {
      return refuse(fmt::format("more than {} levels of brackets", most_levels), "no key of a case goes as deep");
    }
    if ((c == ']' || c == '}') && depth_ > 0) --depth_;
  }

  /// [name] or [[name]]
  void open_header() {
    count('[');
    ++i_;
    if (at(i_) == '[') {
      count('[');
      ++i_;
    }
    while (at(i_) == ' ' || at(i_) == '\t') ++i_;
    const char c = at(i_);
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '"' || c == '\'') return;
    refuse("a table begins without its name", "write [name], or [[name]] for one of several");
  }

  void skip_string(char quote) {
    const bool several_lines = at(i_ + 1) == quote && at(i_ + 2) == quote;
    i_ += several_lines ? 3 : 1;
    for (; i_ < text_.size(); ++i_) {
      const char c = text_[i_];
      if (quote == '"' && c == '\\') {
        ++i_;
      } else if (c == '\n' && !several_lines) {
        return;  // not closed: the library says so
      } else if (c == quote && !several_lines) {
        ++i_;
        return;
      } else if (c == quote && at(i_ + 1) == quote && at(i_ + 2) == quote) {
        i_ += 3;
        for (int more = 0; more < 2 && at(i_) == quote; ++more) ++i_;  // the text may end with two of them
        return;
      }
    }
  }

  void refuse(std::string wrong, std::string right) {
    const std::string_view before = text_.substr(0, i_);
    const std::size_t line_start = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
    const auto letters = std::ranges::count_if(before.substr(line_start), [](char c) { return (c & 0xC0) != 0x80; });
    found_ = {.line = 1 + static_cast<std::size_t>(std::ranges::count(before, '\n')),
              .column = 1 + static_cast<std::size_t>(letters),
              .wrong = std::move(wrong),
              .right = std::move(right)};
  }

  std::string_view text_;
  std::size_t i_ = 0;
  bool begins_ = true;  ///< nothing of a statement has been seen yet
  int depth_ = 0;
  int parts_ = 1;
  std::optional<Unreadable> found_;
};

}  // namespace

std::optional<Unreadable> find_unreadable(std::string_view text) {
  if (text.size() > most_bytes) {
    return Unreadable{
        .wrong = fmt::format("the text has {} MB, and {} MB is the most", text.size() >> 20U, most_bytes >> 20U),
        .right = "thin out its tables"};
  }
  return Scan(text).run();
}

}  // namespace strandyn::casefile
