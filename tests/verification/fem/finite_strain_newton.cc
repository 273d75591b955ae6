// Full Newton for the contact of a coarse neo-Hookean layer: all unknowns at once, the tangent by
// differences of the residual, the contact's equations written here. It is to find what deferred
// correction found.

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "contact/bodies/indenter.h"
#include "contact/friction/friction.h"
#include "fem/condensed_compliance.h"
#include "fem/finite_strain/deferred_correction.h"
#include "fem/whole_body.h"
#include "tests/unit/fem/box_mesh.h"

namespace tricontact::fem::finite_strain_newton_test {
namespace {

constexpr double radius = .04, friction = 2, normal_force = 21.1, tangential_force = 2;
constexpr double tolerance = 1e-11;  // of deferred correction

/// Half of a layer of 7 x 3 x 2 elements under the rig's sphere, about two elements in the contact
/// radius.
LayerProblem coarse_layer() {
    LayerProblem problem;
    problem.mesh = test::box_mesh({{-20e-3, -10e-3, -6e-3, -2e-3, 2e-3, 6e-3, 10e-3, 20e-3},
                                   {0, 3e-3, 7e-3, 15e-3},
                                   {-8e-3, -3e-3, 0},
                                   9e-3,
                                   6.9e-3,
                                   true});
    problem.materials.fill({5.2e6, .5});
    return problem;
}

struct Layer {
    Layer()
        : problem(std::make_shared<LayerProblem>(coarse_layer())),
          compliance(problem, condense(*problem)),
          body(compliance.corrected().discretisation, {0, 0}),
          correction({compliance.corrected().discretisation, body, compliance.corrected().factor,
                      compliance, *indenter, radius, *law, tolerance}) {}

    std::shared_ptr<const LayerProblem> problem;
    CondensedCompliance compliance;
    std::unique_ptr<contact::Indenter> indenter = std::make_unique<contact::Paraboloid>(radius);
    StrainedBody body;
    std::shared_ptr<const contact::FrictionLaw> law = contact::Friction{friction}.law();
    DeferredCorrection correction;
};

contact::LoadStep step_of(bool with_friction) {
    contact::LoadStep step;
    step.normal.value = normal_force;
    step.friction = with_friction;
    if (with_friction) step.tangential[0].value = tangential_force;
    return step;
}

/// All equations of a contact whose points touch and, with friction, stick, or not. Forces are over
/// F_N, displacements and volumes over the indentation, so that all are of about the same size.
class Equations {
  public:
    Equations(const Layer& layer, const ContactedBody& before, const ContactedBody& guess,
              bool sticks)
        : layer_(layer), before_(before), at_(guess), sticks_(sticks) {
        for (std::size_t i = 0; i < at_.pressure.size(); ++i)
            if (at_.pressure[i] > 0) touching_.push_back(i);
        length_ = at_.pose.indentation;
        stress_ = *std::ranges::max_element(at_.pressure);
        amplitude_ = stress_ * layer.body.root_of_cell();
    }

    Eigen::VectorXd unknowns() const {
        std::vector<double> all;
        visit(at_, [&](double x, double unit) { all.push_back(x / unit); });
        return Eigen::Map<Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
    }
    const ContactedBody& state() const { return at_; }

    Eigen::VectorXd residual(const Eigen::VectorXd& x) {
        Eigen::Index k = 0;
        visit(at_, [&](double& value, double unit) { value = unit * x[k++]; });
        std::vector<double> left;
        StrainedBody::Response response;
        layer_.body.evaluate(at_.body, response);
        add_contact(response.force, left);
        const auto& unknowns = discretisation().unknowns;
        for (int u = 0; u < unknowns.n; ++u)
            left.push_back(response.force[component(u)] / normal_force);
        for (const auto& excess : response.excess_volume)
            for (const double e : excess) left.push_back(e / layer_.body.root_of_cell());
        return Eigen::Map<Eigen::VectorXd>(left.data(), static_cast<Eigen::Index>(left.size()));
    }

    /// Newton until nothing moves any more but by rounding; the last step's length.
    double solve() {
        Eigen::VectorXd x = unknowns();
        double moved = 1;
        for (int k = 0; k < 12 && moved > 1e-13; ++k) {
            const Eigen::VectorXd left = residual(x);
            const Eigen::VectorXd step = tangent(x).partialPivLu().solve(left);
            x -= step;
            moved = step.lpNorm<Eigen::Infinity>();
        }
        residual(x);  // into the state
        return moved;
    }

  private:
    const Discretisation& discretisation() const {
        return layer_.compliance.corrected().discretisation;
    }
    std::size_t component(int unknown) const {
        const auto& unknowns = discretisation().unknowns;
        return 3 * static_cast<std::size_t>(unknowns.node_of_unknown[unknown]) +
               unknowns.direction_of_unknown[unknown];
    }

    template <class State, class Visitor>
    void visit(State& state, Visitor&& visitor) const {
        const auto& unknowns = discretisation().unknowns;
        for (int u = 0; u < unknowns.n; ++u)
            visitor(state.body.displacement[component(u)], length_);
        for (auto& q : state.body.mean_stress)
            for (auto& amplitude : q) visitor(amplitude, amplitude_);
        for (const std::size_t i : touching_) {
            visitor(state.pressure[i], stress_);
            if (!sticks_) continue;
            visitor(state.traction.x[i], stress_);
            if (!on_plane(i)) visitor(state.traction.y[i], stress_);
        }
        visitor(state.pose.indentation, length_);
        if (sticks_) visitor(state.pose.shift[0], length_);
    }
    bool on_plane(std::size_t i) const { return layer_.compliance.points().y[i] == 0; }

    /// Takes the contact's forces off those of the body; says what the contact leaves.
    void add_contact(std::vector<double>& force, std::vector<double>& left) {
        const auto& points = layer_.compliance.points();
        double carried = 0, dragged = 0;
        for (const std::size_t i : touching_) {
            const auto node = static_cast<std::size_t>(discretisation().surface.nodes[i]);
            const Eigen::Vector3d x = position(i, at_);
            const Eigen::Vector2d from_lowest = x.head<2>() - lowest_point(at_);
            const Eigen::Vector3d slope(from_lowest[0] / radius, from_lowest[1] / radius, 1);
            const Eigen::Vector3d n = slope.normalized();
            // What turns the vertical into n turns x and y into the surface.
            const Eigen::Matrix3d turn =
                Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), n).toRotationMatrix();
            const Eigen::Vector3d traction =
                at_.pressure[i] * slope +
                turn * Eigen::Vector3d(at_.traction.x[i], at_.traction.y[i], 0);
            const double area = points.area[i];  // of both halves
            for (int a = 0; a < 3; ++a)
                force[3 * node + a] -= area / 2 * (a == 2 ? -traction[a] : traction[a]);
            carried += area * traction[2];
            dragged += area * traction[0];
            left.push_back(
                (from_lowest.squaredNorm() / (2 * radius) + x[2] - at_.pose.indentation) / length_);
            if (sticks_) add_slip(i, x, n, turn, left);
        }
        left.push_back(carried / normal_force - 1);
        if (sticks_) left.push_back((dragged - tangential_force) / normal_force);
    }

    /// The way of the indenter's point over the substrate's, without what is along the mean normal.
    void add_slip(std::size_t i, const Eigen::Vector3d& x, const Eigen::Vector3d& n,
                  const Eigen::Matrix3d& turn, std::vector<double>& left) const {
        const Eigen::Vector3d old = position(i, before_);
        const Eigen::Vector2d then = old.head<2>() - lowest_point(before_);
        const Eigen::Vector3d mean =
            n + Eigen::Vector3d(then[0] / radius, then[1] / radius, 1).normalized();
        Eigen::Vector3d way = old - x;
        way[0] += at_.pose.shift[0] - before_.pose.shift[0];
        way[2] += at_.pose.indentation - before_.pose.indentation;
        way -= n.dot(way) / n.dot(mean) * mean;
        left.push_back(turn.col(0).dot(way) / length_);
        if (!on_plane(i)) left.push_back(turn.col(1).dot(way) / length_);
    }

    Eigen::Vector3d position(std::size_t i, const ContactedBody& state) const {
        const auto& points = layer_.compliance.points();
        const double* const u =
            &state.body
                 .displacement[3 * static_cast<std::size_t>(discretisation().surface.nodes[i])];
        return {points.x[i] + u[0], points.y[i] + u[1], -u[2]};
    }
    static Eigen::Vector2d lowest_point(const ContactedBody& state) {
        return {state.pose.shift[0], state.pose.shift[1]};
    }

    Eigen::MatrixXd tangent(const Eigen::VectorXd& x) {
        // Central differences: errors of h^2 = 1e-8 in the tangent cost Newton one step more.
        constexpr double h = 1e-4;
        Eigen::MatrixXd matrix(x.size(), x.size());
        for (Eigen::Index k = 0; k < x.size(); ++k) {
            Eigen::VectorXd moved = x;
            moved[k] = x[k] + h;
            const Eigen::VectorXd above = residual(moved);
            moved[k] = x[k] - h;
            matrix.col(k) = (above - residual(moved)) / (2 * h);
        }
        return matrix;
    }

    const Layer& layer_;
    const ContactedBody& before_;
    ContactedBody at_;
    bool sticks_;
    std::vector<std::size_t> touching_;
    double length_ = 0, stress_ = 0, amplitude_ = 0;
};

void expect_the_same(const ContactedBody& newton, const ContactedBody& corrected) {
    constexpr double allowed = 1e-8;
    const double length = corrected.pose.indentation;
    const double stress = *std::ranges::max_element(corrected.pressure);
    EXPECT_NEAR(newton.pose.indentation / length, 1, allowed);
    EXPECT_NEAR((newton.pose.shift[0] - corrected.pose.shift[0]) / length, 0, allowed);
    for (std::size_t k = 0; k < newton.body.displacement.size(); ++k)
        ASSERT_NEAR((newton.body.displacement[k] - corrected.body.displacement[k]) / length, 0,
                    allowed);
    for (std::size_t i = 0; i < newton.pressure.size(); ++i) {
        ASSERT_NEAR((newton.pressure[i] - corrected.pressure[i]) / stress, 0, allowed);
        ASSERT_NEAR((newton.traction.x[i] - corrected.traction.x[i]) / stress, 0, allowed);
        ASSERT_NEAR((newton.traction.y[i] - corrected.traction.y[i]) / stress, 0, allowed);
    }
}

/// That the points which touch are those that should: pressures push, what is open is open.
void expect_complementary(const Layer& layer, const ContactedBody& state) {
    int n_touching = 0;
    for (std::size_t i = 0; i < state.pressure.size(); ++i) {
        const auto& x = state.position[i];
        const double gap = (std::pow(x[0] - state.pose.shift[0], 2) + x[1] * x[1]) / (2 * radius) +
                           x[2] - state.pose.indentation;
        EXPECT_GE(state.pressure[i], 0);
        if (state.pressure[i] > 0) {
            ++n_touching;
        } else {
            EXPECT_GT(gap, 0);
        }
    }
    EXPECT_GT(n_touching, 8);
    EXPECT_LT(n_touching, static_cast<int>(layer.compliance.points().size()));
}

TEST(FiniteStrainNewton, PressedWithoutFriction) {
    Layer layer;
    const ContactedBody before = layer.correction.at_rest();
    ContactedBody now = before;
    layer.correction.solve(step_of(false), {}, before, now);
    expect_complementary(layer, now);
    // From a state that is not the solution, or Newton would have nothing to do.
    ContactedBody guess = now;
    for (double& u : guess.body.displacement) u *= .99;
    Equations equations(layer, before, guess, false);
    EXPECT_LT(equations.solve(), 1e-11);
    expect_the_same(equations.state(), now);
}

TEST(FiniteStrainNewton, ShearedWithFrictionThatSticks) {
    Layer layer;
    ContactedBody pressed = layer.correction.at_rest();
    const ContactedBody rest = pressed;
    layer.correction.solve(step_of(false), {}, rest, pressed);
    ContactedBody now = pressed;
    layer.correction.solve(step_of(true), {}, pressed, now);
    expect_complementary(layer, now);
    for (std::size_t i = 0; i < now.pressure.size(); ++i) {
        EXPECT_EQ(now.pressure[i] > 0, pressed.pressure[i] > 0);
        EXPECT_LT(contact::norm(now.traction.at(i)), friction * now.pressure[i] + 1e-300) << i;
    }
    ContactedBody guess = now;
    for (double& u : guess.body.displacement) u *= .99;
    guess.pose.shift[0] *= .95;
    Equations equations(layer, pressed, guess, true);
    EXPECT_LT(equations.solve(), 1e-11);
    expect_the_same(equations.state(), now);
}

}  // namespace
}  // namespace tricontact::fem::finite_strain_newton_test
