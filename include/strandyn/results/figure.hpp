#pragma once
/// \file What is worth looking at, said beside the data: figures over the tables of a folder, and the numbers that a
/// reader looks for first. Whoever draws (report) knows no analysis.

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "strandyn/results/label.hpp"
#include "strandyn/results/record.hpp"

namespace strandyn::results {

/// Columns of a table, drawn against each other. The rows of each set of values of the `series` columns are lines of
/// their own; several `y` are lines of their own, too.
struct Figure {
  std::string name;  ///< of the file that is drawn: "loops"
  std::string title;
  std::string kind = "line";   ///< line, points, band, map, section, motion, wires
  std::string table;           ///< a file of the folder: "cycles.csv"
  std::string x;               ///< a column
  std::vector<std::string> y;  ///< columns; of a `band` the low and the high one, of a `map` the one up and the colour;
                               ///< of `wires` the one up, the radius and the colour from 0 to 1
  std::vector<std::string> series = {};
  std::string x_scale = "linear";  ///< linear, log
  std::string y_scale = "linear";
  std::string caption = {};
  std::optional<std::array<double, 2>> x_range = {};  ///< where not all of the rows are meant
};

template <class V>
void members(V& v, Figure& f) {
  v.value("name", f.name, {.what = "the name of the drawing"});
  v.value("title", f.title, {.what = "the title"});
  v.value("kind", f.kind, {.what = "line, points, band, map, section, motion or wires"});
  v.value("table", f.table, {.what = "the file with the data"});
  v.value("x", f.x, {.what = "the column along x"});
  v.value("y", f.y, {.what = "the columns along y, a line each"});
  v.value("series", f.series, {.what = "the columns whose values set lines apart"});
  v.value("x_scale", f.x_scale, {.what = "linear or log"});
  v.value("y_scale", f.y_scale, {.what = "linear or log"});
  v.value("caption", f.caption, {.what = "what to see in it"});
  v.value("x_range", f.x_range, {.what = "the part of x that is meant, where it is not all"});
}

/// A number that a reader looks for first.
struct Highlight {
  std::string name;  ///< in words
  std::string path;  ///< into summary.json; its last key carries the unit
  double value = 0;
};

template <class V>
void members(V& v, Highlight& h) {
  v.value("name", h.name, {.what = "in words"});
  v.value("path", h.path, {.what = "where the summary has it"});
  v.value("value", h.value, {.what = "the number"});
}

/// Gathers the members of a record that are to be shown first.
class HighlightReader {
 public:
  explicit HighlightReader(std::string prefix = {}) : prefix_(std::move(prefix)) {}
  std::vector<Highlight> found;

  template <class T>
  void value(const char* key, const T& x, const About& about) {
    if constexpr (Number<T>) {
      if (about.shown) found.push_back({.name = about.shown, .path = prefix_ + key, .value = static_cast<double>(x)});
    }
  }
  template <class T>
  void value(const char* key, const std::optional<T>& x, const About& about) {
    if (x) value(key, *x, about);
  }
  template <class R>
  void record(const char* key, R& x, const About&) {
    HighlightReader inner(prefix_ + key + ".");
    inner.part(x);
    // A record of which there are several says which one it is, in all of its names.
    const bool taken = std::ranges::any_of(inner.found, [this](const Highlight& highlight) {
      return std::ranges::find(found, highlight.name, &Highlight::name) != found.end();
    });
    for (Highlight& highlight : inner.found) {
      if (taken) highlight.name += ", " + label_of(key).name;
      found.push_back(std::move(highlight));
    }
  }
  template <class R>
  void list(const char*, R&, const About&) {}
  template <class R>
  void part(R& x) {
    if constexpr (requires { x.has_value(); }) {
      if (x) members(*this, *x);
    } else {
      members(*this, x);
    }
  }
  void rest(Value&) {}

 private:
  std::string prefix_;
};

template <class R>
std::vector<Highlight> highlights_of(const R& record) {
  HighlightReader reader;
  reader.part(const_cast<R&>(record));
  return std::move(reader.found);
}

/// Columns of a table that the terminal and the page print, at most some twenty rows of it.
struct ShownTable {
  std::string title;                 ///< "Energy of each cycle"
  std::string table;                 ///< a file of the folder
  std::vector<std::string> columns;  ///< of it, in this order
};

template <class V>
void members(V& v, ShownTable& t) {
  v.value("title", t.title, {.what = "the title"});
  v.value("table", t.table, {.what = "the file with the data"});
  v.value("columns", t.columns, {.what = "the columns that are printed"});
}

/// A table that becomes a file of the folder.
struct NamedTable {
  std::string file;  ///< "cycles.csv"
  Table table;
};

}  // namespace strandyn::results
