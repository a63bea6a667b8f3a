#pragma once
/// \file Ctrl-C ends a run between two steps: what was computed is written before the program ends.

namespace strandyn::app {

/// From now on SIGINT and SIGTERM are noted, not obeyed at once; a second one ends the program at once.
void watch_for_interrupt();

bool interrupted();

}  // namespace strandyn::app
