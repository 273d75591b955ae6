#include "walking/machine/linear_stability.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <numbers>

#include "walking/machine/forces.h"
#include "walking/machine/stable_step.h"
#include "walking/machine/steady_sliding.h"

namespace tricontact::walking {

using std::numbers::sqrt2;

namespace {

using Row = Eigen::RowVector3d;  // derivatives with respect to x, z, phi

struct SpotDerivatives {
    Row approach, normal, tangential;
};

SpotDerivatives derivatives(const Machine& machine, const Spot& spot, const Motion& motion,
                            const SpotDeflection& deflection) {
    if (!(deflection.normal > 0)) return {Row::Zero(), Row::Zero(), Row::Zero()};
    const Kappas& k = machine.kappas;
    const bool prism = machine.model == Machine::Model::prism;
    const Row approach(0, 1, -normal_lever(spot, motion.phi / k.kappa3) / k.kappa3);
    // Prism: 2 flanks, each with the approach's and the force's share of sqrt(1/2).
    const Row normal = (prism ? 1 : spot.stiffness) * k.kappa2 * approach;
    const double bound = k.kappa5 * k.kappa2 * (prism ? sqrt2 : spot.stiffness);
    const Row tangential = machine.mechanisms.coupling ? Row(bound * approach) : Row(Row::Zero());
    return {approach, normal, tangential};
}

// Of x'', z'', phi''.
Eigen::Matrix3d jacobian(const Machine& machine, const Motion& motion) {
    const Kappas& k = machine.kappas;
    const double square = k.kappa3 * k.kappa3, phi = motion.phi;
    const Row turn(0, 0, 1), pull(-k.kappa1, 0, k.kappa1 * k.kappa8);
    Row x = pull, z = Row::Zero();
    Row moment = -pull * (square * k.kappa8 + phi) - spring_force(machine, motion) * turn;
    const std::vector<Spot> spots = springs_of(machine);
    for (std::size_t i = 0; i < spots.size(); ++i) {
        const Spot& spot = spots[i];
        const auto [normal, tangential] = spot_force(machine, spot, motion.spots[i]);
        const SpotDerivatives d = derivatives(machine, spot, motion, motion.spots[i]);
        x -= d.tangential;
        z -= d.normal;
        moment += k.kappa3 * d.normal * (normal_lever(spot, phi / k.kappa3) + phi) -
                  d.tangential * (square - spot.position * phi) +
                  (normal * (spot.tip_radius + k.kappa3) + tangential * spot.position) * turn;
    }
    Eigen::Matrix3d all;
    all << x, z, moment / k.kappa7;
    if (!machine.mechanisms.vertical) all.row(1).setZero();
    if (!machine.mechanisms.rotation) all.row(2).setZero();
    return all;
}

// What may move, of x, z, phi.
std::vector<Eigen::Index> freedoms(const Machine& machine) {
    std::vector<Eigen::Index> free{0};
    if (machine.mechanisms.vertical) free.push_back(1);
    if (machine.mechanisms.rotation) free.push_back(2);
    return free;
}

// The first-order system of displacements, velocities and, in the prism, deflections u_s of the
// spots in contact: u_s' = (z' - p phi'/kappa3)/sqrt(2) - kappa6/bound u_s, as slip at kappa6 along
// the motion turns the deflection back.
Eigen::MatrixXd system_matrix(const Machine& machine, const Motion& motion) {
    const Kappas& k = machine.kappas;
    const std::vector<Eigen::Index> free = freedoms(machine);
    const std::vector<Spot> spots = springs_of(machine);
    std::vector<std::size_t> turning;
    if (machine.model == Machine::Model::prism)
        for (std::size_t i = 0; i < spots.size(); ++i)
            if (motion.spots[i].tangential > 0) turning.push_back(i);
    const auto n = static_cast<Eigen::Index>(free.size());
    const auto n_turning = static_cast<Eigen::Index>(turning.size());
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(2 * n + n_turning, 2 * n + n_turning);
    matrix.block(0, n, n, n).setIdentity();
    matrix.block(n, 0, n, n) = jacobian(machine, motion)(free, free);
    for (Eigen::Index j = 0; j < n_turning; ++j) {
        const Spot& spot = spots[turning[j]];
        const double lever = spot.position;
        // Normal force of a side: sqrt(2) u_s upwards.
        const Eigen::Vector3d force(0, -sqrt2, k.kappa3 / k.kappa7 * sqrt2 * (lever + motion.phi));
        const Eigen::Vector3d velocity(0, 1 / sqrt2, -lever / k.kappa3 / sqrt2);
        matrix.block(n, 2 * n + j, n, 1) = force(free);
        matrix.block(2 * n + j, n, 1, n) = velocity(free).transpose();
        matrix(2 * n + j, 2 * n + j) = -k.kappa6 / motion.spots[turning[j]].tangential;
    }
    return matrix;
}

}  // namespace

std::array<std::array<double, 3>, 3> sliding_jacobian(const Machine& machine,
                                                      const Motion& motion) {
    const Eigen::Matrix3d matrix = jacobian(machine, motion);
    std::array<std::array<double, 3>, 3> rows{};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) rows[i][j] = matrix(i, j);
    return rows;
}

std::vector<std::complex<double>> sliding_eigenvalues(const Machine& machine,
                                                      const Motion& motion) {
    const Eigen::MatrixXd matrix = system_matrix(machine, motion);
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(matrix, false);
    const auto& values = solver.eigenvalues();
    return {values.begin(), values.end()};
}

std::complex<double> leading_eigenvalue(const Machine& machine, const Motion& motion) {
    const std::vector<std::complex<double>> values = sliding_eigenvalues(machine, motion);
    const auto slower = [](const auto& a, const auto& b) { return a.real() < b.real(); };
    const std::complex<double> leading = *std::max_element(values.begin(), values.end(), slower);
    return {leading.real(), std::abs(leading.imag())};
}

std::optional<double> flutter_friction(Machine machine, double highest) {
    // Growth rates are zero but for the square root of rounding where two frequencies meet.
    const double negligible = 1e-6 * highest_frequency(machine);
    const auto flutters = [&](double mu) {
        machine.kappas.kappa5 = mu;
        const std::optional<Motion> motion = steady_sliding(machine);
        if (!motion) return false;
        const std::complex<double> leading = leading_eigenvalue(machine, *motion);
        return leading.real() > negligible && leading.imag() > negligible;
    };
    constexpr int n_steps = 200;
    for (int i = 1; i <= n_steps; ++i) {
        const double mu = highest * i / n_steps, below = highest * (i - 1) / n_steps;
        if (!flutters(mu)) continue;
        const auto side = [&](double between) { return flutters(between) ? 1. : -1.; };
        const boost::math::tools::eps_tolerance<double> tolerance(40);  // bits
        return boost::math::tools::bisect(side, below, mu, tolerance).second;
    }
    return std::nullopt;
}

}  // namespace tricontact::walking
