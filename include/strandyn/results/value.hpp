#pragma once
/// \file A tree of results as a file holds it: objects whose keys keep their order, lists, numbers, words.
///
/// Whoever computes writes it, by records (record.hpp). Nobody inside the program looks a number up in it by its name:
/// only those do whose business is a path that a person wrote (the acceptance of a case) or a file (the readers).

#include <concepts>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace strandyn::results {

/// Over a list of which only the ends are kept: what all of its entries say. By the name of a member.
struct Reductions {
  struct Range {
    double least = 0, largest = 0, sum = 0;
  };
  std::size_t count = 0;
  std::map<std::string, Range, std::less<>> members = {};
};

class Value {
 public:
  using List = std::vector<Value>;
  using Member = std::pair<std::string, Value>;
  using Object = std::vector<Member>;

  Value() = default;
  Value(bool flag) : data_(flag) {}
  Value(std::floating_point auto number) : data_(static_cast<double>(number)) {}
  Value(std::signed_integral auto number) : data_(static_cast<std::int64_t>(number)) {}
  Value(std::unsigned_integral auto number) : data_(static_cast<std::uint64_t>(number)) {}
  Value(std::string words) : data_(std::move(words)) {}
  Value(std::string_view words) : data_(std::string(words)) {}
  Value(const char* words) : data_(std::string(words)) {}
  Value(List list) : data_(std::move(list)) {}
  static Value object(Object members = {}) { return Value(Data(std::move(members))); }
  static Value list(List entries = {}) { return Value(std::move(entries)); }

  /// Adds the member, or replaces it where it is there. Makes an object of nothing.
  void set(std::string_view key, Value value);
  /// Makes a list of nothing.
  void append(Value value);
  /// Adds all members of another object, each replacing its namesake.
  void merge(const Value& other);
  void say_of_all(Reductions reductions) { whole_ = std::make_shared<const Reductions>(std::move(reductions)); }

  bool is_null() const { return std::holds_alternative<std::monostate>(data_); }
  bool is_object() const { return std::holds_alternative<Object>(data_); }
  bool is_list() const { return std::holds_alternative<List>(data_); }
  std::optional<double> number() const;  ///< also of whole numbers
  std::optional<bool> flag() const;
  const std::string* words() const { return std::get_if<std::string>(&data_); }
  const List& entries() const;    ///< none where this is no list
  const Object& members() const;  ///< none where this is no object
  bool empty() const { return entries().empty() && members().empty(); }
  /// For paths and files; null where it is missing.
  const Value* find(std::string_view key) const;
  /// Of a list that holds only a part of what it stands for.
  const Reductions* of_all() const { return whole_.get(); }
  const char* kind() const;  ///< "an object", "a number", ...: for messages

  template <class Visitor>
  decltype(auto) visit(Visitor&& visitor) const {
    return std::visit(std::forward<Visitor>(visitor), data_);
  }

 private:
  using Data = std::variant<std::monostate, bool, double, std::int64_t, std::uint64_t, std::string, List, Object>;
  explicit Value(Data data) : data_(std::move(data)) {}

  Data data_;
  std::shared_ptr<const Reductions> whole_;
};

}  // namespace strandyn::results
