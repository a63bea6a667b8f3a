// A state with one number altered, as a checkpoint with a right checksum may hold it.
#include "strandyn/observe/checkpoint_check.hpp"

#include <doctest/doctest.h>

#include <cstring>
#include <limits>

#include "solver/vibration.hpp"
#include "strandyn/observe/cycles.hpp"
#include "strandyn/solver/time/integrator.hpp"

using namespace strandyn;
using observe::StepRecord;
using system::Vector;
using test::Vibration;

namespace {

constexpr double cycles_of_run = 1;
constexpr std::size_t kept_after = 70;  // of 100 steps: in the middle of the cycle, where all energies are there

/// Remembers the last step.
class LastStep final : public observe::Observer {
 public:
  void begin(const system::System&, const StepRecord&) override {}
  void step(const system::System&, const StepRecord& r) override {
    time = r.time;
    u = r.u;
    v = r.v;
    ++taken;
  }
  void archive(Archive&) override {}

  double time = 0;
  Vector u, v;
  std::size_t taken = 0;
};

/// A run that leaves a state, and all that the tests alter in it.
struct Left {
  std::string state;
  LastStep last;
  observe::Account account;
  AlignedVector strains;
};

/// Runs to its end, or to where it leaves its state, from the beginning or from a state.
Left run(const solver::TimeMethod& method, const std::string& resume) {
  Vibration vibration(test::return_map(model::Freedom::planar), {.length = 10, .elements = 12, .drag = 0.5}, 3);
  solver::IntegratorOptions options = vibration.options(100, cycles_of_run);
  Left left;
  observe::CycleObserver cycles({.period = vibration.period(), .loop_length = 3, .kept = 2});
  observe::CheckpointCheck check(cycles.ledger(), options.end_time);
  observe::Observer* const observers[] = {&left.last, &cycles, &check};
  options.checkpoints.resume = resume;
  if (resume.empty()) {
    options.checkpoints.due = [&] { return left.last.taken == kept_after; };
    options.checkpoints.keep = [&](const std::string& state) { left.state = state; };
    options.stop = [&] { return left.last.taken == kept_after; };
  } else {
    check.expect_state();
  }
  check.ended(solver::integrate(vibration.system, vibration.start(2e-2), options, method, observers).end_time);
  left.account = cycles.ledger().now();
  left.strains = vibration.system.committed_strains()[section::Component::bending2];
  return left;
}

double largest(const auto& numbers) {
  double found = 0;
  for (const double x : numbers) found = std::abs(x) > std::abs(found) ? x : found;
  return found;
}

/// Where a number of this value stands in the state.
std::vector<std::size_t> places_of(double value, const std::string& state) {
  const std::string bytes(reinterpret_cast<const char*>(&value), sizeof value);
  std::vector<std::size_t> places;
  for (std::size_t at = state.find(bytes); at != std::string::npos; at = state.find(bytes, at + 1))
    places.push_back(at);
  return places;
}

std::string altered(std::string state, std::size_t at, double to) {
  REQUIRE(at + sizeof to <= state.size());
  std::memcpy(state.data() + at, &to, sizeof to);
  return state;
}

void check_refusals(const solver::TimeMethod& method) {
  const Left left = run(method, "");
  REQUIRE(left.account.friction > 0);
  REQUIRE(left.account.kinetic > 0);
  const Left whole = run(method, left.state);
  REQUIRE(whole.last.taken > 0);
  // `place`: which of those that hold the value. The first curvature is the law's own, by which it tells the error of a
  // step and nothing else.
  const auto refused = [&](const std::string& what, double value, double by, std::size_t place = 0) {
    CAPTURE(what);
    const std::vector<std::size_t> places = places_of(value, left.state);
    REQUIRE(places.size() > place);
    CHECK_THROWS_AS(run(method, altered(left.state, places[place], value * by)), InputError);
  };
  refused("displacement", largest(left.last.u), 1 + 1e-6);
  refused("velocity", largest(left.last.v), 1 + 1e-6);
  refused("curvature", largest(left.strains), 1 + 1e-6, 1);
  refused("kinetic energy of the ledger", left.account.kinetic, 1 + 1e-6);
  refused("elastic energy of the ledger", left.account.elastic, 1 + 1e-6);
  refused("friction that gives", left.account.friction, -1);
  for (const double none : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const std::size_t at = places_of(largest(left.last.u), left.state).front();
    CHECK_THROWS_AS(run(method, altered(left.state, at, none)), FileError);
  }
  // The time stands in many places; some are written anew before they are read.
  std::size_t refusals = 0;
  for (const std::size_t at : places_of(left.last.time, left.state)) {
    for (const double by : {1.01, -1.0, 2.0}) {
      CAPTURE(at);
      CAPTURE(by);
      try {
        const Left other = run(method, altered(left.state, at, left.last.time * by));
        REQUIRE(other.last.u.size() == whole.last.u.size());
        CHECK(other.last.u == whole.last.u);
        CHECK(other.account.external_work == whole.account.external_work);
        CHECK(other.account.viscous.total() == whole.account.viscous.total());
      } catch (const InputError&) {
        ++refusals;
      } catch (const ComputationError&) {
        ++refusals;
      }
    }
  }
  CHECK(refusals >= 3);
}

}  // namespace

TEST_CASE("checkpoint check: generalized alpha does not go on from a state with one number altered") {
  check_refusals(solver::GeneralizedAlpha{.rho_inf = 0.8});
}

TEST_CASE("checkpoint check: IDA does not go on from a state with one number altered" *
          doctest::skip(!solver::ida_has_checkpoints())) {
  check_refusals(solver::Ida{});
}

TEST_CASE("checkpoint check: the memory of the sections has the energy that was written") {
  // Each number of the history of a slipping section, altered on its own: what the law finds again tells most of them.
  const solver::GeneralizedAlpha method{.rho_inf = 0.8};
  const Left left = run(method, "");
  Vibration vibration(test::return_map(model::Freedom::planar), {.length = 10, .elements = 12, .drag = 0.5}, 3);
  const std::size_t numbers = vibration.system.history().data.size();
  Archive size;
  auto count = static_cast<std::uint64_t>(numbers);
  size(count);
  const std::size_t begin = left.state.find(size.bytes());
  REQUIRE(begin != std::string::npos);
  std::size_t changed = 0, refused = 0;
  for (std::size_t i = 0; i < numbers; i += 7) {
    double x = 0;
    char* at = nullptr;
    std::string other = left.state;
    at = other.data() + begin + sizeof count + i * sizeof x;
    std::memcpy(&x, at, sizeof x);
    if (x == 0) continue;
    const double y = 1.5 * x;
    std::memcpy(at, &y, sizeof y);
    ++changed;
    try {
      run(method, other);
    } catch (const InputError&) {
      ++refused;
    } catch (const ComputationError&) {
      ++refused;
    }
  }
  MESSAGE(refused << " of " << changed);
  CHECK(changed > 100);
  CHECK(2 * refused > changed);
}
