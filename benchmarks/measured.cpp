#include "measured.hpp"

extern "C" __attribute__((noinline, noipa)) void measured(const std::function<void()>& work) {
  work();
}
