#pragma once
/// \file A hard case: what is extreme about it, the bound of physics that must hold there, what was found, what it
/// cost.
///
/// A bound follows from theory: energy does not grow beyond what came in, dissipation is not negative, the answer tends
/// to a known limit, the error falls with the order. None of them is what the program said on another day.

#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace strandyn::extremes {

/// A number that was found, and where it must lie. A number that is not finite lies nowhere.
struct Measure {
  std::string what;
  double value = 0;
  double at_least = -std::numeric_limits<double>::infinity();
  double at_most = std::numeric_limits<double>::infinity();

  bool holds() const { return value >= at_least && value <= at_most && value - value == 0; }
  std::string words() const;  ///< "frequency off by 3.2e-08 <= 1e-06"
};

/// What the extreme takes and what the same takes in an ordinary case, both in `unit`.
struct Cost {
  double extreme = 0, ordinary = 0;
  std::string unit = {};

  double ratio() const { return ordinary > 0 ? extreme / ordinary : 0; }
};

struct Found {
  std::vector<Measure> measures = {};
  Cost cost = {};

  Found& most(std::string what, double value, double limit) {
    measures.push_back({.what = std::move(what), .value = value, .at_most = limit});
    return *this;
  }
  Found& least(std::string what, double value, double limit) {
    measures.push_back({.what = std::move(what), .value = value, .at_least = limit});
    return *this;
  }
  Found& within(std::string what, double value, double low, double high) {
    measures.push_back({.what = std::move(what), .value = value, .at_least = low, .at_most = high});
    return *this;
  }
  /// The relative deviation of `value` from `expected`, which is not zero.
  Found& close(const std::string& what, double value, double expected, double relative);
  Found& costs(Cost c) {
    cost = std::move(c);
    return *this;
  }
};

/// Quick rows end within a second each and are run with every test.
enum class Pace { quick, slow };

struct Extreme {
  std::string name;   ///< theme/what
  std::string what;   ///< is extreme
  std::string bound;  ///< that must hold
  std::function<Found()> run;
  Pace pace = Pace::quick;
};

/// All of them, by theme.
std::vector<Extreme> all_extremes();

/// A row of the table once it has been run.
struct Row {
  Extreme extreme;
  Found found;
  std::string error;  ///< why nothing was found; empty otherwise
  double cpu_s = 0;   ///< of the whole row, its ordinary case included

  bool passed() const;
};

/// The rows whose names contain one of `names`, or all if there are none. `started` hears each name before it runs. A
/// row that throws has failed, and the others still run.
std::vector<Row> run_extremes(const std::vector<std::string>& names,
                              const std::function<void(const std::string&)>& started);
Row run_extreme(const Extreme& extreme);

}  // namespace strandyn::extremes
