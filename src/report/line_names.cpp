#include "line_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "strandyn/report/format.hpp"
#include "strandyn/results/label.hpp"

namespace strandyn::report {
namespace {

std::string without_end_zeros(std::string number) {
  if (number.find('.') == std::string::npos || number.find("×") != std::string::npos) return number;
  number.erase(number.find_last_not_of('0') + 1);
  if (number.ends_with('.')) number.pop_back();
  return number;
}

std::string in_words(double value, const std::string& key, bool named, int digits) {
  if (key == "end") return value == 0 ? "left end" : "right end";
  const results::Label label = results::label_of(key);
  if (results::is_share(key))
    return fmt::format("{} {} %", label.name, without_end_zeros(typeset(100 * value, digits)));
  const Quantity shown = quantity(value, label.unit, digits);
  const std::string number = without_end_zeros(shown.number);
  if (label.unit.empty()) return label.name + " " + number;
  // An amplitude stands for both of its signs.
  const bool both_signs = label.name.find("amplitude") != std::string::npos;
  return fmt::format("{}{}{} {}", named ? label.name + " " : "", both_signs ? "±" : "", number, shown.unit);
}

/// One text per group, in as few digits as keep different values different.
std::vector<std::string> column_of_words(const std::vector<double>& values, const std::string& key, bool named) {
  const std::size_t different = std::set(values.begin(), values.end()).size();
  std::vector<std::string> words;
  for (int digits = 3; digits <= 9; ++digits) {
    words.clear();
    for (const double value : values) words.push_back(in_words(value, key, named, digits));
    if (std::set(words.begin(), words.end()).size() == different) break;
  }
  return words;
}

bool differ(const std::vector<double>& values) {
  constexpr double rounding = 1e-6;
  return std::any_of(values.begin(), values.end(), [&](double value) {
    return std::abs(value - values.front()) > rounding * std::abs(values.front());
  });
}

}  // namespace

std::vector<std::string> names_of(const results::Groups& groups, const std::vector<std::string>& columns) {
  std::vector<std::vector<double>> values(columns.size());
  for (const auto& [key, rows] : groups) {
    for (std::size_t i = 0; i < columns.size(); ++i) values[i].push_back(key[i]);
  }
  std::vector<std::size_t> with_unit;
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const bool has_unit = !results::label_of(columns[i]).unit.empty();
    if (groups.size() > 1 ? !differ(values[i]) : !has_unit) continue;
    chosen.push_back(i);
    if (has_unit) with_unit.push_back(i);
  }
  std::set<std::vector<double>> told_apart;
  for (std::size_t group = 0; group < groups.size(); ++group) {
    std::vector<double> key;
    for (const std::size_t i : with_unit) key.push_back(values[i][group]);
    told_apart.insert(key);
  }
  if (told_apart.size() == groups.size()) chosen = with_unit;

  std::vector<std::string> names(groups.size());
  for (const std::size_t i : chosen) {
    const bool same_unit = std::count_if(chosen.begin(), chosen.end(), [&](std::size_t k) {
                             return results::label_of(columns[k]).unit == results::label_of(columns[i]).unit;
                           }) > 1;
    const auto words = column_of_words(values[i], columns[i], same_unit);
    for (std::size_t group = 0; group < names.size(); ++group) {
      names[group] += (names[group].empty() ? "" : ", ") + words[group];
    }
  }
  return names;
}

}  // namespace strandyn::report
