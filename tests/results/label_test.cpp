#include "strandyn/results/label.hpp"

#include <doctest/doctest.h>

using strandyn::results::is_share;
using strandyn::results::label_of;
using strandyn::results::labels_of;

namespace {

std::vector<std::string> names_of(const std::vector<std::string>& keys) {
  std::vector<std::string> names;
  for (const auto& label : labels_of(keys)) names.push_back(label.name);
  return names;
}

}  // namespace

TEST_CASE("label: the unit of a key is taken off, the longest that fits") {
  const auto check = [](std::string_view key, std::string_view name, std::string_view unit) {
    const auto label = label_of(key);
    CHECK(label.name == name);
    CHECK(label.unit == unit);
  };
  check("friction_dissipation_J", "friction dissipation", "J");
  check("self_damping_W_per_m", "self damping", "W/m");
  check("EI_min_N_m2", "EI_min", "N m²");
  check("C_AT_N_m", "C_AT", "N m");
  check("chi_0_per_m", "chi_0", "1/m");
  check("k2_per_m", "k2", "1/m");
  check("antinode_amplitude_m", "antinode amplitude", "m");
  check("loss_factor", "loss factor", "");
  check("m", "m", "");
  check("t_s", "time", "s");
  check("steady.friction_J", "steady.friction", "J");
  check("displacement_m.min", "displacement min", "m");
  check("impulse_N_s", "impulse", "N s");
  check("linear_kg_m_per_s", "linear", "kg m/s");
}

TEST_CASE("label: parts of an energy are named by what sets them apart, other keys by all of their words") {
  CHECK(names_of({"external_work_J", "friction_dissipation_J", "numerical_dissipation_J"}) ==
        std::vector<std::string>{"external work", "friction", "numerical"});
  CHECK(names_of({"antinode_amplitude_m", "balance_amplitude_m"}) ==
        std::vector<std::string>{"antinode amplitude", "balance amplitude"});
  CHECK(names_of({"friction_loss_J", "friction_dissipation_J", "viscous_loss_J", "viscous_dissipation_J"}) ==
        std::vector<std::string>{"friction loss", "friction dissipation", "viscous loss", "viscous dissipation"});
  CHECK(labels_of({}).empty());
}

TEST_CASE("label: a share is known by its last word") {
  CHECK(is_share("share"));
  CHECK(is_share("steady.numerical_share"));
  CHECK(is_share("steady.share"));
  CHECK_FALSE(is_share("shares"));
  CHECK_FALSE(is_share("shareholder"));
}
