#pragma once
/// \file Inputs made of others, with a fixed seed: for compilers without libFuzzer.

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace strandyn::fuzz {

class Mutator {
 public:
  /// Words of the seeds are put where others stood.
  Mutator(std::uint64_t seed, const std::vector<std::string>& seeds);

  /// One of the seeds, changed in one to eight places.
  std::string next();

 private:
  std::size_t below(std::size_t n) { return n == 0 ? 0 : random_() % n; }
  void change(std::string& bytes);
  void change_number(std::string& bytes);
  void change_word(std::string& bytes);
  void change_raw_value(std::string& bytes);
  void splice(std::string& bytes);

  std::mt19937_64 random_;
  const std::vector<std::string>& seeds_;
  std::vector<std::string> words_;
};

}  // namespace strandyn::fuzz
