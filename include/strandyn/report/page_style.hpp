#pragma once
/// \file The style sheet of the page.

#include <string_view>

namespace strandyn::report {

/// CSS for light, dark and paper.
std::string_view page_style();

}  // namespace strandyn::report
