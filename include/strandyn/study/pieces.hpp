#pragma once
/// \file A study whose points depend on nothing but the case can be run in shards, on one machine or many, and put
/// together again:
///
///     run CASE --shard 2/3    computes the share of that shard and leaves it in a folder of its own
///     merge DIR...            holds the folders against each other and against the program, puts their points where a
///                             run that was stopped would have left them, and lets the run come to its end
/// So a merged study has the bytes of one that was never divided, but for clocks.

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace strandyn::study {

/// One of `of` parts of a study.
struct Shard {
  std::size_t number = 1;  ///< from 1
  std::size_t of = 1;

  std::string words() const;  ///< 2/3
  friend bool operator==(const Shard&, const Shard&) = default;
};

/// Of `I/N`. Throws InputError where it is no such thing, or I does not lie in 1 to N.
Shard parse_shard(const std::string& text);

/// Which of `count` things, by their places from 0, are this shard's: dealt like cards, each round beginning one shard
/// further, so that what a grid repeats does not all come to the same one. Rising.
std::vector<std::size_t> dealt(std::size_t count, const Shard& shard);

/// A folder that a shard has left.
struct ShardFolder {
  Shard shard;
  std::filesystem::path folder;
};

class Pieces {
 public:
  virtual ~Pieces() = default;
  /// What one of them is called: "point", "setting".
  virtual const char* noun() const = 0;
  virtual std::size_t count() const = 0;
  /// The pieces of a shard, by their places from 0, rising: every piece is in one shard of each `of`.
  virtual std::vector<std::size_t> share(const Shard& shard) const = 0;
  /// What the numbers of a piece depend on, in brief.
  virtual std::string identity() const = 0;

  struct Found {
    std::vector<std::size_t> missing;  ///< of the share, from 0, rising
    std::string fault;                 ///< what is wrong with what lies there, in words; empty where nothing is
  };
  /// What the folder holds of the shard's share.
  virtual Found look(const ShardFolder& shard) const = 0;
  /// Puts the shares of all shards into `out`, as a run that was stopped after the last of them would have left them.
  virtual void gather(const std::vector<ShardFolder>& shards, const std::filesystem::path& out) const = 0;
};

}  // namespace strandyn::study
