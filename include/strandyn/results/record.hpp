#pragma once
/// \file Records: plain structs whose members are declared once, each with its name (the unit in it) and what it is.
///
///     template <class V>
///     void members(V& v, Cycle& c) {
///       v.value("t_s", c.end_time, {.what = "the end of the cycle"});
///       v.record("ledger", c.ledger, {.what = "..."});        // a record inside
///       v.list("nodes", c.nodes, {.what = "..."});            // records in a row
///       v.part(c.losses);                                     // members of another record among one's own
///     }
/// From this one list come the object in summary.json, the columns of a CSV file, the numbers that the terminal and the
/// page show first, the paths of an acceptance, and docs/outputs.md. An optional member that is empty is left out.
///
/// `value` takes numbers, true or false, words, ranges of numbers, and optionals of them.

#include <algorithm>
#include <cmath>
#include <concepts>
#include <iterator>
#include <limits>
#include <optional>
#include <ranges>
#include <string>
#include <utility>
#include <vector>

#include "strandyn/results/table.hpp"
#include "strandyn/results/value.hpp"

namespace strandyn::results {

struct About {
  const char* what = "";        ///< in the reference of the output files
  const char* shown = nullptr;  ///< under these words among the numbers that a reader looks for first
};

template <class T>
concept Number = std::is_arithmetic_v<T>;

/// Writes a record as an object.
class RecordWriter {
 public:
  Value object = Value::object();

  template <class T>
  void value(const char* key, const T& x, const About&) {
    object.set(key, write(x));
  }
  template <class T>
  void value(const char* key, const std::optional<T>& x, const About&) {
    if (x) object.set(key, write(*x));
  }
  template <class R>
  void record(const char* key, R& x, const About&) {
    object.set(key, of(x));
  }
  template <class R>
  void record(const char* key, std::optional<R>& x, const About&) {
    if (x) object.set(key, of(*x));
  }
  template <class R>
  void list(const char* key, std::vector<R>& rows, const About&) {
    Value entries = Value::list();
    for (R& row : rows) entries.append(of(row));
    object.set(key, std::move(entries));
  }
  template <class R>
  void list(const char* key, std::optional<std::vector<R>>& rows, const About& about) {
    if (rows) list(key, *rows, about);
  }
  template <class R>
  void part(R& x) {
    members(*this, x);
  }
  template <class R>
  void part(std::optional<R>& x) {
    if (x) members(*this, *x);
  }
  void rest(Value& more) { object.merge(more); }

  template <class R>
  static Value of(const R& record) {
    RecordWriter writer;
    members(writer, const_cast<R&>(record));  // one list of members serves those who read, too
    return std::move(writer.object);
  }

 private:
  template <class T>
  static Value write(const T& x) {
    if constexpr (std::constructible_from<Value, const T&>) {
      return Value(x);
    } else {
      Value entries = Value::list();
      for (const auto& entry : x) entries.append(write(entry));
      return entries;
    }
  }
};

template <class R>
Value to_value(const R& record) {
  return RecordWriter::of(record);
}
template <class R>
Value to_value(const std::vector<R>& records) {
  Value list = Value::list();
  for (const R& record : records) list.append(RecordWriter::of(record));
  return list;
}

/// Fills a record from an object of a file. What is missing or of another kind keeps its value and is counted.
class RecordReader {
 public:
  explicit RecordReader(const Value& object) : object_(object) {}

  template <class T>
  void value(const char* key, T& x, const About&) {
    const Value* found = take(key);
    if (!found || !read(*found, x)) ++missing_;
  }
  template <class T>
  void value(const char* key, std::optional<T>& x, const About&) {
    const Value* found = take(key);
    if (!found) return x.reset();
    if (!read(*found, x.emplace())) ++missing_;
  }
  template <class R>
  void record(const char* key, R& x, const About&) {
    const Value* found = take(key);
    if (!found) {
      ++missing_;
      return;
    }
    missing_ += fill(x, *found);
  }
  template <class R>
  void record(const char* key, std::optional<R>& x, const About&) {
    const Value* found = take(key);
    if (!found) return x.reset();
    missing_ += fill(x.emplace(), *found);
  }
  template <class R>
  void list(const char* key, std::vector<R>& rows, const About&) {
    rows.clear();
    const Value* found = take(key);
    if (!found) return;
    for (const Value& entry : found->entries()) missing_ += fill(rows.emplace_back(), entry);
  }
  template <class R>
  void part(R& x) {
    members(*this, x);
  }
  /// A part that may be absent is there where all of its members are.
  template <class R>
  void part(std::optional<R>& x) {
    R trial{};
    RecordReader reader(object_);
    members(reader, trial);
    x.reset();
    if (reader.missing_ > 0) return;
    x = std::move(trial);
    taken_.insert(taken_.end(), reader.taken_.begin(), reader.taken_.end());
  }
  /// Declared last: what no member has taken.
  void rest(Value& more) {
    more = Value::object();
    for (const auto& [key, value] : object_.members()) {
      if (std::ranges::find(taken_, key) == taken_.end()) more.set(key, value);
    }
  }

  /// How many members could not be read.
  template <class R>
  static int fill(R& record, const Value& object) {
    RecordReader reader(object);
    members(reader, record);
    return reader.missing_;
  }

 private:
  const Value* take(const char* key) {
    taken_.emplace_back(key);
    return object_.find(key);
  }
  /// The number that stands there, where T can hold it: a whole T takes no fraction and nothing beyond its range.
  template <Number T>
  static std::optional<T> held_by(const Value& from) {
    return from.visit([](const auto& data) -> std::optional<T> {
      using Data = std::remove_cvref_t<decltype(data)>;
      if constexpr (!Number<Data> || std::same_as<Data, bool>) {
        return std::nullopt;
      } else if constexpr (std::floating_point<T>) {
        return static_cast<T>(data);
      } else if constexpr (std::integral<Data>) {
        return std::in_range<T>(data) ? std::optional(static_cast<T>(data)) : std::nullopt;
      } else {
        using Limits = std::numeric_limits<T>;
        constexpr double beyond = 2.0 * static_cast<double>(Limits::max() / 2 + 1);
        const bool fits = data >= static_cast<double>(Limits::min()) && data < beyond && data == std::floor(data);
        return fits ? std::optional(static_cast<T>(data)) : std::nullopt;
      }
    });
  }
  template <class T>
  static bool read(const Value& from, T& x) {
    if constexpr (std::same_as<T, bool>) {
      if (from.flag()) x = *from.flag();
      return from.flag().has_value();
    } else if constexpr (Number<T>) {
      const std::optional<T> held = held_by<T>(from);
      if (held) x = *held;
      return held.has_value();
    } else if constexpr (std::same_as<T, std::string>) {
      if (from.words()) x = *from.words();
      return from.words() != nullptr;
    } else if constexpr (requires { x.emplace_back(); }) {
      x.clear();
      for (const Value& entry : from.entries()) {
        if (!read(entry, x.emplace_back())) return false;
      }
      return from.is_list();
    } else {
      if (from.entries().size() != x.size()) return false;
      std::size_t i = 0;
      for (auto& entry : x) {
        if (!read(from.entries()[i++], entry)) return false;
      }
      return true;
    }
  }

  const Value& object_;
  std::vector<std::string> taken_;
  int missing_ = 0;
};

/// Names and values of the numbers of a record, those of its parts among them; lists, words and what may be absent are
/// no columns.
class ColumnReader {
 public:
  std::vector<std::string> names;
  std::vector<double> values;

  template <class T>
  void value(const char* key, const T& x, const About&) {
    if constexpr (Number<T>) {
      names.emplace_back(key);
      values.push_back(static_cast<double>(x));
    }
  }
  template <class R>
  void record(const char*, R&, const About&) {}
  template <class R>
  void list(const char*, R&, const About&) {}
  template <class R>
  void part(R& x) {
    if constexpr (requires { x.has_value(); })
      return;
    else
      members(*this, x);
  }
  void rest(Value&) {}

  template <class R>
  static ColumnReader of(const R& record) {
    ColumnReader reader;
    members(reader, const_cast<R&>(record));
    return reader;
  }
};

/// One column per number of the record; `counted`, where given, is the name of a first column that counts from 1.
template <class R>
Table table_of(const std::vector<R>& records, const char* counted = nullptr) {
  std::vector<std::string> names;
  if (counted) names.emplace_back(counted);
  std::ranges::copy(ColumnReader::of(R{}).names, std::back_inserter(names));
  Table table(std::move(names));
  std::vector<double> row;
  for (const R& record : records) {
    row.clear();
    if (counted) row.push_back(static_cast<double>(table.rows() + 1));
    std::ranges::copy(ColumnReader::of(record).values, std::back_inserter(row));
    table.append(row);
  }
  return table;
}

}  // namespace strandyn::results
