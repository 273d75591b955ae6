#include "theory/layer/layer_stack.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>

#include "contact/base/error.h"

namespace tricontact::layer_stack_test {
namespace {

using contact::Material;
using theory::LayerBase;
using theory::LayerCompliance;
using theory::LayerStack;
using theory::surface_compliance;

constexpr LayerBase both_bases[] = {LayerBase::bonded, LayerBase::frictionless};

Material material(double shear_modulus, double nu) {
    return {2 * (1 + nu) * shear_modulus, nu};
}

void expect_near(const LayerCompliance& c, const LayerCompliance& exact, double unit,
                 double tolerance, const ::testing::Message& place) {
    EXPECT_NEAR(c.normal / unit, exact.normal / unit, tolerance) << place;
    EXPECT_NEAR(c.along / unit, exact.along / unit, tolerance * std::max(1., exact.along / unit))
        << place;
    EXPECT_NEAR(c.across / unit, exact.across / unit, tolerance * std::max(1., exact.across / unit))
        << place;
    EXPECT_NEAR(c.coupling / unit, exact.coupling / unit, tolerance) << place;
}

// A layer cut into sheets of its own material is the same layer.
TEST(TheoryLayerStack, CutLayerIsTheLayer) {
    for (const LayerBase base : both_bases)
        for (const double nu : {-.5, 0., .3, .5})
            for (const double x : {.05, .4, 1., 3., 9., 25., 39., 60.}) {
                const Material m = material(2e6, nu);
                const LayerStack stack{{{m, 2e-3}, {m, 5e-3}, {m, 1e-3}}, base, {}};
                const double k = x / 8e-3, unit = 1 / (2e6 * k);
                expect_near(surface_compliance(stack, k),
                            theory::layer_compliance({m, 8e-3, base}, k), unit, 1e-13,
                            ::testing::Message() << "nu " << nu << ", x " << x);
            }
}

TEST(TheoryLayerStack, GroundOfTheSameMaterialIsTheHalfSpace) {
    for (const double nu : {-.5, .3, .5})
        for (const double x : {1e-6, .01, 1., 10., 100.}) {
            const Material m = material(2e6, nu);
            const LayerStack stack{{{m, 3e-3}}, LayerBase::bonded, m};
            const double k = x / 3e-3, unit = 1 / (2e6 * k);
            expect_near(surface_compliance(stack, k),
                        {(1 - nu) * unit, (1 - nu) * unit, unit, (1 - 2 * nu) / 2 * unit}, unit,
                        1e-14, ::testing::Message() << "nu " << nu << ", x " << x);
        }
}

// Seen from far away, a thin sheet is not there; from near, nothing else is.
TEST(TheoryLayerStack, LimitsOfASheetOnAHalfSpace) {
    const Material sheet = material(1e6, .5), ground = material(3e6, .3);
    const LayerStack stack{{{sheet, 1e-3}}, LayerBase::bonded, ground};
    const double far = 1e-5 / 1e-3, near = 30 / 1e-3;
    const double far_unit = 1 / (3e6 * far), near_unit = 1 / (1e6 * near);
    // What a sheet adds is of the order k b times the ratio of moduli.
    expect_near(surface_compliance(stack, far),
                {.7 * far_unit, .7 * far_unit, far_unit, .2 * far_unit}, far_unit, 1e-4,
                ::testing::Message() << "far");
    expect_near(surface_compliance(stack, near), {.5 * near_unit, .5 * near_unit, near_unit, 0},
                near_unit, 1e-14, ::testing::Message() << "near");
}

// Airy's stress function f(z) cos(k s) of each sheet, f in exponentials that decay from either
// face, all conditions in one system of equations: another road than the propagator's.
class AiryStack {
  public:
    explicit AiryStack(const LayerStack& stack, double k) : stack_(stack), k_(k) {
        const auto n = static_cast<Eigen::Index>(stack.sheets.size());
        const Eigen::Index size = 4 * n + (stack.half_space ? 2 : 0);
        system_ = Eigen::MatrixXd::Zero(size, size);
        Eigen::Index row = 0;
        put(row, 0, at(0, 0), {2, 3}, 1);  // tau and sigma of the surface
        row += 2;
        for (Eigen::Index s = 0; s + 1 < n; ++s) {
            put(row, 4 * s, at(s, stack.sheets[s].thickness), {0, 1, 2, 3}, 1);
            put(row, 4 * s + 4, at(s + 1, 0), {0, 1, 2, 3}, -1);
            row += 4;
        }
        const Field last = at(n - 1, stack.sheets[n - 1].thickness);
        if (stack.half_space) {
            put(row, 4 * (n - 1), last, {0, 1, 2, 3}, 1);
            put(row, 4 * n, field(*stack.half_space, 0, 0).leftCols(2), {0, 1, 2, 3}, -1);
        } else if (stack.base == LayerBase::bonded) {
            put(row, 4 * (n - 1), last, {0, 1}, 1);
        } else {
            put(row, 4 * (n - 1), last, {1, 2}, 1);
        }
    }

    // C33, C11 and the two couplings.
    std::array<double, 4> compliance() const {
        const Field top = at(0, 0);
        const auto solver = system_.fullPivLu();
        Eigen::VectorXd tau = Eigen::VectorXd::Zero(system_.rows()), sigma = tau;
        tau[0] = -1;    // t_along = 1
        sigma[1] = -1;  // p = 1
        const Eigen::VectorXd by_t = solver.solve(tau), by_p = solver.solve(sigma);
        const Eigen::Vector4d under_t = top * by_t.head<4>(), under_p = top * by_p.head<4>();
        return {under_p[1], under_t[0], -under_p[0], -under_t[1]};
    }

  private:
    // Rows u_along, u_z, tau, sigma_z; columns: the four functions.
    using Field = Eigen::Matrix<double, 4, Eigen::Dynamic>;

    Field at(Eigen::Index sheet, double z) const {
        const auto& s = stack_.sheets[sheet];
        return field(s.material, z, s.thickness);
    }
    Field field(const Material& m, double z, double b) const {
        Field columns(4, 4);
        for (int f = 0; f < 4; ++f) {
            const double sign = f < 2 ? -1 : 1;  // e^{-kz}, kz e^{-kz}; e^{-k(b-z)}, ...
            const double y = f < 2 ? k_ * z : k_ * (b - z), e = std::exp(-y);
            // Derivatives over y of e^-y or y e^-y; z runs with or against y.
            std::array<double, 4> d =
                f % 2 == 0 ? std::array{e, -e, e, -e}
                           : std::array{y * e, (1 - y) * e, (y - 2) * e, (3 - y) * e};
            const double dy = -sign * k_;
            const double f0 = d[0], f1 = d[1] * dy, f2 = d[2] * dy * dy, f3 = d[3] * dy * dy * dy;
            const double g = m.shear_modulus(), nu = m.poisson;
            // 2 G eps_s = (1 - nu) sigma_s - nu sigma_z; tau = G (u_s' + du_z/ds)
            const double u = ((1 - nu) * f2 + nu * k_ * k_ * f0) / (2 * g * k_);
            const double u_prime = ((1 - nu) * f3 + nu * k_ * k_ * f1) / (2 * g * k_);
            columns.col(f) << u, (u_prime - k_ * f1 / g) / k_, k_ * f1, -k_ * k_ * f0;
        }
        return columns;
    }
    void put(Eigen::Index row, Eigen::Index column, const Field& field,
             const std::vector<int>& which, double factor) {
        for (std::size_t i = 0; i < which.size(); ++i)
            system_.block(row + static_cast<Eigen::Index>(i), column, 1, field.cols()) =
                factor * field.row(which[i]);
    }

    const LayerStack& stack_;
    double k_;
    Eigen::MatrixXd system_;
};

TEST(TheoryLayerStack, SolvesTheBoundaryValueProblem) {
    const std::vector<LayerStack::Sheet> sheets = {
        {material(1, .5), 1}, {material(4, -.2), .3}, {material(.3, .3), .7}};
    std::vector<LayerStack> stacks;
    for (const LayerBase base : both_bases) stacks.push_back({sheets, base, {}});
    stacks.push_back({sheets, LayerBase::bonded, material(2.5, .4)});
    stacks.push_back({{sheets[0]}, LayerBase::bonded, material(.1, .1)});
    for (const auto& stack : stacks)
        for (const double k : {.3, 1., 2.2, 6., 15.}) {
            const auto c = surface_compliance(stack, k);
            const auto exact = AiryStack(stack, k).compliance();
            // The exponentials are nearly dependent where k b is small: 1e-12 is what is left.
            const double tolerance = 1e-11 / k * std::max(1., k * exact[1]);
            EXPECT_NEAR(c.normal, exact[0], tolerance) << k;
            EXPECT_NEAR(c.along, exact[1], tolerance) << k;
            EXPECT_NEAR(c.coupling, exact[2], tolerance) << k;
            EXPECT_NEAR(exact[3], exact[2], tolerance) << k;  // reciprocity
        }
}

// Antiplane: two sheets in closed form, tanh of sums.
TEST(TheoryLayerStack, AntiplaneShearOfTwoSheets) {
    for (const double k : {.01, .5, 3., 20.}) {
        const LayerStack stack{
            {{material(1, .5), 1}, {material(4, .2), .3}}, LayerBase::bonded, {}};
        // Stiffness of the lower one, then through the upper one.
        const double below = 4 * k / std::tanh(.3 * k), th = std::tanh(k);
        const double stiffness = k * (below / k + th) / (1 + below / k * th);
        EXPECT_NEAR(surface_compliance(stack, k).across * stiffness, 1, 1e-13) << k;
    }
}

TEST(TheoryLayerStack, NonsenseIsRefused) {
    EXPECT_THROW(surface_compliance({}, 1), contact::InputError);
    const LayerStack::Sheet good{material(1, .3), 1};
    for (const double b : {0., -1., std::nan("")})
        EXPECT_THROW(surface_compliance({{good, {good.material, b}}, LayerBase::bonded, {}}, 1),
                     contact::InputError);
    EXPECT_THROW(surface_compliance({{good}, LayerBase::bonded, Material{1, .6}}, 1),
                 contact::InputError);
    EXPECT_THROW(surface_compliance({{good, good}, LayerBase::bonded, {}}, 0), contact::InputError);
}

}  // namespace
}  // namespace tricontact::layer_stack_test
