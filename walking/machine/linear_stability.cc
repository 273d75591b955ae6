#include "walking/machine/linear_stability.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <numbers>

#include "walking/machine/motion.h"

namespace tricontact::walking {

namespace {

using std::numbers::sqrt2;

// Second derivatives of the elastic energy with respect to x, z and phi, in units of k_x.
Eigen::Matrix3d sticking_stiffness(const Machine& machine) {
    const Kappas& k = machine.kappas;
    const bool prism = machine.model == Machine::Model::prism;
    const Eigen::Vector3d stretch(-1, 0, k.kappa8), shear(1, 0, 1);
    Eigen::Matrix3d stiffness = k.kappa1 * stretch * stretch.transpose();
    for (const Spot& spring : springs_of(machine)) {
        const Eigen::Vector3d approach(0, 1, -normal_lever(spring, 0) / k.kappa3);
        // Two flanks of 45 degrees resist an approach across and along themselves.
        const double normal = prism ? k.kappa2 + 1 : spring.stiffness * k.kappa2;
        const double tangential = prism ? 2 : spring.stiffness;
        stiffness +=
            normal * approach * approach.transpose() + tangential * shear * shear.transpose();
    }
    return stiffness;
}

// Root of f between a and b, where it has different signs; to rounding.
template <class Function>
double root(const Function& f, double a, double b) {
    std::uintmax_t n_evaluations = 200;
    const auto [low, high] = boost::math::tools::toms748_solve(
        f, a, b, boost::math::tools::eps_tolerance<double>(), n_evaluations);
    return std::abs(f(low)) < std::abs(f(high)) ? low : high;
}

Acceleration sliding_acceleration(const Machine& machine, double z, double phi) {
    return acceleration(machine, springs_of(machine), sliding_motion(machine, z, phi));
}

// Normal forces grow with z: there is one z at which they carry the weight.
double carried_at(const Machine& machine, double phi) {
    const double rest = static_displacement(machine);
    if (!machine.mechanisms.vertical) return rest;
    const auto excess = [&](double z) { return sliding_acceleration(machine, z, phi).z; };
    double low = rest, high = rest, step = std::max(std::abs(rest), std::abs(phi)) / 8;
    while (excess(low) < 0) low -= step, step *= 2;
    while (excess(high) > 0) high += step, step *= 2;
    return low < high ? root(excess, low, high) : rest;
}

using Row = Eigen::RowVector3d;  // derivatives with respect to x, z, phi

/// Of a spot's normal and tangential force.
std::pair<Row, Row> derivatives(const Machine& machine, const Spot& spot, const Motion& motion,
                                const SpotDeflection& deflection) {
    if (!(deflection.normal > 0)) return {Row::Zero(), Row::Zero()};
    const Kappas& k = machine.kappas;
    const bool prism = machine.model == Machine::Model::prism;
    const Row approach(0, 1, -normal_lever(spot, motion.phi / k.kappa3) / k.kappa3);
    // Prism: 2 flanks, each with the approach's and the force's share of sqrt(1/2).
    const Row normal = (prism ? 1 : spot.stiffness) * k.kappa2 * approach;
    const double bound = k.kappa5 * k.kappa2 * (prism ? sqrt2 : spot.stiffness);
    const Row tangential = machine.mechanisms.coupling ? Row(bound * approach) : Row(Row::Zero());
    return {normal, tangential};
}

// Of x'', z'', phi'' while every spot in contact slips forwards, u = mu kappa2 n. Friction makes it
// unsymmetric.
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
        const auto [dn, dt] = derivatives(machine, spot, motion, motion.spots[i]);
        x -= dt;
        z -= dn;
        moment += k.kappa3 * dn * (normal_lever(spot, phi / k.kappa3) + phi) -
                  dt * (square - spot.position * phi) +
                  (normal * (spot.tip_radius + k.kappa3) + tangential * spot.position) * turn;
    }
    Eigen::Matrix3d all;
    all << x, z, moment / k.kappa7;
    if (!machine.mechanisms.vertical) all.row(1).setZero();
    if (!machine.mechanisms.rotation) all.row(2).setZero();
    return all;
}

// The first-order system of displacements, velocities and, in the prism, deflections u_s of the
// spots in contact: u_s' = (z' - p phi'/kappa3)/sqrt(2) - kappa6/bound u_s, as slip at kappa6 along
// the motion turns the deflection back.
Eigen::MatrixXd system_matrix(const Machine& machine, const Motion& motion) {
    const Kappas& k = machine.kappas;
    std::vector<Eigen::Index> free{0};  // to move, of x, z, phi
    if (machine.mechanisms.vertical) free.push_back(1);
    if (machine.mechanisms.rotation) free.push_back(2);
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

double highest_frequency(const Machine& machine) {
    const auto& [vertical, rotation, coupling] = machine.mechanisms;
    const Kappas& k = machine.kappas;
    // 1/sqrt of the masses of x, z and phi; what may not move has no part in any vibration.
    const Eigen::DiagonalMatrix<double, 3> scale(1, vertical ? 1 : 0,
                                                 rotation ? k.kappa3 / std::sqrt(k.kappa7) : 0);
    const Eigen::Matrix3d scaled = scale * sticking_stiffness(machine) * scale;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> modes(scaled, Eigen::EigenvaluesOnly);
    return std::sqrt(modes.eigenvalues().maxCoeff());
}

double stable_step(const Machine& machine) {
    return 2 / highest_frequency(machine);
}

Motion sliding_motion(const Machine& machine, double z, double phi) {
    const Kappas& k = machine.kappas;
    const bool prism = machine.model == Machine::Model::prism;
    const double slope = prism ? 1 / std::numbers::sqrt2 : 1;
    const double rest = static_displacement(machine);
    Motion motion{.z = z, .phi = phi, .x_velocity = k.kappa6};
    const std::vector<Spot> spots = springs_of(machine);
    double friction = 0;
    for (const Spot& spot : spots) {
        const double near = std::max(0., approach(spot, z, phi / k.kappa3));
        const double loaded = machine.mechanisms.coupling ? near : std::max(0., rest - spot.height);
        const SpotDeflection deflection{.normal = slope * near,
                                        .tangential = k.kappa5 * k.kappa2 * slope * loaded};
        friction += spot_force(machine, spot, deflection).tangential;
        motion.spots.push_back(deflection);
    }
    motion.base = friction / k.kappa1 - k.kappa8 * phi;
    return motion;
}

std::optional<Motion> steady_sliding(const Machine& machine) {
    const auto moment = [&](double phi) {
        return sliding_acceleration(machine, carried_at(machine, phi), phi).phi;
    };
    const double start = moment(0);
    if (start == 0) return sliding_motion(machine, carried_at(machine, 0), 0);
    // A turn loads the spots on one side: moments fall with phi while both sides carry. Steps
    // double from one that is small beside the turn that lifts a spot at rest.
    double before = 0, phi = std::copysign(1e-3 * static_displacement(machine), start);
    while (moment(phi) * start > 0) {
        before = phi;
        phi *= 2;
        if (std::abs(phi) > tilting_limit(machine)) return std::nullopt;
    }
    phi = root(moment, std::min(before, phi), std::max(before, phi));
    return sliding_motion(machine, carried_at(machine, phi), phi);
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
