#pragma once
/// \file What the members of a record are called and mean: the reference of the output files, docs/outputs.md.

#include <optional>
#include <string>
#include <vector>

#include "strandyn/results/record.hpp"

namespace strandyn::results {

struct MemberNote {
  std::string path;  ///< as an acceptance writes it: "cycles[].t_s"
  std::string what;
};

/// Gathers the members of a record and of the records inside.
class ReferenceWriter {
 public:
  explicit ReferenceWriter(std::string prefix = {}) : prefix_(std::move(prefix)) {}

  template <class T>
  void value(const char* key, const T&, const About& about) {
    add(prefix_ + key, about);
  }
  template <class R>
  void record(const char* key, const R&, const About& about) {
    add(prefix_ + key, about);
    inside<R>(prefix_ + key + ".");
  }
  template <class R>
  void record(const char* key, const std::optional<R>&, const About& about) {
    record(key, R{}, about);
  }
  template <class R>
  void list(const char* key, const std::vector<R>&, const About& about) {
    add(prefix_ + key + "[]", about);
    inside<R>(prefix_ + key + "[].");
  }
  template <class R>
  void list(const char* key, const std::optional<std::vector<R>>&, const About& about) {
    list(key, std::vector<R>{}, about);
  }
  template <class R>
  void part(const R&) {
    inside<R>(prefix_);
  }
  template <class R>
  void part(const std::optional<R>&) {
    inside<R>(prefix_);
  }
  void rest(const Value&) {}

  template <class R>
  static std::vector<MemberNote> of() {
    ReferenceWriter writer;
    writer.template inside<R>("");
    return std::move(writer.notes_);
  }

 private:
  void add(std::string path, const About& about) { notes_.push_back({.path = std::move(path), .what = about.what}); }

  template <class R>
  void inside(const std::string& prefix) {
    ReferenceWriter writer(prefix);
    R record{};
    members(writer, record);
    notes_.insert(notes_.end(), writer.notes_.begin(), writer.notes_.end());
  }

  std::string prefix_;
  std::vector<MemberNote> notes_;
};

}  // namespace strandyn::results
