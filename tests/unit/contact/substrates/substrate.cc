#include "contact/substrates/substrate.h"

#include <gtest/gtest.h>

#include <cmath>

#include "contact/base/state_bytes.h"
#include "contact/relaxing_case.h"
#include "contact/substrates/partly_relaxing_substrate.h"
#include "tests/unit/contact/dense_compliance.h"

namespace tricontact::substrate_test {
namespace {

using contact::PartlyRelaxingSubstrate;
using contact::Relaxation;
using contact::StieltjesInterpolation;
using contact::Substrate;
using contact::SurfaceField;
using contact::TangentialField;

constexpr int n = 7;

/// The softened half-space with its parts at `x` times their stiffness beside what stays.
class Body final : public contact::Compliance {
  public:
    /// Compliance over that of the dense one.
    explicit Body(double factor) : factor_(factor) {}
    const contact::ContactPoints& points() const override { return dense_.points(); }
    bool is_coupled() const override { return false; }
    void normal(std::span<const double> p, std::span<double> u) const override {
        dense_.normal(p, u);
        for (double& value : u) value *= factor_;
    }
    void tangential(const TangentialField& t, TangentialField& u) const override {
        dense_.tangential(t, u);
        for (double& value : u.x) value *= factor_;
        for (double& value : u.y) value *= factor_;
    }
    double local_tangential() const override { return factor_ * dense_.local_tangential(); }
    void precondition_tangential(const TangentialField& r, TangentialField& z) const override {
        dense_.precondition_tangential(r, z);
    }

  private:
    double factor_;
    contact_test::DenseCompliance dense_{n, 3};
};

const Relaxation solid{{{1.5, .2}}, {}};

/// C(x) = 1/(x + spring) + stays, over the dense one: a spring beside the relaxing one, and one
/// behind both.
PartlyRelaxingSubstrate partly(const Relaxation& relaxation, double spring, double stays) {
    const StieltjesInterpolation interpolation = contact::interpolation_of(relaxation);
    PartlyRelaxingSubstrate::Parts parts;
    for (const double x : interpolation.nodes)
        parts.push_back(std::make_shared<Body>(1 / (x + spring) + stays));
    return {parts, interpolation, relaxation};
}

SurfaceField load(double size) {
    SurfaceField t(n);
    for (std::size_t i = 0; i < n; ++i) {
        t.in_surface.x[i] = size * std::cos(i);
        t.in_surface.y[i] = size * .3;
        t.down[i] = size * (2 + std::sin(i));
    }
    return t;
}

/// Displacements under the tractions of a body `factor` times as soft as the dense one.
SurfaceField displaced(double factor, const SurfaceField& t) {
    SurfaceField u(n);
    const Body body(factor);
    body.tangential(t.in_surface, u.in_surface);
    body.normal(t.down, u.down);
    return u;
}

double work(const SurfaceField& t, const SurfaceField& u) {
    double sum = 0;
    const Body body(1);
    const auto& area = body.points().area;
    for (int d = 0; d < 3; ++d)
        for (std::size_t i = 0; i < n; ++i)
            sum += area[i] * (*components(t)[d])[i] * (*components(u)[d])[i];
    return sum;
}

/// Steps with prescribed tractions, as a contact solver would make them.
struct Loading {
    explicit Loading(Substrate& s) : substrate(s) {}
    void to(const SurfaceField& next, double duration) {
        substrate.begin(duration, t, u);
        SurfaceField now(n);
        substrate.compliance().tangential(next.in_surface, now.in_surface);
        substrate.compliance().normal(next.down, now.down);
        for (int d = 0; d < 3; ++d)
            for (std::size_t i = 0; i < n; ++i)
                (*components(now)[d])[i] =
                    ((*components(now)[d])[i] -
                     (substrate.relaxes() ? (*components(substrate.offset())[d])[i] : 0)) /
                    substrate.stiffness();
        last = substrate.end(next, now);
        t = next;
        u = now;
        dissipated += last.dissipated;
        work += last.work;
    }
    Substrate& substrate;
    SurfaceField t{n}, u{n};
    Substrate::Energies last{};
    double dissipated = 0, work = 0;
};

void expect_near(const SurfaceField& a, const SurfaceField& b, double tolerance) {
    for (int d = 0; d < 3; ++d)
        for (std::size_t i = 0; i < n; ++i)
            EXPECT_NEAR((*components(a)[d])[i], (*components(b)[d])[i],
                        tolerance * std::abs((*components(b)[d])[i]))
                << d << ' ' << i;
}

// Tractions grow at a constant rate, then stay: the hereditary integral of the creep function,
// whose spring and time are those of a spring beside a standard solid. Steps of any length are
// exact; 1e-7 is the interpolation.
TEST(PartlyRelaxingSubstrate, CreepsByTheHereditaryIntegral) {
    const double spring = .8, stays = .25, g = 1.5, tau = .2, ramp = .3;
    auto body = partly(solid, spring, stays);
    Loading run(body);
    const double relaxed = 1 / (1 + spring), glassy = 1 / (1 + g + spring);
    const double late = tau * (1 + spring + g) / (1 + spring);
    auto creep_integral = [&](double s) {  // of J from 0 to s
        return relaxed * s - (relaxed - glassy) * late * (1 - std::exp(-s / late));
    };
    double time = 0;
    for (const double duration : {.1, .13, .07, .02, .4, 2., 30.}) {
        time += duration;
        const double f = std::min(1., time / ramp);
        run.to(load(f), duration);
        const double creep =
            (creep_integral(time) - (time > ramp ? creep_integral(time - ramp) : 0)) / ramp;
        expect_near(run.u, displaced(creep + f * stays, load(1)), 1e-7);
        // Algebra of the step, exact but for the rounding of weights of 1e5.
        EXPECT_NEAR(run.work, run.last.stored + run.dissipated, 1e-9 * run.work);
    }
    const double end = work(load(1), displaced(relaxed + stays, load(1))) / 2;
    EXPECT_NEAR(run.last.stored / end, 1, 1e-6);
}

// At once it is glassy; what then creeps dissipates half the work of the load that follows it.
TEST(PartlyRelaxingSubstrate, LoadAtOnce) {
    const double spring = .8, g = 1.5;
    auto body = partly(solid, spring, 0);
    Loading run(body);
    run.to(load(1), 0);
    expect_near(run.u, displaced(1 / (1 + g + spring), load(1)), 1e-7);
    EXPECT_NEAR(run.dissipated, 0, 1e-9 * run.work);
    run.to(load(1), std::numeric_limits<double>::infinity());
    expect_near(run.u, displaced(1 / (1 + spring), load(1)), 1e-7);
    const double crept = 1 / (1 + spring) - 1 / (1 + g + spring);
    EXPECT_NEAR(run.dissipated / (work(load(1), displaced(crept, load(1))) / 2), 1, 1e-6);
    // Slowly, nothing is lost.
    body.forget();
    Loading slow(body);
    slow.to(load(1), std::numeric_limits<double>::infinity());
    EXPECT_EQ(slow.dissipated, 0);
    EXPECT_NEAR(slow.work / slow.last.stored, 1, 1e-9);
}

// Where all relaxes, another road to what RelaxingSubstrate does; between the steps one takes the
// tractions for linear, the other the displacements: they meet with the second order.
TEST(PartlyRelaxingSubstrate, MeetsTheCommonFactor) {
    const Relaxation rubber{{{1.5, .2}, {.4, .9}}, {}};
    struct Difference {
        double displacement, stored, dissipated;
    };
    auto difference = [&](int steps) {
        auto one = partly(rubber, 0, 0);
        contact::RelaxingSubstrate other(std::make_shared<Body>(1), rubber);
        Loading a(one), b(other);
        for (int k = 1; k <= steps; ++k) {
            const double phase = 4. * k / steps;
            a.to(load(std::sin(phase)), phase / k / 5);
            b.to(load(std::sin(phase)), phase / k / 5);
        }
        return Difference{a.u.down[0] - b.u.down[0], a.last.stored - b.last.stored,
                          a.dissipated - b.dissipated};
    };
    const Difference coarse = difference(40), fine = difference(80);
    EXPECT_NEAR(std::log2(coarse.displacement / fine.displacement), 2, .1);
    EXPECT_NEAR(std::log2(coarse.stored / fine.stored), 2, .1);
    EXPECT_NEAR(std::log2(coarse.dissipated / fine.dissipated), 2, .1);
}

TEST(PartlyRelaxingSubstrate, GoesOnFromWhatWasWritten) {
    auto body = partly(solid, .8, .25);
    Loading run(body);
    run.to(load(1), .1);
    run.to(load(.4), .1);
    contact::StateWriter out;
    body.transfer(out);
    const std::string bytes = out.take();
    const auto other = body.fresh(true);
    contact::StateReader in(bytes);
    other->transfer(in);
    EXPECT_TRUE(in.at_end());
    Loading again(*other);
    again.t = run.t;
    again.u = run.u;
    run.to(load(.5), .1);
    again.to(load(.5), .1);
    expect_near(run.u, again.u, 0);
    EXPECT_EQ(run.last.dissipated, again.last.dissipated);
}

// Another step needs another compliance only if its duration is another one.
TEST(PartlyRelaxingSubstrate, SaysWhenTheComplianceChanges) {
    auto body = partly(solid, .8, 0);
    const SurfaceField none(n);
    EXPECT_TRUE(body.begin(.1, none, none));
    EXPECT_FALSE(body.begin(.1, none, none));
    EXPECT_TRUE(body.begin(.2, none, none));
}

// The work on the surface of a body that is not self-adjoint is not what it stores.
TEST(ElasticSubstrate, EnergiesTellALopsidedBody) {
    contact::ElasticSubstrate body(std::make_shared<Body>(1));
    Loading run(body);
    run.to(load(1), 1);
    EXPECT_NEAR(run.last.work / run.last.stored, 1, 1e-14);
    EXPECT_NEAR(run.last.stored, work(run.t, run.u) / 2, 1e-14 * run.last.stored);
    const double before = run.last.stored;
    // One point follows a traction of another, which does not follow the first.
    SurfaceField next = load(1), u = run.u;
    next.down[0] += 1;
    u.down[1] += .1;
    body.begin(1, run.t, run.u);
    const auto energies = body.end(next, u);
    EXPECT_GT(std::abs(energies.work - (energies.stored - before)), .01 * before);
}

}  // namespace
}  // namespace tricontact::substrate_test
