#pragma once
/// \file The reference of the output files, made from the records that write them.

#include <string>

namespace strandyn::study {

/// docs/outputs.md: what every member of summary.json means, in Markdown.
std::string outputs_reference();

}  // namespace strandyn::study
