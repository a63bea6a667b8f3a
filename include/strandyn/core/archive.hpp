#pragma once
/// \file State written to bytes and read back to the same bits: one function per class does both.
///
///     void archive(Archive& a) { a(time_, u_, cycles_); }
///
/// Numbers are copied as they lie in memory; whoever reads is the program that wrote. What is read holds to what every
/// state does: a row that has a size already keeps it, a number is finite, a flag is 0 or 1. `seal` adds what a file
/// needs so that nothing else is taken for it: a mark, a version, the writer, the length, and a checksum that every
/// single wrong byte changes.

#include <cmath>
#include <complex>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <optional>
#include <ranges>
#include <string>
#include <string_view>
#include <type_traits>

#include "strandyn/core/error.hpp"

namespace strandyn {

class Archive {
 public:
  /// Writes.
  Archive() = default;
  /// Reads what another one has written.
  explicit Archive(std::string bytes) : reads_(true), bytes_(std::move(bytes)) {}

  bool reads() const { return reads_; }
  const std::string& bytes() const { return bytes_; }

  /// Writes the fields, or reads them in the same order.
  template <class... Fields>
  void operator()(Fields&... fields) {
    (field(fields), ...);
  }

  /// Writes a value that the reader has already, and must have in common with the writer. Throws InputError.
  template <class T>
  void same(const T& value, std::string_view what) {
    T found{};  // of any size
    if (!reads_) found = value;
    field(found);
    if (!(found == value)) throw InputError("the state belongs to something else: another " + std::string(what));
  }

  /// A row that may have grown since it was first made: read, it has at least the size that it has here.
  template <class Row>
  void grown(Row& x) {
    const std::size_t before = x.size();
    if (reads_) x.clear();
    field(x);
    if (x.size() < before) throw FileError("a row of the state has lost some of its entries");
  }

  /// To be called after the last field. Throws FileError where something is left over.
  void finish() const {
    if (reads_ && at_ != bytes_.size()) throw FileError("the state holds more than is looked for");
  }

 private:
  template <class T>
  static constexpr bool has_fixed_size = requires {
    requires T::SizeAtCompileTime >
    0;
  };  // of Eigen

  template <class T>
  void field(T& x) {
    if constexpr (requires { x.archive(*this); }) {
      x.archive(*this);
    } else if constexpr (has_fixed_size<T>) {
      raw(x.data(), sizeof(*x.data()) * T::SizeAtCompileTime);
      for (std::ptrdiff_t i = 0; i < std::ptrdiff_t{T::SizeAtCompileTime}; ++i) check(x.data()[i]);
    } else if constexpr (requires { x.resize(x.size()); }) {
      row(x);
    } else {
      static_assert(std::is_trivially_copyable_v<T> && !std::is_pointer_v<T>);
      raw(&x, sizeof x);
      check(x);
    }
  }
  void field(bool& x) {
    auto byte = static_cast<unsigned char>(x);
    raw(&byte, sizeof byte);
    if (byte > 1) throw FileError("a flag of the state is neither 0 nor 1");
    x = byte == 1;
  }
  template <class T>
  void field(std::optional<T>& x) {
    bool there = x.has_value();
    field(there);
    if (there && !x) x.emplace();
    if (!there) x.reset();
    if (x) field(*x);
  }

  template <class Row>
  void row(Row& x) {
    using Entry = std::remove_cvref_t<decltype(*x.begin())>;
    constexpr bool numbers = std::is_arithmetic_v<Entry> && requires {
      x.data();
    };
    auto size = static_cast<std::uint64_t>(x.size());
    field(size);
    if (reads_) {
      require(size, numbers ? sizeof(Entry) : 1);
      if (x.size() > 0 && size != static_cast<std::uint64_t>(x.size())) {
        throw FileError("a row of the state has " + std::to_string(size) + " entries where " +
                        std::to_string(x.size()) + " are due");
      }
      x.resize(static_cast<std::size_t>(size));
    }
    if constexpr (numbers) {
      raw(x.data(), sizeof(Entry) * static_cast<std::size_t>(size));
      for (const Entry& entry : x) check(entry);
    } else {
      for (Entry& entry : x) field(entry);
    }
  }

  void raw(void* data, std::size_t size) {
    if (!reads_) {
      bytes_.append(static_cast<const char*>(data), size);
      return;
    }
    require(size, 1);
    if (size > 0) std::memcpy(data, bytes_.data() + at_, size);
    at_ += size;
  }

  template <class T>
  void check(const T& x) const {
    if (!reads_) return;
    if constexpr (std::is_floating_point_v<T>) {
      if (!std::isfinite(x)) throw FileError("a number of the state is not finite");
    } else if constexpr (requires { x.imag(); }) {
      check(x.real());
      check(x.imag());
    } else if constexpr (std::ranges::range<const T>) {
      for (const auto& entry : x) check(entry);
    }
  }

  void require(std::uint64_t count, std::size_t size) const {
    if (count > (bytes_.size() - at_) / size) throw FileError("the state ends too early");
  }

  bool reads_ = false;
  std::string bytes_;
  std::size_t at_ = 0;
};

/// What a file says of itself. `writer` is the program, to the revision: bits are promised to itself only.
struct Seal {
  std::string_view kind;      ///< "checkpoint"
  std::uint32_t version = 0;  ///< of the format
  std::string_view writer;
};

std::string seal(const Seal& seal, std::string_view content);
/// The content again. Throws FileError that says what is wrong with the file: not of this kind, of another version or
/// writer, cut off, damaged.
std::string unseal(const Seal& seal, std::string_view file);

}  // namespace strandyn
