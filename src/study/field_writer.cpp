#include "field_writer.hpp"

#include <algorithm>
#include <cmath>

#include "cross_section.hpp"
#include "strandyn/build/section_law.hpp"
#include "strandyn/results/writing.hpp"

namespace strandyn::study {

using enum section::Component;

namespace {

constexpr const char* file_name = "fields.vtkhdf";
constexpr std::size_t moments_between_flushes = 50;

/// `fields` of summary.json.
struct FieldsRow {
  std::string file;
  std::size_t moments = 0;
  double every = 0;
};
template <class V>
void members(V& v, FieldsRow& f) {
  v.value("file", f.file, {.what = "the file of the moving span, VTKHDF"});
  v.value("moments", f.moments, {.what = "how many it holds"});
  v.value("every_s", f.every, {.what = "the time between them"});
}
struct FieldsSummary {
  FieldsRow fields;
};
template <class V>
void members(V& v, FieldsSummary& f) {
  v.record("fields", f.fields, {.what = "the moving span as a file, with [output]"});
}

/// The two section points of an element.
template <class F>
std::vector<double> mean_of_elements(std::size_t elements, const F& at_point) {
  std::vector<double> means;
  for (std::size_t e = 0; e < elements; ++e) {
    double sum = 0;
    for (std::size_t g = 0; g < beam::gauss_points; ++g) sum += at_point(e * beam::gauss_points + g);
    means.push_back(sum / beam::gauss_points);
  }
  return means;
}

double bending(const section::Field& field, std::size_t point) {
  return field[bending3].empty() ? field[bending2][point] : std::hypot(field[bending2][point], field[bending3][point]);
}

}  // namespace

FieldWriter::FieldWriter(const casefile::Scene& scene, const Hooks& hooks, double frequency)
    : has_wires_(build::has_wires(scene.section.law)) {
  if (!hooks.folder.empty()) path_ = hooks.folder / file_name;
  every_ = scene.output->every ? *scene.output->every : 1 / (frequency * *scene.output->per_cycle);
}

results::Moment FieldWriter::moment_of(const system::System& system, const observe::StepRecord& record) const {
  const model::Model& model = system.model();
  results::FieldArray displacement{.name = "displacement", .components = 3}, velocity = displacement;
  velocity.name = "velocity";
  for (std::size_t node = 0; node < model.nodes.size(); ++node) {
    const Eigen::Vector3d u = model.displacement(record.u.data(), node), v = model.displacement(record.v.data(), node);
    displacement.values.insert(displacement.values.end(), u.begin(), u.end());
    velocity.values.insert(velocity.values.end(), v.begin(), v.end());
  }
  const std::size_t elements = model.elements.size();
  const section::Field &strains = system.committed_strains(), &stresses = system.last_stresses();
  const auto field = [&](const char* name, const auto& at_point) {
    return results::FieldArray{.name = name, .values = mean_of_elements(elements, at_point)};
  };
  results::Moment moment{
      .time = record.time, .at_points = {std::move(displacement), std::move(velocity)}, .in_cells = {}};
  moment.in_cells.push_back(field("tension", [&](std::size_t p) { return stresses[axial][p]; }));
  moment.in_cells.push_back(field("moment", [&](std::size_t p) { return bending(stresses, p); }));
  moment.in_cells.push_back(field("curvature", [&](std::size_t p) { return bending(strains, p); }));
  if (has_wires_) {
    moment.in_cells.push_back(field("slip_fraction", [&](std::size_t p) {
      return slipping_share(model.law->wires(system.history(), strains, p));
    }));
  }
  moment.in_cells.push_back(field("dissipated_J_per_m", [&](std::size_t p) { return dissipated_[p]; }));
  return moment;
}

void FieldWriter::begin(const system::System& system, const observe::StepRecord& initial) {
  for (const Eigen::Vector3d& node : system.model().nodes) nodes_.push_back({node.x(), node.y(), node.z()});
  dissipated_.assign(system.committed_strains().points(), 0.0);
  initial_ = moment_of(system, initial);
  due_ = 1;
}

void FieldWriter::step(const system::System& system, const observe::StepRecord& record) {
  const section::StepEnergy& energy = system.step_energy();
  const auto& metal = system.material();
  for (std::size_t point = 0; point < dissipated_.size(); ++point) {
    dissipated_[point] += energy.dissipated[point];
    if (!metal.is_empty()) dissipated_[point] += metal.dissipated()[point];
  }
  constexpr double rounding = 1e-6;
  if (record.time < static_cast<double>(due_) * every_ * (1 - rounding)) return;
  due_ = static_cast<std::size_t>(record.time / every_ + rounding) + 1;
  if (!path_.empty()) put(moment_of(system, record));
}

void FieldWriter::put(const results::Moment& moment) {
  const results::Writing writing;
  if (!file_) {
    file_ = std::make_unique<results::VtkHdfFile>(path_, nodes_, kept_);
    if (kept_ == 0) file_->add(*initial_);
    file_->flush();
  }
  file_->add(moment);
  if (file_->moments() % moments_between_flushes == 0) file_->flush();
}

void FieldWriter::archive(Archive& a) {
  if (file_) file_->flush();
  std::size_t kept = file_ ? file_->moments() : kept_;
  a(due_, kept, dissipated_);
  if (a.reads()) kept_ = kept;
}

void FieldWriter::end(Outcome& outcome) {
  if (!file_) return;
  file_->flush();
  outcome.tell(FieldsSummary{.fields = {.file = file_name, .moments = file_->moments(), .every = every_}});
  outcome.written.emplace_back(file_name);
  file_.reset();
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(path_, error);
  if (!error) results::Writing::count(bytes);
}

std::vector<results::MemberNote> FieldWriter::notes() {
  return results::ReferenceWriter::of<FieldsSummary>();
}

void check_output(const casefile::Scene& scene) {
  if (!scene.output || results::VtkHdfFile::is_available()) return;
  refuse(scene.source, "output", "writes HDF5, and this program was built without it",
         "build it where libhdf5-dev is installed, or remove the table");
}

}  // namespace strandyn::study
