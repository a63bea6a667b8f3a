#include "strandyn/study/run_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

#include "parts.hpp"
#include "strandyn/casefile/echo.hpp"
#include "strandyn/section/return_map.hpp"
#include "strandyn/version.hpp"

namespace strandyn::study {

using casefile::AnalysisType;
using json = nlohmann::ordered_json;

namespace {

json program() {
  const section::VectorTarget target = section::vector_target();
  return {{"name", "strandyn"},           {"version", program_version}, {"revision", program_revision},
          {"compiler", program_compiler}, {"simd", target.name},        {"simd_doubles", target.lanes}};
}

void analyse(const casefile::Scene& scene, const Hooks& hooks, CaseResult& result) {
  switch (scene.analysis.type) {
    case AnalysisType::section:
      return run_section(scene, result);
    case AnalysisType::axial_torsion:
      return run_axial_torsion(scene, result);
    case AnalysisType::static_:
      return run_static(scene, hooks, result);
    case AnalysisType::modes:
      return run_modes(scene, result);
    case AnalysisType::decay:
    case AnalysisType::forced:
      return run_vibration(scene, hooks, result);
    case AnalysisType::transient:
      return run_transient(scene, hooks, result);
    case AnalysisType::sweep:
      return run_sweep(scene, hooks, result);
    case AnalysisType::self_damping:
      return run_self_damping(scene, hooks, result);
  }
}

/// How many times more steps bring the integrator's share below `bound`. Its own damping falls with the third power of
/// the step, the energy error of the trapezoidal rule with the second. The quadrature error is part of the remainder,
/// with a minus; it falls a little faster than with the first power, since slip begins and ends within steps.
double more_steps(const casefile::Integrator& integrator, double numerical, double quadrature, double allowed) {
  const double damping = std::abs(numerical + quadrature) / allowed;
  const double own = integrator.method == casefile::Method::ida ? std::cbrt(damping) : std::sqrt(damping);
  return std::max(own, quadrature / allowed);
}

/// The share of the integrator in what is lost, against the bound that the case sets.
void check_numerical_share(const casefile::Scene& scene, CaseResult& result) {
  const auto& asked = scene.integrator.max_numerical_share;
  const bool applies = asked || (result.summary.contains("cycles") &&
                                 result.summary["cycles"].size() >= casefile::cycles_of_default_share);
  if (!applies) return;
  if (result.exit_code != ExitCode::done) return;
  const double bound = asked.value_or(casefile::default_numerical_share);
  const bool transient = result.summary.contains("energy");
  if (!transient && !result.summary.contains("steady")) return;
  const json& account = result.summary[transient ? "energy" : "steady"];
  if (!account.contains("numerical_share")) return;
  const double share = account["numerical_share"];
  if (share <= bound) return;
  const double numerical = account["numerical_dissipation_J"];
  const double more =
      more_steps(scene.integrator, numerical, account["quadrature_error_J"], bound * std::abs(numerical) / share);
  const json& plan = result.summary["plan"];
  std::string remedy;
  if (scene.integrator.step == casefile::StepRule::adaptive) {
    remedy = "give a smaller integrator.rtol, or integrator.step = \"fixed\"";
  } else if (transient) {
    remedy = fmt::format("about integrator.step_s = {:.2g} would hold it", 0.95 * plan["step_s"].get<double>() / more);
  } else {
    const double steps = std::ceil(1.05 * more * plan["steps_per_cycle"].get<double>() / 10) * 10;
    remedy = fmt::format("about integrator.steps_per_cycle = {:.0f} would hold it", steps);
  }
  result.exit_code = ExitCode::not_converged;
  result.message = fmt::format(
      "the integrator's own damping is {:.3g} of the physical dissipation{}, above the case's bound "
      "integrator.max_numerical_share = {:.3g}; {}",
      share, transient ? "" : " over the last cycles", bound, remedy);
}

/// Is the case run as it was written? What [accept] promises holds for that; an override of [accept] itself is meant.
bool acceptance_applies(const casefile::Scene& scene) {
  bool changed = false;
  for (const auto& [path, entry] : scene.source.entries) {
    if (!entry.overridden) continue;
    if (path.starts_with("accept")) return true;
    changed = true;
  }
  return !changed;
}

void judge_acceptance(const casefile::Scene& scene, CaseResult& result) {
  result.verdicts = casefile::judge(scene.accept, result.summary, static_cast<int>(result.exit_code));
  std::size_t failed = 0;
  for (const casefile::Verdict& verdict : result.verdicts) failed += verdict.passed ? 0 : 1;
  if (failed == 0 || result.exit_code != ExitCode::done) return;
  if (!acceptance_applies(scene)) {
    result.summary["warnings"].push_back(
        fmt::format("{} of the case's {} [accept] entries fail; they speak of the case without --set and do not decide "
                    "the exit code",
                    failed, result.verdicts.size()));
    return;
  }
  result.exit_code = ExitCode::not_converged;
  result.message = fmt::format("{} of the case's {} [accept] entries failed", failed, result.verdicts.size());
}

json verdicts_json(const std::vector<casefile::Verdict>& verdicts) {
  json list = json::array();
  for (const casefile::Verdict& v : verdicts) {
    list.push_back(
        {{"path", v.path}, {"found", v.found}, {"wanted", v.wanted}, {"passed", v.passed}, {"reason", v.reason}});
    if (!v.source.empty()) list.back()["source"] = v.source;
  }
  return list;
}

const char* status_word(ExitCode code) {
  if (code == ExitCode::done) return "done";
  return code == ExitCode::interrupted ? "interrupted" : "failed";
}

}  // namespace

json section_json(const build::SectionNumbers& n) {
  return {
      {"EA_N", n.EA}, {"GJ_N_m2", n.GJ}, {"C_AT_N_m", n.C_AT}, {"EI_min_N_m2", n.EI_min}, {"EI_max_N_m2", n.EI_max}};
}

void add_effort(const system::System& system, json& cost) {
  cost["residual_evaluations"] = system.residual_evaluations();
  cost["jacobian_evaluations"] = system.jacobian_evaluations();
  cost["section_evaluations"] = system.effort().evaluations;
  cost["section_sweeps"] = system.effort().sweeps;
}

CaseResult run_case(const casefile::Scene& scene, const Hooks& hooks) {
  const auto wall_start = std::chrono::steady_clock::now();
  const std::clock_t cpu_start = std::clock();

  CaseResult result;
  json& s = result.summary;
  s["title"] = scene.title;
  s["status"] = "";  // set at the end; stands here so that it is read first
  s["program"] = program();
  s["case"] = casefile::case_as_run(scene);
  s["section"] = section_json(build::section_numbers(scene));
  s["cost"] = {{"wall_s", 0.0},
               {"cpu_s", 0.0},
               {"steps", 0},
               {"rejected_steps", 0},
               {"order_one_steps", 0},
               {"residual_evaluations", 0},
               {"jacobian_evaluations", 0},
               {"section_evaluations", 0},
               {"section_sweeps", 0}};
  s["warnings"] = json::array();
  analyse(scene, hooks, result);

  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - wall_start;
  s["cost"]["wall_s"] = wall.count();
  s["cost"]["cpu_s"] = static_cast<double>(std::clock() - cpu_start) / CLOCKS_PER_SEC;
  check_numerical_share(scene, result);
  judge_acceptance(scene, result);
  s["status"] = status_word(result.exit_code);
  if (!result.message.empty()) s["message"] = result.message;
  if (!result.verdicts.empty()) s["accept"] = verdicts_json(result.verdicts);
  return result;
}

}  // namespace strandyn::study
