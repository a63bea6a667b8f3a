#include "strandyn/core/kept_rows.hpp"

#include <doctest/doctest.h>

#include <cmath>

using strandyn::KeptRows;

TEST_CASE("a run of any length leaves few rows, evenly spaced, with the first and the last") {
  for (const std::size_t count : {1U, 2U, 10U, 11U, 12U, 100U, 1000U, 12345U}) {
    CAPTURE(count);
    KeptRows<double> kept({}, 10);
    for (std::size_t step = 0; step < count; ++step)
      kept.add(static_cast<double>(step), 0.5 * static_cast<double>(step));
    const auto rows = kept.rows();
    CHECK(rows.size() <= 12);
    CHECK(rows.size() >= std::min<std::size_t>(count, 6));
    CHECK(rows.front().step == 0);
    CHECK(rows.back().step == count - 1);
    CHECK(kept.last() == 0.5 * static_cast<double>(count - 1));
    CHECK(kept.count() == count);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      CHECK(rows[i].row == 0.5 * static_cast<double>(rows[i].step));
      if (i + 1 < rows.size()) CHECK(rows[i].step == i * kept.stride());
    }
  }
}

TEST_CASE("a time between rows is kept to, whatever the steps and however many rows") {
  KeptRows<double> kept(0.1, 5);
  const double step = 1.0 / 300;
  for (int i = 0; i <= 900; ++i) kept.add(i * step, i * step);
  const auto rows = kept.rows();
  REQUIRE(rows.size() == 31);
  for (std::size_t i = 0; i < rows.size(); ++i) CHECK(std::abs(rows[i].row - 0.1 * static_cast<double>(i)) < 1e-9);

  KeptRows<double> coarse(0.1);  // steps longer than the time asked for: every one
  for (int i = 0; i <= 10; ++i) coarse.add(0.25 * i, 0);
  CHECK(coarse.rows().size() == 11);
}
