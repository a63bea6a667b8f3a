#pragma once
/// \file What a shard notes of itself in its folder, and what holds the folders of a study against each other.

#include <string>
#include <vector>

#include "strandyn/casefile/scene.hpp"
#include "strandyn/study/analysis.hpp"

namespace strandyn::study {

/// The file in the folder of a shard that says whose it is.
inline constexpr const char* shard_name = "shard.json";

/// Where the scene of a shard came from: enough to read it again without the file.
struct CaseText {
  std::string file;                    ///< as messages name it
  std::string text;                    ///< of the case file
  std::vector<std::string> overrides;  ///< the arguments of --set
};

/// Throws InputError where the analysis has no pieces, or fewer than there are to be shards.
void require_shards(const casefile::Scene& scene, const Analysis& analysis, const Shard& shard);

/// Where a shard goes on in a folder, throws InputError if the folder is another shard's.
void require_own_folder(const std::filesystem::path& folder, const Shard& shard);

/// Writes shard.json. Throws FileError.
void note_shard(const std::filesystem::path& folder, const Shard& shard, const CaseText& source,
                const Analysis& analysis);

/// Shards that belong together.
struct ShardSet {
  CaseText source;
  std::string identity;             ///< Pieces::identity, as the shards noted it
  std::vector<ShardFolder> shards;  ///< by number
  std::size_t of = 0;               ///< how many there are in all
};

/// Reads the notes of the folders. Throws InputError where a folder is no shard's, or is of another program, another
/// case, another number of shards than the first, or the same shard as another one; FileError where one cannot be read.
ShardSet read_shards(const std::vector<std::filesystem::path>& folders);

/// Throws InputError that names every shard and every piece that is missing, and how to get them.
void require_complete(const Analysis& analysis, const ShardSet& set);

}  // namespace strandyn::study
