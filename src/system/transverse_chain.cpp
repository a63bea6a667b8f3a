#include "chain.hpp"
#include "strandyn/beam/planar_inertia.hpp"

namespace strandyn::system {

using beam::gauss_points;
using beam::gauss_position;
using enum section::Component;

namespace {

/// A straight span that moves across its line only, in one or two planes. Without axial inertia the tension is the same
/// everywhere, and so is the axial strain:
///     L0 eps = L - L0 + sum over elements and planes of [ l phi^2/2 + l0 (2 t1^2 - t1 t2 + 2 t2^2)/30 ]
/// phi the slope of the chord (small), t_i = theta_i - phi. It is the planar element's strain for small slopes, summed.
/// The one strain couples all nodes: an update of rank one of the stiffness.
///
/// In each plane w is the deflection and theta = dw/dx; about y the rotation of the node is -theta.
template <int Planes>
class TransverseChain final : public Chain {
 public:
  explicit TransverseChain(const model::Model& model)
      : consistent_(model.mass_matrix == model::MassMatrix::consistent),
        lumped_(Vector::Zero(static_cast<Eigen::Index>(model.unknowns()))),
        elements_(model.elements.size()) {
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      elements_[e].chord = model.elements[e].span.norm();
      elements_[e].length = model.elements[e].length;
      if (consistent_) elements_[e].mass = mass_table(elements_[e], model.inertia.mass);
      unstressed_ += elements_[e].length;
      excess_ += elements_[e].chord - elements_[e].length;
      for (std::size_t node : {e, e + 1}) {
        for (int p = 0; p < Planes; ++p) {
          lumped_(deflection(node, p)) += consistent_ ? 0 : model.inertia.mass * elements_[e].length / 2;
          lumped_(rotation(node, p)) += model.inertia.rotary * elements_[e].length / 2;
        }
      }
    }
    for (const model::Body& body : model.bodies) {
      for (int p = 0; p < Planes; ++p) {
        lumped_(deflection(body.node, p)) += body.mass;
        lumped_(rotation(body.node, p)) += body.inertia;
      }
    }
  }

  section::Dimension dimension() const override {
    return Planes == 1 ? section::Dimension::planar : section::Dimension::spatial;
  }

  void find_strains(const double* u, section::Field& strains) override {
    double elongation = excess_;
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      Element& el = elements_[e];
      for (int p = 0; p < Planes; ++p) {
        const double slope = (u[deflection(e + 1, p)] - u[deflection(e, p)]) / el.chord;
        const double t1 = hand(p) * u[rotation(e, p)] - slope;
        const double t2 = hand(p) * u[rotation(e + 1, p)] - slope;
        el.bend[p] = {.slope = slope, .t1 = t1, .t2 = t2};
        elongation += el.chord * slope * slope / 2 + el.length * (2 * t1 * t1 - t1 * t2 + 2 * t2 * t2) / 30;
        AlignedVector& chi = strains[bending(p)];
        for (std::size_t g = 0; g < gauss_points; ++g) {
          const auto c = curvature_slope(g);
          chi[e * gauss_points + g] = hand(p) * (c[0] * t1 + c[1] * t2) / el.length;
        }
      }
    }
    const double eps = elongation / unstressed_;
    for (std::size_t point = 0; point < strains.points(); ++point) strains[axial][point] = eps;
  }

  void add_internal_force(const section::Field& stresses, double* f) const override {
    const double tension = mean_over_length(stresses[axial]);
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      const Element& el = elements_[e];
      for (int p = 0; p < Planes; ++p) {
        Local force = pull(el, p) * tension;
        for (std::size_t g = 0; g < gauss_points; ++g) {
          force += hand(p) * beam::gauss_weight * stresses[bending(p)][e * gauss_points + g] * bend_row(el, g);
        }
        add_local(force, e, p, f);
      }
    }
  }

  void add_stiffness(const section::Field& stresses, const section::TangentField& tangents, Matrix& K) const override {
    auto& blocks = K.as<B>();
    const double tension = mean_over_length(stresses[axial]);
    const double EA = mean_over_length(tangents(axial, axial));
    auto& update = K.update().emplace();
    update.row = Vector::Zero(lumped_.size());
    update.column = update.row;
    Vector by_strain = update.row;  // d f/d eps through the moments
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      const Element& el = elements_[e];
      Eigen::Matrix<double, 2 * B, 2 * B> k = Eigen::Matrix<double, 2 * B, 2 * B>::Zero();
      for (int p = 0; p < Planes; ++p) {
        add_local(pull(el, p), e, p, update.row.data());
        add_block(tension * pull_slope(el), p, p, k);
        for (std::size_t g = 0; g < gauss_points; ++g) {
          const std::size_t point = e * gauss_points + g;
          const Local row = hand(p) * bend_row(el, g);
          const double w = beam::gauss_weight;
          add_local(w * tangents(bending(p), axial)[point] * row, e, p, by_strain.data());
          for (int other = 0; other < Planes; ++other) {
            const Local column = hand(other) * bend_row(el, g) / el.length;
            add_block(w * tangents(bending(p), bending(other))[point] * row * column.transpose(), p, other, k);
          }
        }
      }
      blocks.add_element(e, k);
    }
    update.column = EA * update.row + by_strain;
    update.row /= unstressed_;
  }

  void add_inertia_force(const State& m, double* f) const override {
    for (Eigen::Index i = 0; i < lumped_.size(); ++i) f[i] += lumped_(i) * m.a[i];
    if (!consistent_) return;
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      for (int p = 0; p < Planes; ++p) add_local(elements_[e].mass * local(m.a, e, p), e, p, f);
    }
  }

  void add_inertia_tangent(const State&, InertiaFactors factors, Matrix& K) const override {
    add_mass_times(factors.acceleration, K);
  }

  void add_mass(const double*, Matrix& M) const override { add_mass_times(1, M); }

  double kinetic_energy(const double*, const double* v) const override {
    double sum = 0;
    for (Eigen::Index i = 0; i < lumped_.size(); ++i) sum += lumped_(i) * v[i] * v[i];
    if (!consistent_) return sum / 2;
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      for (int p = 0; p < Planes; ++p) {
        const Local rate = local(v, e, p);
        sum += rate.dot(elements_[e].mass * rate);
      }
    }
    return sum / 2;
  }

  bool has_mass(std::size_t i) const override { return consistent_ || lumped_(static_cast<Eigen::Index>(i)) > 0; }

  void add_moment(std::size_t node, const Eigen::Vector3d& moment, const double*, double* f) const override {
    for (int p = 0; p < Planes; ++p) f[rotation(node, p)] += moment(2 - p);
  }

 private:
  static constexpr int B = 2 * Planes;
  using Local = Eigen::Vector4d;  // of one element and plane: w1, rotation 1, w2, rotation 2
  struct Bend {
    double slope = 0, t1 = 0, t2 = 0;
  };
  struct Element {
    double chord = 0;   // [m] in the reference configuration
    double length = 0;  // [m] unstressed
    std::array<Bend, Planes> bend{};
    Eigen::Matrix4d mass;  // [kg], [kg m], [kg m^2] consistent, of the unknowns of one plane
  };

  // Plane 0 is x-y: w = y, the rotation is about z. Plane 1 is x-z: w = z, the rotation about y is -dw/dx.
  static Eigen::Index deflection(std::size_t node, int p) { return static_cast<Eigen::Index>(node) * B + p; }
  static Eigen::Index rotation(std::size_t node, int p) { return static_cast<Eigen::Index>(node) * B + B - 1 - p; }
  static double hand(int p) { return p == 0 ? 1.0 : -1.0; }
  static section::Component bending(int p) { return Planes == 2 && p == 0 ? bending3 : bending2; }

  static std::array<double, 2> curvature_slope(std::size_t g) {
    return {6 * gauss_position[g] - 4, 6 * gauss_position[g] - 2};
  }
  /// d(t1, t2)/d(local): the rotations minus the slope of the chord.
  static Eigen::Matrix<double, 2, 4> turn(const Element& el) {
    Eigen::Matrix<double, 2, 4> d;
    d << 1, el.chord, -1, 0, 1, 0, -1, el.chord;
    return d / el.chord;
  }
  /// l0 d chi/d(local) at Gauss point g.
  static Local bend_row(const Element& el, std::size_t g) {
    const auto c = curvature_slope(g);
    return turn(el).transpose() * Eigen::Vector2d(c[0], c[1]);
  }
  /// d(L0 eps)/d(local).
  static Local pull(const Element& el, int p) {
    const Bend& b = el.bend[static_cast<std::size_t>(p)];
    const Eigen::Vector2d slope((4 * b.t1 - b.t2) / 30, (4 * b.t2 - b.t1) / 30);
    return b.slope * Local(-1, 0, 1, 0) + el.length * turn(el).transpose() * slope;
  }
  /// d^2(L0 eps)/d(local)^2.
  static Eigen::Matrix4d pull_slope(const Element& el) {
    const Local chord(-1, 0, 1, 0);
    Eigen::Matrix2d table;
    table << 4, -1, -1, 4;
    return chord * chord.transpose() / el.chord + el.length / 30 * turn(el).transpose() * table * turn(el);
  }
  /// The planar element's mass across the line of the undeflected span.
  static Eigen::Matrix4d mass_table(const Element& el, double mass) {
    const beam::PlanarElement straight{.span = {el.chord, 0}, .length = el.length, .rest_angle = 0};
    const beam::PlanarMatrix m =
        beam::consistent_mass(straight, {.mass = mass, .rotary = 0}, beam::PlanarVector::Zero());
    constexpr std::array across = {1, 2, 4, 5};
    return m(across, across);
  }

  /// Local vectors count rotations as dw/dx; the node's rotation about y has the other sign.
  static void add_local(const Local& force, std::size_t e, int p, double* f) {
    f[deflection(e, p)] += force(0);
    f[rotation(e, p)] += hand(p) * force(1);
    f[deflection(e + 1, p)] += force(2);
    f[rotation(e + 1, p)] += hand(p) * force(3);
  }
  static Local local(const double* all, std::size_t e, int p) {
    return {all[deflection(e, p)], hand(p) * all[rotation(e, p)], all[deflection(e + 1, p)],
            hand(p) * all[rotation(e + 1, p)]};
  }
  template <class Block>
  static void add_block(const Eigen::Matrix4d& k, int row_plane, int column_plane, Block& block) {
    const auto place = [](int i, int p) {
      const std::size_t node = i < 2 ? 0 : 1;
      return i % 2 == 0 ? deflection(node, p) : rotation(node, p);
    };
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        const double sign = (i % 2 ? hand(row_plane) : 1) * (j % 2 ? hand(column_plane) : 1);
        block(place(i, row_plane), place(j, column_plane)) += sign * k(i, j);
      }
    }
  }
  void add_mass_times(double factor, Matrix& K) const {
    auto& blocks = K.as<B>();
    for (std::size_t node = 0; node < blocks.nodes(); ++node) {
      blocks.diagonal(node).diagonal() += factor * lumped_.template segment<B>(static_cast<Eigen::Index>(node) * B);
    }
    if (!consistent_) return;
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      Eigen::Matrix<double, 2 * B, 2 * B> m = Eigen::Matrix<double, 2 * B, 2 * B>::Zero();
      for (int p = 0; p < Planes; ++p) add_block(factor * elements_[e].mass, p, p, m);
      blocks.add_element(e, m);
    }
  }
  double mean_over_length(const AlignedVector& value) const {
    double sum = 0;
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      for (std::size_t g = 0; g < gauss_points; ++g) {
        sum += beam::gauss_weight * elements_[e].length * value[e * gauss_points + g];
      }
    }
    return sum / unstressed_;
  }

  bool consistent_;
  Vector lumped_;  // [kg], [kg m^2] what sits at the nodes
  std::vector<Element> elements_;
  double unstressed_ = 0;  // [m] L0
  double excess_ = 0;      // [m] L - L0
};

}  // namespace

std::unique_ptr<Chain> make_transverse_chain(const model::Model& model) {
  if (model.freedom == model::Freedom::transverse_planar) return std::make_unique<TransverseChain<1>>(model);
  return std::make_unique<TransverseChain<2>>(model);
}

}  // namespace strandyn::system
