// Symmetric loops of curvature at constant tension: masing against return-map, few points around the lay against many.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "ladder.hpp"
#include "strandyn/conductor/catalogue.hpp"
#include "strandyn/exact/full_slip.hpp"
#include "strandyn/section/masing.hpp"
#include "strandyn/section/spatial_return_map.hpp"

namespace strandyn::bench {
namespace {

using section::Component;

constexpr std::array amplitudes = {0.4, 1.0, 2.0};  // chi_max/chi_0

/// A batch that bends in one plane, `direction` [rad] from axis 2; only a spatial law can take one other than 0.
class PlaneOfBending {
 public:
  PlaneOfBending(const section::Law& law, std::span<const double> axial_strains, double direction)
      : law_(law),
        direction_(direction),
        spatial_(law.dimension() == section::Dimension::spatial),
        strains_(law.dimension(), axial_strains.size()),
        stresses_(law.dimension(), axial_strains.size()),
        energy_(axial_strains.size()) {
    std::copy(axial_strains.begin(), axial_strains.end(), strains_[Component::axial].begin());
    history_ = law.start(strains_);
  }
  void bend(std::size_t i, double chi) {
    strains_[Component::bending2][i] = std::cos(direction_) * chi;
    if (spatial_) strains_[Component::bending3][i] = std::sin(direction_) * chi;
  }
  void respond() { law_.respond(history_, strains_, stresses_, nullptr); }
  const section::StepEnergy& commit() {
    law_.commit(history_, strains_, energy_);
    return energy_;
  }
  double moment(std::size_t i) const {
    double M = std::cos(direction_) * stresses_[Component::bending2][i];
    if (spatial_) M += std::sin(direction_) * stresses_[Component::bending3][i];
    return M;
  }

 private:
  const section::Law& law_;
  double direction_;
  bool spatial_;
  section::Field strains_, stresses_;
  section::StepEnergy energy_;
  section::History history_;
};

struct Loop {
  double amplitude = 0;  ///< [1/m]
  double area = 0;       ///< [J/m] trapezoidal work of the second cycle
  double secant = 0;     ///< [N m^2] at its tip
};

/// What a law gives at one tension: the loops at `amplitudes`, and full slip.
struct Answer {
  std::array<Loop, amplitudes.size()> loops;
  double M_inf = 0;  ///< [N m] friction moment where every angle slips
};

/// `chi_0` [1/m] only sets the amplitudes.
Answer answer_of(const section::Law& law, double eps, double chi_0, double EI_min, double direction) {
  constexpr int steps = 400;   // per cycle, from tip to tip
  constexpr double far = 100;  // [1/m]
  constexpr std::size_t n = amplitudes.size();
  Answer answer;
  PlaneOfBending batch(law, std::vector<double>(n + 1, eps), direction);
  batch.bend(n, far);
  batch.respond();
  answer.M_inf = batch.moment(n) - EI_min * far;
  const auto bend = [&](double share) {
    for (std::size_t i = 0; i < n; ++i) batch.bend(i, share * amplitudes[i] * chi_0);
  };
  bend(1);
  batch.commit();
  for (int step = 1; step <= 2 * steps; ++step) {
    bend(std::cos(2 * std::numbers::pi * step / steps));
    const section::StepEnergy& energy = batch.commit();
    for (std::size_t i = 0; i < n && step > steps; ++i) {
      answer.loops[i].area += energy.dissipated[i] - energy.quadrature_error[i];
    }
  }
  batch.respond();
  for (std::size_t i = 0; i < n; ++i) {
    answer.loops[i].amplitude = amplitudes[i] * chi_0;
    answer.loops[i].secant = batch.moment(i) / answer.loops[i].amplitude;
  }
  return answer;
}

/// Differences from a reference in percent.
struct Difference {
  double M_inf = 0;
  std::array<double, amplitudes.size()> area{};
  std::array<double, amplitudes.size()> secant{};
};

Difference difference(const Answer& got, const Answer& reference) {
  const auto percent = [](double a, double b) { return 100 * (a / b - 1); };
  Difference d{.M_inf = percent(got.M_inf, reference.M_inf)};
  for (std::size_t i = 0; i < amplitudes.size(); ++i) {
    d.area[i] = percent(got.loops[i].area, reference.loops[i].area);
    d.secant[i] = percent(got.loops[i].secant, reference.loops[i].secant);
  }
  return d;
}

std::string cell(double percent) {
  if (std::isnan(percent)) return " - |";  // nothing slips in either
  return fmt::format(" {:+.2f} |", std::abs(percent) < 0.005 ? 0.0 : percent);
}

std::string cells(const Difference& d) {
  std::string text = cell(d.M_inf);
  for (double x : d.area) text += cell(x);
  for (double x : d.secant) text += cell(x);
  return text;
}

/// Of either sign, whichever is larger.
void take_larger(Difference& most, const Difference& d) {
  const auto take = [](double& kept, double x) {
    if (std::abs(x) > std::abs(kept) || std::isnan(kept)) kept = x;
  };
  take(most.M_inf, d.M_inf);
  for (std::size_t i = 0; i < amplitudes.size(); ++i) {
    take(most.area[i], d.area[i]);
    take(most.secant[i], d.secant[i]);
  }
}

void print_head(std::string_view title, std::string_view first_columns) {
  fmt::print("\n{}\n\n| {} | chi_0 |", title, first_columns);
  for (const char* what : {"area", "secant"}) {
    for (double a : amplitudes) fmt::print(" {} {} |", what, a);
  }
  const auto columns = 2 + std::count(first_columns.begin(), first_columns.end(), '|') + 2 * amplitudes.size();
  fmt::print("\n|");
  for (std::size_t i = 0; i < columns; ++i) fmt::print(" --- |");
  fmt::print("\n");
}

}  // namespace

void print_masing_tables() {
  constexpr std::array etas = {0.05, 0.1, 0.15, 0.2, 0.3, 0.4};
  print_head("`masing` less `return-map` (72 points), percent; area and secant at chi_max/chi_0.", "conductor | eta");
  Difference largest;
  for (const conductor::CatalogueEntry& entry : conductor::catalogue()) {
    const conductor::Strand strand = catalogue_strand(entry.name);
    const section::MasingLaw masing(strand);
    const section::PlanarReturnMap return_map(strand, 72);
    const double EI_min = conductor::section_constants(strand).EI_min;
    // Without residual forces every limit is proportional to the tension: rows that print alike are one row.
    std::string row;
    std::vector<double> alike;
    const auto print_row = [&] {
      if (alike.empty()) return;
      const std::string range =
          alike.size() > 1 ? fmt::format("{} .. {}", alike.front(), alike.back()) : fmt::format("{}", alike.front());
      fmt::print("| {} | {} |{}\n", entry.name, range, row);
      alike.clear();
    };
    for (double eta : etas) {
      const double eps = strain_at(strand, eta);
      const double chi_0 = exact::full_slip(strand, eta * strand.rated_strength).chi_0;
      const Difference d =
          difference(answer_of(masing, eps, chi_0, EI_min, 0), answer_of(return_map, eps, chi_0, EI_min, 0));
      take_larger(largest, d);
      if (cells(d) != row) print_row();
      row = cells(d);
      alike.push_back(eta);
    }
    print_row();
  }
  fmt::print("| largest | |{}\n", cells(largest));
}

void print_points_tables() {
  const conductor::Strand strand = catalogue_strand("curlew");
  const double EI_min = conductor::section_constants(strand).EI_min;
  print_head("Points around the lay against 720, Curlew, percent; area and secant at chi_max/chi_0.",
             "path | eta | points");
  const section::PlanarReturnMap finest(strand, 720);
  for (double eta : {0.15, 0.4}) {
    const double eps = strain_at(strand, eta);
    const double chi_0 = exact::full_slip(strand, eta * strand.rated_strength).chi_0;
    const Answer reference = answer_of(finest, eps, chi_0, EI_min, 0);
    for (int points : {20, 36, 72}) {
      const section::PlanarReturnMap law(strand, points);
      fmt::print("| planar | {} | {} |{}\n", eta, points,
                 cells(difference(answer_of(law, eps, chi_0, EI_min, 0), reference)));
    }
    for (int points : {20, 36, 72}) {
      const section::SpatialReturnMap law(strand, {.points = points, .axial_resultants = false});
      fmt::print("| between two grid directions | {} | {} |{}\n", eta, points,
                 cells(difference(answer_of(law, eps, chi_0, EI_min, std::numbers::pi / points), reference)));
    }
  }
}

}  // namespace strandyn::bench
