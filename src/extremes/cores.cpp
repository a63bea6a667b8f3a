// One core and two: what is computed side by side is what is computed one after the other.
#ifdef __linux__
#include <sched.h>
#endif

#include <algorithm>
#include <exception>
#include <string>
#include <thread>
#include <vector>

#include "scene.hpp"
#include "strandyn/results/json.hpp"
#include "themes.hpp"

namespace strandyn::extremes {
namespace {

/// While it lives this thread, and those that it starts, have one core.
class OneCore {
 public:
  OneCore() {
#ifdef __linux__
    sched_getaffinity(0, sizeof before_, &before_);
    cpu_set_t one;
    CPU_ZERO(&one);
    for (int i = 0; i < CPU_SETSIZE; ++i) {
      if (!CPU_ISSET(i, &before_)) continue;
      CPU_SET(i, &one);
      break;
    }
    sched_setaffinity(0, sizeof one, &one);
#endif
  }
  ~OneCore() {
#ifdef __linux__
    sched_setaffinity(0, sizeof before_, &before_);
#endif
  }
  OneCore(const OneCore&) = delete;
  OneCore& operator=(const OneCore&) = delete;

 private:
#ifdef __linux__
  cpu_set_t before_;
#endif
};

std::string study_text(const std::string& method) {
  return "[conductor]\ncatalogue = \"curlew\"\nfriction = 0.7\n[section]\nlaw = \"return-map\"\n[span]\nlength_m = "
         "10\ntension_rts = 0.15\nelements = 40\n"
         "[analysis]\ntype = \"self-damping\"\nmethod = \"" +
         method + "\"\nmodes = [2, 3, 4, 5]\ntensions_rts = [0.15]\namplitude_over_diameter = [0.1, 0.3]\n";
}
/// What was found, to the last digit.
std::string answers(const Run& run) {
  return results::to_text(*run.result().summary.find("points"));
}

Found one_and_all(const std::string& method) {
  std::string alone;
  double alone_evaluations = 0;
  {
    const OneCore one;
    const Run run(study_text(method));
    alone = answers(run);
    alone_evaluations = run.evaluations();
  }
  const Run all(study_text(method));
  return Found{}
      .most("answers differ in letters", alone == answers(all) ? 0 : 1, 0)
      .least("letters compared", static_cast<double>(alone.size()), 1000)
      .costs({.extreme = all.evaluations(), .ordinary = alone_evaluations, .unit = "section evaluations"});
}

/// Two runs at once in one process know nothing of each other.
Found two_at_once() {
  const std::string text = curlew_span(
      "[integrator]\nsteps_per_cycle = 100\nmax_numerical_share = 1\n[analysis]\ntype = \"decay\"\nmode = 4\n"
      "antinode_amplitude_mm = 5\ncycles = 5\n");
  const auto cycles_of = [&] { return results::to_text(*Run(text).result().summary.find("cycles")); };
  const std::string alone = cycles_of();
  std::string both[2];
  std::exception_ptr failure[2];
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < 2; ++i) {
      threads.emplace_back([&, i] {
        try {
          both[i] = cycles_of();
        } catch (...) {
          failure[i] = std::current_exception();
        }
      });
    }
  }
  for (const std::exception_ptr& f : failure) {
    if (f) std::rethrow_exception(f);
  }
  return Found{}
      .most("answers that differ", (both[0] == alone ? 0 : 1) + (both[1] == alone ? 0 : 1), 0)
      .least("letters compared", static_cast<double>(alone.size()), 1000)
      .costs({.extreme = 2, .ordinary = 1, .unit = "runs"});
}

}  // namespace

std::vector<Extreme> core_rows() {
  return {
      {"cores/quadrature", "a study of eight points on one core and on all", "the same answer to the last digit",
       [] { return one_and_all("quadrature"); }},
      {"cores/periodic", "a study of eight steady vibrations on one core and on all",
       "the same answer to the last digit", [] { return one_and_all("periodic"); }, Pace::slow},
      {"cores/two-at-once", "two runs side by side in one process", "the same answer to the last digit", two_at_once},
  };
}

}  // namespace strandyn::extremes
