#pragma once
/// \file `type = "tradeoff"`: error against cost of another case over all combinations of some of its settings.

#include <string>
#include <string_view>
#include <vector>

#include "strandyn/casefile/acceptance.hpp"
#include "strandyn/casefile/declare.hpp"

namespace strandyn::casefile {

/// [[analysis.knob]]: a key of the base and what it is set to, from coarse to fine.
struct KnobKeys {
  std::string key;
  std::vector<Scalar> values;  ///< the last is the reference's
};

template <class V>
void keys(V& v, KnobKeys& k) {
  v.text("key", k.key, {.help = "a key of the base, such as \"span.elements\"", .required = true});
  v.scalars("values", k.values,
            {.help = "what it is set to, from coarse to fine, numbers, words, true or false; the last is that of the "
                     "reference",
             .required = true});
}

struct TradeoffAnalysis {
  static constexpr std::string_view word = "tradeoff";
  std::string base;      ///< the file, beside this one
  std::string quantity;  ///< a path into the summary of the base
  std::vector<KnobKeys> knobs;
  std::vector<double> targets = {0.1, 0.02, 0.002};  ///< [-]
};

template <class V>
void keys(V& v, TradeoffAnalysis& t) {
  v.text("base", t.base,
         {.help = "the case file that is run with the settings, by its path from this one", .required = true});
  v.text("quantity", t.quantity,
         {.help = "the number whose error counts, as a path into the summary of the base such as "
                  "\"steady.friction_dissipation_J\"",
          .required = true});
  v.tables("knob", t.knobs, {.help = "a setting that is varied", .required = true});
  v.numbers(
      "targets", t.targets,
      {.help = "relative errors for each of which the cheapest setting is named (0.1, 0.02 and 0.002 unless given)",
       .above = 0});
}

}  // namespace strandyn::casefile
