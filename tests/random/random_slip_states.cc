// Weakening contacts drawn at random, loaded in one step from rest: how many states carry the same
// load? Boundary elements find the one of least slip and say whether the one of most slip differs.
// Here slip also begins from many other fields, over the dense matrix, which shares no line with
// the solvers. Where both ends meet no other state may turn up; each state lies between both ends.
// usage: random_slip_states SEED N
#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <random>
#include <vector>

#include "bem/model.h"
#include "contact/base/special_values.h"
#include "contact/cells.h"
#include "contact/prescribed_path.h"
#include "contact/run.h"
#include "contact/surface_model.h"
#include "tests/random/seeded_main.h"

namespace tricontact {
namespace {

using contact::Case;
using contact::FrictionWeakening;
using Random = std::mt19937_64;

constexpr double depth = 3e-4, radius = .04, mu = .5;
constexpr int n_starts = 24;

double uniform(Random& random, double from, double to) {
    return std::uniform_real_distribution<>(from, to)(random);
}

/// A half-space pressed by a ball, shifted at once; the fall of friction from much slower to much
/// faster than the contact lets go, on springs of the interface in every other case.
Case drawn(Random& random) {
    Case c;
    c.indenter.radius = radius;
    c.substrate = {5e6, 0};
    c.friction.coefficient = mu;
    c.contact.coupling = false;
    c.load = {};
    c.load.indentation = depth;
    c.load.tangential_force = 0;
    const double a = std::sqrt(radius * depth);
    c.of<contact::Cells>().spacing = a / 6;
    double full = mu * depth;  // the shift at which all slides, nu = 0
    if (uniform(random, 0, 1) < .5) {
        c.interface.tangential_stiffness = std::pow(10, uniform(random, -2, 1)) * 5e6 / a;
        full += mu * 2e6 * std::sqrt(depth / radius) / *c.interface.tangential_stiffness;
    }
    c.friction.weakening = FrictionWeakening{
        uniform(random, 0, 1) < .5 ? FrictionWeakening::Law::linear
                                   : FrictionWeakening::Law::exponential,
        mu * uniform(random, .1, .95), full * std::pow(10, uniform(random, -2, .5))};
    c.prescribed_path.emplace();
    for (const double shift : {0., full * uniform(random, .05, 1.2)}) {
        contact::PrescribedPath::Row row;
        row.normal = {contact::NormalControl::Kind::indentation, depth};
        row.tangential[0] = {contact::TangentialControl::Kind::shift, shift};
        row.tangential[1] = {contact::TangentialControl::Kind::shift, 0};
        c.prescribed_path->rows.push_back(row);
    }
    return c;
}

/// Slip along x over the dense matrix of the points in contact: K (U - s) = t.
class DenseSlip {
  public:
    explicit DenseSlip(const Case& c) : weakening_(*c.friction.weakening) {
        const auto substrate = bem::make_substrate(c, 1, bem::Body::half_space);
        const contact::Compliance& compliance = substrate->compliance();
        contact::SurfaceModel model("bem", *bem::make_substrate(c, 1, bem::Body::half_space),
                                    c.make_indenter(), c.friction.law(), 1e-9, c.contact);
        contact::LoadStep press = contact::press_step(c);
        press.friction = false;
        model.advance(press);
        const auto pressure = model.surface().normal_traction;
        for (std::size_t i = 0; i < pressure.size(); ++i)
            if (pressure[i] > 0) on_.push_back(i), pressure_.push_back(pressure[i]);
        Eigen::MatrixXd matrix(on_.size(), on_.size());
        for (std::size_t k = 0; k < on_.size(); ++k) {
            contact::TangentialField unit(pressure.size()), moved(pressure.size());
            unit.x[on_[k]] = 1;
            compliance.tangential(unit, moved);
            for (std::size_t i = 0; i < on_.size(); ++i) matrix(i, k) = moved.x[on_[i]];
        }
        stiffness_ = matrix.inverse();
        x_ = compliance.points().x;
        y_ = compliance.points().y;
        shift_ = c.prescribed_path->rows.back().tangential[0].value;
    }
    double length() const { return weakening_.length; }

    /// Point by point to where its traction is its bound, on the side from which it comes: a step
    /// by the point's stiffness alone does not reach beyond it, for the bound falls on the way.
    /// Empty: not settled.
    std::optional<Eigen::VectorXd> settled(Eigen::VectorXd slip) const {
        const Eigen::Index n = slip.size();
        const double allowed = 1e-9 * *std::ranges::max_element(pressure_);
        for (int sweep = 0; sweep < 30000; ++sweep) {
            double worst = 0;
            for (Eigen::Index i = 0; i < n; ++i) {
                const double t = shift_ * stiffness_.row(i).sum() - stiffness_.row(i).dot(slip);
                const double excess = t - bound(i, slip[i]);
                const double next = std::max(0., slip[i] + excess / stiffness_(i, i));
                worst = std::max(worst, stiffness_(i, i) * std::abs(next - slip[i]));
                slip[i] = next;
            }
            if (worst < allowed) return slip;
        }
        return {};
    }

    Eigen::VectorXd start(Random& random, int kind) const {
        Eigen::VectorXd slip(static_cast<Eigen::Index>(on_.size()));
        const double far = std::max(shift_, 3 * length());
        const double angle = uniform(random, 0, 6.28), size = uniform(random, .1, 1.);
        const double where = uniform(random, -1, 1), reach = std::sqrt(radius * depth);
        for (Eigen::Index k = 0; k < slip.size(); ++k) {
            const double x = x_[on_[k]] / reach, y = y_[on_[k]] / reach;
            const double along = x * std::cos(angle) + y * std::sin(angle);
            const bool inside = std::hypot(x, y) < size;
            const double any = uniform(random, 0, 1);
            slip[k] = far * (kind == 0   ? any
                             : kind == 1 ? any < size
                             : kind == 2 ? along > where
                             : kind == 3 ? inside
                             : kind == 4 ? !inside
                                         : size);
        }
        return slip;
    }
    Eigen::VectorXd none() const {
        return Eigen::VectorXd::Zero(static_cast<Eigen::Index>(on_.size()));
    }
    Eigen::VectorXd endless() const { return none().array() + std::max(shift_, 3 * length()); }
    /// Largest difference of slips over D_c.
    double distance(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
        return (a - b).cwiseAbs().maxCoeff() / length();
    }
    double force(const Eigen::VectorXd& slip, double area) const {
        return area * (stiffness_ * (none().array() + shift_ - slip.array()).matrix()).sum();
    }

  private:
    double bound(Eigen::Index i, double slip) const {
        return (mu - weakening_.drop * (1 - weakening_.left(slip))) * pressure_[i];
    }

    FrictionWeakening weakening_;
    std::vector<std::size_t> on_;
    std::vector<double> pressure_, x_, y_;
    Eigen::MatrixXd stiffness_;
    double shift_ = 0;
};

struct Tally {
    int one = 0, several = 0, with_third = 0, most_states = 0, refused = 0, wrong = 0;
};

constexpr double same = 1e-3;  // of slips over D_c, each settled to 1e-9 of p0

void look_at(const Case& c, Random& random, Tally& tally) {
    const auto model = bem::make_model(c, 1);
    const auto h = contact::run(c, *model);
    const bool differs = h.steps.back().may_differ == 1;
    const DenseSlip dense(c);
    const auto least = dense.settled(dense.none()), most = dense.settled(dense.endless());
    if (!least || !most) {
        ++tally.refused;
        return;
    }
    const double area = std::pow(c.of<contact::Cells>().spacing.value(), 2);
    const double force = h.steps.back().tangential_force[0];
    const bool followed = std::abs(dense.force(*least, area) / force - 1) < 1e-4;
    std::vector<Eigen::VectorXd> states{*least};
    if (dense.distance(*least, *most) > same) states.push_back(*most);
    bool inside = true;
    for (int k = 0; k < n_starts; ++k) {
        const auto found = dense.settled(dense.start(random, k % 6));
        if (!found) continue;
        inside = inside && (*found - *least).minCoeff() > -same * dense.length() &&
                 (*most - *found).minCoeff() > -same * dense.length();
        if (std::ranges::none_of(states, [&](const Eigen::VectorXd& state) {
                return dense.distance(state, *found) < same;
            }))
            states.push_back(*found);
    }
    const int n = static_cast<int>(states.size());
    const bool agrees = differs == (dense.distance(*least, *most) > same);
    if (!followed || !inside || !agrees || (!differs && n > 1)) {
        ++tally.wrong;
        fmt::print(
            "{}: drop {:.4g}, D_c {:.4g} um, shift {:.4g} um, k_t {:.4g}: {} states, "
            "other state {}, followed {}, between {}, force {:.9g} {:.9g}\n",
            tally.one + tally.several, c.friction.weakening->drop, dense.length() * 1e6,
            c.prescribed_path->rows.back().tangential[0].value * 1e6,
            c.interface.tangential_stiffness.value_or(contact::infinity), n, differs, followed,
            inside, force, dense.force(*least, area));
    }
    tally.one += n == 1;
    tally.several += n > 1;
    tally.with_third += n > 2;
    tally.most_states = std::max(tally.most_states, n);
}

int check(std::uint64_t seed, int n) {
    Random random(seed);
    std::map<bool, Tally> tallies;  // by whether there are springs between the surfaces
    for (int k = 0; k < n; ++k) {
        const Case c = drawn(random);
        look_at(c, random, tallies[c.interface.is_elastic()]);
    }
    bool holds = true;
    for (const auto& [springs, tally] : tallies) {
        fmt::print(
            "{}: {} with one state, {} with several, of which {} have others than both ends (up to "
            "{} found by {} starts); {} too slow to settle; {} not as told\n",
            springs ? "with springs of the interface" : "of bodies alone", tally.one, tally.several,
            tally.with_third, tally.most_states, n_starts, tally.refused, tally.wrong);
        holds = holds && tally.wrong == 0 && 10 * tally.refused <= n;
    }
    return holds ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace
}  // namespace tricontact

int main(int argc, char** argv) {
    return tricontact::run_seeded(argc, argv, tricontact::check);
}
