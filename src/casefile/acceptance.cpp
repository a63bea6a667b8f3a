#include "strandyn/casefile/acceptance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace strandyn::casefile {
namespace {

using results::Value;

/// One step of a path: a key, an index, or a reduction over a list.
struct Step {
  enum class Kind { key, index, max, min, sum } kind;
  std::string key = {};
  int index = 0;
};

/// What a path leads to, or why it leads nowhere.
struct Found {
  std::optional<Scalar> value;
  std::string fault;
};

/// The steps of a path, or what is wrong with its spelling.
std::variant<std::vector<Step>, std::string> parse_path(std::string_view path) {
  using enum Step::Kind;
  std::vector<Step> steps;
  std::size_t i = 0;
  while (true) {
    const std::size_t end = std::min(path.find_first_of(".[]", i), path.size());
    if (end == i) return "a name is missing in the path";
    steps.push_back({.kind = key, .key = std::string(path.substr(i, end - i))});
    i = end;
    while (i < path.size() && path[i] == '[') {
      const std::size_t close = path.find(']', i);
      if (close == std::string_view::npos) return "a bracket is not closed in the path";
      const std::string_view inside = path.substr(i + 1, close - i - 1);
      int index_value = 0;
      const auto [stop, error] = std::from_chars(inside.data(), inside.data() + inside.size(), index_value);
      if (inside == "max") {
        steps.push_back({.kind = max});
      } else if (inside == "min") {
        steps.push_back({.kind = min});
      } else if (inside == "sum") {
        steps.push_back({.kind = sum});
      } else if (error == std::errc{} && stop == inside.data() + inside.size()) {
        steps.push_back({.kind = index, .index = index_value});
      } else {
        return fmt::format("[{}] is none of a whole number, max, min, sum", inside);
      }
      i = close + 1;
    }
    if (i == path.size()) return steps;
    if (path[i] != '.') return fmt::format("`{}` does not go on with . or [", path.substr(0, i));
    ++i;
  }
}

Found follow(const Value& node, const std::vector<Step>& steps, std::size_t i, const std::string& here);

/// What all entries of a list say of a member, where the list holds only some of them.
std::optional<double> reduction(const results::Reductions& all, Step::Kind kind, const std::string& member) {
  const auto found = all.members.find(member);
  if (found == all.members.end()) return std::nullopt;
  if (kind == Step::Kind::sum) return found->second.sum;
  return kind == Step::Kind::max ? found->second.largest : found->second.least;
}

/// The largest, the smallest or the sum of what the rest of the path leads to in each element of a list.
Found reduce(const Value& list, const std::vector<Step>& steps, std::size_t i, const std::string& here) {
  if (list.entries().empty()) return {{}, fmt::format("`{}` is an empty list", here)};
  if (list.of_all() && i + 2 == steps.size() && steps[i + 1].kind == Step::Kind::key) {
    if (const auto x = reduction(*list.of_all(), steps[i].kind, steps[i + 1].key)) return {*x, {}};
  }
  double result = 0;
  for (std::size_t n = 0; n < list.entries().size(); ++n) {
    const std::string element = fmt::format("{}[{}]", here, n);
    const Found found = follow(list.entries()[n], steps, i + 1, element);
    if (!found.value) return found;
    const double* x = std::get_if<double>(&*found.value);
    if (!x) return {{}, fmt::format("`{}` holds no number", element)};
    if (n == 0) {
      result = *x;
    } else if (steps[i].kind == Step::Kind::sum) {
      result += *x;
    } else {
      result = steps[i].kind == Step::Kind::max ? std::max(result, *x) : std::min(result, *x);
    }
  }
  return {result, {}};
}

/// The place of an index in a list, of which the middle may have been left out.
std::optional<std::size_t> place_of(const Value& list, int index) {
  const auto kept = static_cast<long long>(list.entries().size());
  const long long count = list.of_all() ? static_cast<long long>(list.of_all()->count) : kept;
  const long long wanted = index < 0 ? count + index : index;
  if (wanted < 0 || wanted >= count) return std::nullopt;
  if (kept == count || wanted < kept / 2) return static_cast<std::size_t>(wanted);
  const long long from_end = count - wanted;
  if (from_end > kept - kept / 2) return std::nullopt;
  return static_cast<std::size_t>(kept - from_end);
}

/// Follows the steps from `i` on; `here` is the path so far, for the text of a fault.
Found follow(const Value& node, const std::vector<Step>& steps, std::size_t i, const std::string& here) {
  if (i == steps.size()) {
    if (const auto x = node.number()) return {*x, {}};
    if (const auto flag = node.flag()) return {*flag, {}};
    if (const std::string* words = node.words()) return {*words, {}};
    return {{}, fmt::format("`{}` is {}, no number", here, node.kind())};
  }
  const Step& step = steps[i];
  if (step.kind == Step::Kind::key) {
    const Value* member = node.find(step.key);
    if (!member) return {{}, fmt::format("{} has no `{}`", here.empty() ? "the summary" : '`' + here + '`', step.key)};
    return follow(*member, steps, i + 1, here.empty() ? step.key : here + '.' + step.key);
  }
  if (!node.is_list()) return {{}, fmt::format("`{}` is no list", here)};
  if (step.kind != Step::Kind::index) return reduce(node, steps, i, here);
  const auto place = place_of(node, step.index);
  if (!place) {
    const std::size_t count = node.of_all() ? node.of_all()->count : node.entries().size();
    return {{},
            node.of_all()
                ? fmt::format("`{}` keeps the first and the last of {} elements, no [{}]", here, count, step.index)
                : fmt::format("`{}` has {} elements, no [{}]", here, count, step.index)};
  }
  return follow(node.entries()[*place], steps, i + 1, fmt::format("{}[{}]", here, step.index));
}

Found find(const std::string& path, const Value& summary, int exit_code) {
  if (path == "exit_code") return {static_cast<double>(exit_code), {}};
  const auto steps = parse_path(path);
  if (const std::string* fault = std::get_if<std::string>(&steps)) return {{}, *fault};
  return follow(summary, std::get<std::vector<Step>>(steps), 0, "");
}

std::string text_of(const Scalar& value) {
  if (const double* x = std::get_if<double>(&value)) return fmt::format("{:.6g}", *x);
  if (const bool* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  return fmt::format("\"{}\"", std::get<std::string>(value));
}

std::string wanted_text(const Criterion& c) {
  if (c.below) return fmt::format("below {:.6g}", *c.below);
  if (c.above) return fmt::format("above {:.6g}", *c.above);
  const std::string expected = text_of(*c.expected);
  if (c.relative) return fmt::format("{} within {:.6g} %", expected, 100 * *c.relative);
  if (c.absolute) return fmt::format("{} within {:.6g}", expected, *c.absolute);
  return expected;
}

/// Correct decimal digits of `got`, 17 where it equals `expected`.
double correct_digits(double got, double expected) {
  if (got == expected) return 17;
  return -std::log10(std::abs(got - expected) / (expected != 0 ? std::abs(expected) : 1.0));
}

bool holds(const Criterion& c, const Scalar& value) {
  const double* x = std::get_if<double>(&value);
  if (c.below) return x && *x < *c.below;
  if (c.above) return x && *x > *c.above;
  const double* expected = std::get_if<double>(&*c.expected);
  if (!expected) return value == *c.expected;
  return x && std::abs(*x - *expected) <= c.absolute.value_or(0.0) + c.relative.value_or(0.0) * std::abs(*expected);
}

}  // namespace

std::vector<Verdict> judge(const Acceptance& acceptance, const Value& summary, int exit_code) {
  std::vector<Verdict> verdicts;
  for (const Criterion& criterion : acceptance.criteria) {
    Verdict& verdict = verdicts.emplace_back();
    verdict.path = criterion.path;
    verdict.wanted = wanted_text(criterion);
    verdict.reason = criterion.reason;
    verdict.source = criterion.source.value_or("");
    const Found found = find(criterion.path, summary, exit_code);
    if (!found.value) {
      verdict.found = found.fault;
      continue;
    }
    verdict.found = text_of(*found.value);
    verdict.passed = holds(criterion, *found.value);
    if (const double* x = std::get_if<double>(&*found.value)) {
      verdict.got = *x;
      const double* expected = criterion.expected ? std::get_if<double>(&*criterion.expected) : nullptr;
      if (expected) verdict.digits = correct_digits(*x, *expected);
    }
  }
  return verdicts;
}

std::optional<double> number_at(const std::string& path, const results::Value& summary) {
  return judge({.criteria = {{.path = path, .above = 0}}}, summary, 0).front().got;
}

std::optional<std::string> find_path_fault(std::string_view path) {
  const auto steps = parse_path(path);
  if (const std::string* fault = std::get_if<std::string>(&steps)) return *fault;
  return std::nullopt;
}

}  // namespace strandyn::casefile
