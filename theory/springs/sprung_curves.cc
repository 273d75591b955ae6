#include "theory/springs/sprung_curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>
#include <optional>
#include <utility>

#include "contact/base/special_values.h"

namespace tricontact::theory {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr int n_curve_elements = 24;

/// The law's bound as a function of the pressure.
double bound_of(const contact::Friction& f, double pressure) {
    const double p = std::max(0., pressure);
    double rising = f.coefficient.value_or(0) * p;
    if (f.pressure_exponent && f.coefficient)
        rising = *f.coefficient * *f.reference_pressure *
                 std::pow(p / *f.reference_pressure, *f.pressure_exponent);
    return std::min(f.shear_strength.value_or(0) + rising,
                    f.strength_limit.value_or(contact::infinity));
}

/// Of the pressure p: what the law carries at the edge, and g of what it carries above that.
struct Bound {
    double at_edge = 0;
    VectorXd g;
};

Bound bound_of(const AbelElements& on, const contact::Friction& friction,
               const VectorXd& pressing) {
    Bound bound{.at_edge = bound_of(friction, 0.)};
    const bool is_linear = friction.pressure_exponent.value_or(1) == 1 && !friction.strength_limit;
    if (is_linear)
        bound.g = friction.coefficient.value_or(0) * pressing;
    else
        bound.g = on.of_function(pressing,
                                 [&](double p) { return bound_of(friction, p) - bound.at_edge; });
    return bound;
}

/// A matrix by triangles L U, without pivots, so that its leading blocks are those of theirs.
/// Springs add to a diagonal that is positive, below it are the bodies.
class LeadingBlocks {
  public:
    explicit LeadingBlocks(Eigen::MatrixXd matrix) : both_(std::move(matrix)) {
        const Index n = both_.rows();
        for (Index k = 0; k + 1 < n; ++k) {
            const Index left = n - k - 1;
            both_.col(k).tail(left) /= both_(k, k);
            both_.bottomRightCorner(left, left).noalias() -=
                both_.col(k).tail(left) * both_.row(k).tail(left);
        }
    }

    /// Of the leading block whose size is that of `right`.
    VectorXd solve(VectorXd right) const {
        const auto block = both_.topLeftCorner(right.size(), right.size());
        block.triangularView<Eigen::UnitLower>().solveInPlace(right);
        block.triangularView<Eigen::Upper>().solveInPlace(right);
        return right;
    }

  private:
    Eigen::MatrixXd both_;
};

/// Curve of shifts over forces, with radii over a and g over a: at each `stride`-th node as the
/// edge of stick u + t/k_t = U inside and t = bound outside. `soft`, `bodies`: 1/k_t and a/G*
/// [m/Pa].
SprungCurve curve_of(const AbelElements& on, const Bound& bound, double soft, double bodies,
                     const LayerCorrection* layer, Index stride) {
    const Index n = on.n;
    Eigen::MatrixXd matrix = bodies * on.displacements + soft * on.tractions;
    VectorXd uniform = bodies * on.uniform + VectorXd::Constant(n + 1, soft);
    if (layer) {
        matrix += bodies * layer->tangential;
        uniform += bodies * layer->uniform;
    }
    const LeadingBlocks blocks(matrix.topRows(n));
    const VectorXd of_edge = bound.at_edge * uniform;
    SprungCurve curve;
    const auto add = [&](const VectorXd& g, double edge, double shift) {
        curve.forces.push_back(on.force.dot(g) + std::numbers::pi * edge);
        curve.shifts.push_back(shift);
    };
    add(bound.g, bound.at_edge, matrix.row(0).dot(bound.g) + of_edge[0]);
    for (Index j = stride; j < n; j += stride) {
        // Inside: unknown g of the nodes before j; t at j is that of the ring that slips.
        const VectorXd ring =
            matrix.topRightCorner(j + 1, n - j) * bound.g.tail(n - j) + of_edge.head(j + 1);
        const VectorXd per_shift = blocks.solve(VectorXd::Ones(j));
        const VectorXd by_ring = blocks.solve(ring.head(j));
        const auto row = matrix.row(j).head(j);
        const double shift = (ring[j] - row.dot(by_ring)) / (1 - row.dot(per_shift));
        VectorXd g = bound.g;
        g.head(j) = shift * per_shift - by_ring;
        add(g, bound.at_edge, shift);
    }
    // All sticks until the edge's traction is what the law carries there.
    if (!(bound.at_edge > 0 && soft > 0)) {
        curve.forces.push_back(0);
        curve.shifts.push_back(0);
        return curve;
    }
    const VectorXd per_shift = blocks.solve(VectorXd::Ones(n)),
                   per_edge = blocks.solve(uniform.head(n));
    const auto row = matrix.row(n);
    const double edge = (1 - row.dot(per_shift)) / (uniform[n] - row.dot(per_edge));
    const double shift = bound.at_edge / edge;
    add(shift * per_shift - bound.at_edge * per_edge, bound.at_edge, shift);
    return curve;
}

// Places of the interpolation, in the logarithms of both softnesses.
constexpr double log_step = .2, stiffest = -9, softest = 8;
constexpr int rigid_place = -1000;

/// Four neighbours of a place and their weights, or the rigid one alone.
struct Neighbours {
    std::array<int, 4> places{};
    std::array<double, 4> weights{};
    int n = 4;
};

Neighbours neighbours_of(double softness) {
    Neighbours result;
    if (!(softness > std::exp(stiffest))) return {{rigid_place}, {1}, 1};
    const double x = std::log(softness) / log_step;
    const int first = static_cast<int>(std::floor(x)) - 1;
    for (int i = 0; i < 4; ++i) {
        result.places[i] = first + i;
        result.weights[i] = 1;
        for (int k = 0; k < 4; ++k)
            if (k != i) result.weights[i] *= (x - first - k) / (i - k);
    }
    return result;
}

double softness_at(int place) {
    return place == rigid_place ? 0 : std::exp(log_step * place);
}

/// Of a law whose one number is a factor of all tractions.
class UnitCurves {
  public:
    explicit UnitCurves(const contact::Friction& friction) : friction_(friction) {}

    SprungCurve computed(double softness, double tangential_softness) const {
        return sprung_curve(friction_, softness, 1, tangential_softness, 1);
    }

    SprungCurve at(double softness, double tangential_softness) {
        const std::scoped_lock lock(mutex_);
        const Neighbours normal = neighbours_of(softness),
                         tangential = neighbours_of(tangential_softness);
        SprungCurve sum;
        for (int i = 0; i < normal.n; ++i)
            for (int k = 0; k < tangential.n; ++k) {
                const SprungCurve& one = node(normal.places[i], tangential.places[k]);
                const double weight = normal.weights[i] * tangential.weights[k];
                sum.forces.resize(one.forces.size());
                sum.shifts.resize(one.shifts.size());
                for (std::size_t j = 0; j < one.forces.size(); ++j) {
                    sum.forces[j] += weight * one.forces[j];
                    sum.shifts[j] += weight * one.shifts[j];
                }
            }
        return sum;
    }

  private:
    const SprungCurve& node(int i, int k) {
        const auto [found, is_new] = nodes_.try_emplace({i, k});
        if (is_new) found->second = computed(softness_at(i), softness_at(k));
        return found->second;
    }

    contact::Friction friction_;
    std::mutex mutex_;
    std::map<std::pair<int, int>, SprungCurve> nodes_;
};

}  // namespace

UnitPress unit_press(const AbelElements& on, double softness, const LayerCorrection* layer) {
    Eigen::MatrixXd matrix(on.n + 1, on.n + 1);
    matrix.leftCols(on.n) = on.displacements + softness * on.tractions;
    if (layer) matrix.leftCols(on.n) += layer->normal;
    matrix.col(on.n).setConstant(-1);
    VectorXd heights(on.n + 1);
    for (Index i = 0; i <= on.n; ++i) heights[i] = -on.nodes[i] * on.nodes[i] / 2;
    const VectorXd found = matrix.partialPivLu().solve(heights);
    UnitPress press{found.head(on.n), 0, found[on.n]};
    press.force = on.force.dot(press.g);
    return press;
}

SprungCurve sprung_curve(const contact::Friction& friction, double softness, double mean,
                         double springs, double bodies, const PressedBody& body) {
    const auto curve_on = [&](int stride) {
        const AbelElements& on = abel_elements(stride * n_curve_elements);
        std::optional<LayerCorrection> layer;
        if (body.layer) layer = body.layer->at(on.n, body.ratio);
        const LayerCorrection* const correction = layer ? &*layer : nullptr;
        const UnitPress press = unit_press(on, softness, correction);
        // Under the force itself, which the elements miss by their error.
        const VectorXd pressing = press.g * (mean / press.force);
        return curve_of(on, bound_of(on, friction, pressing), springs, bodies, correction, stride);
    };
    SprungCurve curve = curve_on(1);
    const SprungCurve fine = curve_on(2);
    for (std::size_t i = 0; i < curve.forces.size(); ++i) {
        curve.forces[i] = extrapolated(curve.forces[i], fine.forces[i]);
        curve.shifts[i] = extrapolated(curve.shifts[i], fine.shifts[i]);
    }
    return curve;
}

SprungCurve coulomb_sprung_curve(double softness, double tangential_softness) {
    static UnitCurves curves({.coefficient = 1});
    return std::max(softness, tangential_softness) > std::exp(softest)
               ? curves.computed(softness, tangential_softness)
               : curves.at(softness, tangential_softness);
}

SprungCurve strength_sprung_curve(double tangential_softness) {
    static UnitCurves curves({.shear_strength = 1});
    return tangential_softness > std::exp(softest) ? curves.computed(0, tangential_softness)
                                                   : curves.at(0, tangential_softness);
}

}  // namespace tricontact::theory
