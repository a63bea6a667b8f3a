#include "strandyn/core/archive.hpp"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <array>
#include <deque>
#include <limits>
#include <vector>

#include "strandyn/core/aligned.hpp"

using namespace strandyn;

namespace {

struct Plain {
  double length = 0;
  double width = 0;
};

enum class Kind { one, two };

struct Part {
  std::vector<double> numbers;
  void archive(Archive& a) { a(numbers); }
};

/// One of everything that states are made of.
struct Whole {
  double number = 0;
  bool flag = false;
  Kind kind = Kind::one;
  Plain plain;
  double coefficients[3] = {};
  std::array<double, 2> pair{};
  std::string text;
  AlignedVector aligned;
  Eigen::VectorXd vector;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  std::vector<Eigen::Matrix2d> blocks;
  std::vector<std::vector<int>> nested;
  std::deque<Part> parts;
  std::optional<Part> there, missing = Part{};

  void archive(Archive& a) {
    a(number, flag, kind, plain, coefficients, pair, text, aligned, vector, place, blocks, nested, parts, there,
      missing);
  }
};

Whole filled() {
  Whole x;
  x.number = 0.1;
  x.flag = true;
  x.kind = Kind::two;
  x.plain = {.length = 1.5, .width = -0.0};
  x.coefficients[2] = std::numeric_limits<double>::denorm_min();
  x.pair = {std::numeric_limits<double>::max(), 3};
  x.text = std::string("a\0b", 3);
  x.aligned = {1, 2, 3};
  x.vector = Eigen::VectorXd::LinSpaced(5, 0, 1);
  x.place = {1, 2, 3};
  x.blocks = {Eigen::Matrix2d::Identity(), Eigen::Matrix2d::Constant(7)};
  x.nested = {{1}, {}, {2, 3}};
  x.parts = {{{4, 5}}, {{}}};
  x.there = Part{{6}};
  x.missing.reset();
  return x;
}

std::string bytes_of(Whole& x) {
  Archive a;
  a(x);
  return a.bytes();
}

/// What is said of an exception of type E that `work` throws; empty where it throws none.
template <class E, class Work>
std::string said(Work&& work) {
  try {
    work();
  } catch (const E& error) {
    return error.what();
  }
  return "";
}

constexpr Seal mark{.kind = "checkpoint", .version = 3, .writer = "this program"};

}  // namespace

TEST_CASE("archive: what is read back is what was written to the bit") {
  Whole written = filled();
  const std::string bytes = bytes_of(written);
  Whole read;
  Archive a(bytes);
  a(read);
  a.finish();
  CHECK(bytes_of(read) == bytes);
  CHECK(read.number == 0.1);
  CHECK(read.kind == Kind::two);
  CHECK(std::signbit(read.plain.width));
  CHECK(read.coefficients[2] == written.coefficients[2]);
  CHECK(read.text == written.text);
  CHECK(read.vector == written.vector);
  CHECK(read.place == written.place);
  CHECK(read.blocks == written.blocks);
  CHECK(read.nested == written.nested);
  CHECK(read.parts.size() == 2);
  CHECK(read.parts[0].numbers == written.parts[0].numbers);
  CHECK(read.there->numbers == written.there->numbers);
  CHECK(!read.missing);
}

TEST_CASE("archive: a state that ends early or goes on too long is refused") {
  Whole written = filled();
  const std::string bytes = bytes_of(written);
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    Whole read;
    Archive a(bytes.substr(0, length));
    CHECK_THROWS_AS(a(read), FileError);
  }
  Whole read;
  Archive a(bytes + "x");
  a(read);
  CHECK_THROWS_AS(a.finish(), FileError);
}

TEST_CASE("archive: a value that both sides must have in common is compared") {
  Archive writer;
  writer.same(80, "number of elements");
  Archive reader(writer.bytes());
  CHECK(said<InputError>([&] { reader.same(40, "number of elements"); }).ends_with("number of elements"));
  Archive again(writer.bytes());
  CHECK_NOTHROW(again.same(80, "number of elements"));
}

TEST_CASE("seal: the content comes back and every damage is seen") {
  const std::string content("some \0 bytes", 12);
  const std::string file = seal(mark, content);
  CHECK(unseal(mark, file) == content);
  for (std::size_t i = 0; i < file.size(); ++i) {
    for (const char change : {'\1', '\x10', '\x7f'}) {
      std::string damaged = file;
      damaged[i] = static_cast<char>(damaged[i] ^ change);
      CHECK_THROWS_AS(unseal(mark, damaged), FileError);
    }
    CHECK_THROWS_AS(unseal(mark, file.substr(0, i)), FileError);
  }
  CHECK_THROWS_AS(unseal(mark, file + "x"), FileError);
}

TEST_CASE("seal: what a file is in place of the one that is looked for is said") {
  const auto refusal = [](const std::string& file) { return said<FileError>([&] { unseal(mark, file); }); };
  CHECK(refusal("t_s,kinetic_J\n").find("no checkpoint of strandyn") != std::string::npos);
  CHECK(refusal(seal({.kind = "checkpoint", .version = 2, .writer = mark.writer}, "")).find("format 2") !=
        std::string::npos);
  CHECK(refusal(seal({.kind = "checkpoint", .version = 3, .writer = "another"}, "")).find("written by another") !=
        std::string::npos);
  CHECK(refusal(seal(mark, "content").substr(0, 40)).find("cut off") != std::string::npos);
}
