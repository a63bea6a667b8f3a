#pragma once
/// \file One door of the program through which bytes come that somebody else has written: what a fuzzer needs of it.
///
/// A target is one file of this folder with these two functions. libFuzzer drives it in a build with the preset `fuzz`
/// (fuzzer.cpp), a mutator of a fixed seed in every other build (replay.cpp). Whatever the bytes are, the door answers:
/// with what it has read, or with an InputError, a FileError or a ComputationError. Every other ending is a finding,
/// and so is an answer that takes longer than `most_seconds`.

#include <string>
#include <string_view>
#include <vector>

namespace strandyn::fuzz {

inline constexpr double most_seconds = 2;  ///< [s] of the processor, for one input

/// Opens the door with these bytes.
void take(std::string_view bytes);

/// Whole inputs to begin with. They are made by the program itself where it is what writes such files.
std::vector<std::string> seeds();

}  // namespace strandyn::fuzz
