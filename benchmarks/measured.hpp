#pragma once
/// \file What a script counts the instructions of: callgrind --toggle-collect=measured.

#include <functional>

/// Calls `work`, in a function that keeps its name.
extern "C" void measured(const std::function<void()>& work);
