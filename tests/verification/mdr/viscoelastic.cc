// A sphere on a relaxing half-space: Lee and Radok's closed forms while the contact grows, Ting's
// equations while it recedes, neither of which knows of springs.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <numeric>
#include <vector>

#include "contact/friction/friction.h"
#include "contact/run.h"
#include "mdr/model.h"
#include "mdr/relaxing_bed.h"
#include "tests/verification/mdr/roller.h"

namespace tricontact::mdr_viscoelastic_test {
namespace {

using contact::LoadStep;
using contact::NormalControl;
using contact::Relaxation;
using contact::TangentialControl;

constexpr double radius = 40e-3, modulus = 6.9e6, shear_modulus = 4.6e6;  // E*, G* relaxed
constexpr double ratio = 1.6, relaxes_in = .35;                           // g, tau
constexpr double retarded_in = (1 + ratio) * relaxes_in;                  // of creep

mdr::RelaxingBed make_bed(double friction = .5, int springs = 4000) {
    mdr::BedData data;
    data.profile = std::make_unique<mdr::PowerLawProfile>(1 / (2 * radius), 2);
    data.effective_modulus = modulus;
    data.effective_shear_modulus = shear_modulus;
    data.friction = contact::Friction{friction}.law();
    data.n_springs = springs;
    data.half_length = 6e-3;
    data.relaxation = Relaxation{{{ratio, relaxes_in}}, {}};
    return mdr::RelaxingBed(std::move(data));
}

LoadStep press(double duration, NormalControl control) {
    LoadStep step;
    step.duration = duration;
    step.normal = control;
    step.tangential[0].kind = TangentialControl::Kind::shift;
    return step;
}

NormalControl force(double value) {
    return {NormalControl::Kind::force, value};
}
NormalControl depth(double value) {
    return {NormalControl::Kind::indentation, value};
}

double quadrature(const std::function<double(double)>& f, double begin, double end) {
    return boost::math::quadrature::tanh_sinh<double>().integrate(f, begin, end);
}

/// G(t)/G_inf.
double relaxation(double t) {
    return 1 + ratio * std::exp(-t / relaxes_in);
}

/// Errors over three step sizes: second order, the finest within `allowed`. Prints a row of
/// docs/explanation/models/mdr.md.
void expect_second_order(const char* test, const std::function<double(int)>& error,
                         std::array<int, 3> steps, double allowed) {
    std::array<double, 3> found{};
    for (int k = 0; k < 3; ++k) found[k] = error(steps[k]);
    fmt::print("| {} | {} | {:.1e} | {} | {:.1e} | {} | {:.1e} |\n", test, steps[0], found[0],
               steps[1], found[1], steps[2], found[2]);
    for (int k = 0; k < 2; ++k)
        EXPECT_NEAR(std::log(found[k] / found[k + 1]) /
                        std::log(static_cast<double>(steps[k + 1]) / steps[k]),
                    2, .15)
            << found[k] << " " << found[k + 1];
    EXPECT_LT(std::abs(found[2]), allowed);
}

// Lee and Radok (1960): F = 4 sqrt(R)/3 E* d^(3/2) with the modulus' inverse as an operator, so
// that d^(3/2) creeps as 1 - g/(1+g) exp(-t/((1+g) tau)).
TEST(MdrViscoelastic, CreepUnderAForceThatIsAppliedAtOnce) {
    constexpr double load = 12, time = .8;
    const double relaxed = .75 * load / (modulus * std::sqrt(radius));  // d^(3/2)
    auto at = [&](double t) {
        return std::cbrt(
            std::pow(relaxed * (1 - ratio / (1 + ratio) * std::exp(-t / retarded_in)), 2));
    };
    auto error = [&](int n) {
        auto bed = make_bed();
        EXPECT_NEAR(bed.advance(press(0, force(load))).indentation / at(0), 1, 1e-6);  // dx^2
        double d = 0;
        for (int k = 0; k < n; ++k) d = bed.advance(press(time / n, force(load))).indentation;
        EXPECT_NEAR(bed.scales().contact_radius / std::sqrt(radius * d), 1, 1e-5);
        return d / at(time) - 1;
    };
    expect_second_order("F_N applied at once, d after 2.3 tau (Lee and Radok 1960)", error,
                        {10, 20, 41}, 3e-4);
    auto bed = make_bed();
    bed.advance(press(0, force(load)));
    const double last =
        bed.advance(press(std::numeric_limits<double>::infinity(), force(load))).indentation;
    EXPECT_NEAR(std::pow(last, 1.5) / relaxed, 1, 1e-6);  // dx^2
}

// The same with d = v t: F = 4 sqrt(R)/3 E* [d^(3/2) + g 3/2 v^(3/2) ∫ sqrt(s) exp((s-t)/tau) ds],
// and p0 likewise of E*/(pi R) 2 a(t): p at the centre is -1/pi ∫ q'/x dx, of each spring's past.
TEST(MdrViscoelastic, PressedAtConstantRate) {
    constexpr double rate = .4e-3, time = 1.1;
    const double branch =
        1.5 * quadrature([](double s) { return std::sqrt(s) * std::exp((s - time) / relaxes_in); },
                         0, time);
    const double exact = 4. / 3 * std::sqrt(radius) * modulus * std::pow(rate, 1.5) *
                         (std::pow(time, 1.5) + ratio * branch);
    auto error = [&](int n) {
        auto bed = make_bed();
        double found = 0;
        for (int k = 1; k <= n; ++k)
            found = bed.advance(press(time / n, depth(rate * time * k / n))).normal_force;
        return found / exact - 1;
    };
    expect_second_order("d = v t, F_N after 3.1 tau (Lee and Radok 1960)", error, {15, 30, 61},
                        1e-3);
}

// Ting (1966), J. Appl. Mech. 33, 845: where the contact recedes, it is as wide as it was at the
// time t1 before, given by ∫_t1^t G(t-s) d'(s) ds = 0, and F = 4 sqrt(R)/3 E* ∫_0^t1 G(t-s)/G_inf
// (d^(3/2))'(s) ds: only what was pressed until t1 counts.
struct Ting {
    double rate, top;  // of d = v t up to the time `top`, then back

    double moved(double from, double to, double t) const {  // ∫ G(t-s)/G_inf ds
        return to - from +
               ratio * relaxes_in *
                   (std::exp((to - t) / relaxes_in) - std::exp((from - t) / relaxes_in));
    }
    double contact_time(double t) const {  // t1; 0 when contact is lost
        if (t <= top) return t;
        auto balance = [&](double t1) { return moved(t1, top, t) - moved(top, t, t); };
        if (balance(0) <= 0) return 0;
        const auto [low, high] = boost::math::tools::bisect(
            balance, 0., top, boost::math::tools::eps_tolerance<double>(48));
        return std::midpoint(low, high);
    }
    double force(double t) const {
        const double until = contact_time(t);
        if (until == 0) return 0;
        auto integrand = [&](double s) { return relaxation(t - s) * 1.5 * std::sqrt(s); };
        return 4. / 3 * std::sqrt(radius) * modulus * std::pow(rate, 1.5) *
               quadrature(integrand, 0, until);
    }
    double half_width(double t) const { return std::sqrt(radius * rate * contact_time(t)); }
};

TEST(MdrViscoelastic, RecedingContactFollowsTing) {
    constexpr double top = .9;
    const Ting ting{.5e-3, top};
    const double largest = ting.force(top);
    auto error = [&](int n) {  // worst along the way
        auto bed = make_bed();
        double worst = 0;
        for (int k = 1; k < 2 * n; ++k) {
            const double t = top * k / n, d = ting.rate * (k <= n ? t : 2 * top - t);
            const auto r = bed.advance(press(top / n, depth(d)));
            worst = std::max(worst, std::abs(r.normal_force - ting.force(t)) / largest);
            if (r.normal_force > .05 * largest) {
                // The edge is a spring of the last steps: the first order in dt, and dx.
                EXPECT_NEAR(bed.scales().contact_radius / ting.half_width(t), 1, 2. / n) << k;
            }
            EXPECT_EQ(r.normal_force > 0, r.contact_area > 0);
        }
        // Contact is lost before the indenter is back: the surface is still on its way.
        EXPECT_EQ(bed.advance(press(1e-9, depth(.01 * ting.rate * top))).normal_force, 0);
        EXPECT_TRUE(bed.audit().passed());
        return worst;
    };
    expect_second_order("d = v t, then back, 2.6 tau each (Ting 1966), steps one way", error,
                        {20, 40, 81}, 1e-3);
}

// Relaxed under a held indentation, then withdrawn by some depth at once: each spring loses its
// share with the stiff modulus, q/E* = (d - g) - (1+g_1) drop where that is positive.
TEST(MdrViscoelastic, WithdrawnAtOnceAfterRelaxation) {
    constexpr double d = .4e-3, drop = .2 * d;
    auto bed = make_bed();
    bed.advance(press(0, depth(d)));
    bed.advance(press(std::numeric_limits<double>::infinity(), depth(d)));
    const double kept = d - (1 + ratio) * drop;
    const double exact = 4. / 3 * modulus * std::sqrt(radius) * std::pow(kept, 1.5);
    EXPECT_NEAR(bed.advance(press(0, depth(d - drop))).normal_force / exact, 1, 1e-6);  // dx^2
}

// Stuck everywhere, a constant F_T creeps sideways as the springs do.
TEST(MdrViscoelastic, StuckContactCreepsSideways) {
    constexpr double d = .4e-3, load = 3, time = .5;
    const double exact =
        (1 - ratio / (1 + ratio) * std::exp(-time / retarded_in)) / (1 - ratio / (1 + ratio));
    auto error = [&](int n) {
        auto bed = make_bed(1e9);
        bed.advance(press(0, depth(d)));
        LoadStep step = press(0, depth(d));
        step.tangential[0] = {TangentialControl::Kind::force, load};
        const double first = bed.advance(step).shift[0];
        // U = F_T/(2 G a), G a of the springs in contact: their number is 2 a/dx up to one or two
        const double stiffness = 2 * shear_modulus * (1 + ratio) * std::sqrt(radius * d);
        EXPECT_NEAR(first * stiffness / load, 1, 1e-3);
        step.duration = time / n;
        double shift = 0;
        for (int k = 0; k < n; ++k) shift = bed.advance(step).shift[0];
        return shift / first / exact - 1;
    };
    expect_second_order("stuck, F_T applied at once, U after 1.4 tau", error, {10, 20, 41}, 1e-3);
}

/// f_T,lim of a contact that has relaxed upright and is then rolled by w = W/a to either side, too
/// fast to relax any further, in units of a, d and E*: the springs carry q = [(1+g)(d1 - (x-s)^2) -
/// g (1-x^2)]+ at the offset s, d1 given by F_N = 4/3; where both brackets count, a parabola about
/// (1+g) s. The limit is ∫ min q dx over F_N.
double fast_limit(double g, double w) {
    constexpr int n = 20000, n_offsets = 41;
    constexpr double reach = 1.5, dx = 2 * reach / n;
    const auto q = [g](double x, double s, double depth) {
        const double shape = (1 + g) * (depth - (x - s) * (x - s)) - g * std::max(0., 1 - x * x);
        return std::max(0., shape);
    };
    const auto place = [](int i) { return -reach + (i + .5) * dx; };
    std::vector<double> least(n, 1e9);
    for (int k = 0; k < n_offsets; ++k) {
        const double s = w * (2. * k / (n_offsets - 1) - 1);
        const auto excess = [&](double depth) {
            double sum = 0;
            for (int i = 0; i < n; ++i) sum += q(place(i), s, depth) * dx;
            return sum - 4. / 3;
        };
        const auto [low, high] = boost::math::tools::bisect(
            excess, .5, 1.5, boost::math::tools::eps_tolerance<double>(40));
        for (int i = 0; i < n; ++i)
            least[i] = std::min(least[i], q(place(i), s, std::midpoint(low, high)));
    }
    return std::accumulate(least.begin(), least.end(), 0.) * dx / (4. / 3);
}

// Rolling that leaves no time to relax moves the pressure 1 + g times as far: the limit of
// shakedown falls, and what shakes down slowly may ratchet.
TEST(MdrViscoelastic, FastRollingLowersTheLimitOfShakedown) {
    constexpr double w = .24, g = .3;
    // Slow: the elastic limit 1 - 3/2 w + 1/2 w^3; checks the quadrature (41 offsets, dx^2).
    EXPECT_NEAR(fast_limit(0, w), 1 - 1.5 * w + .5 * w * w * w, 1e-6);
    contact::Case c = mdr_test::sphere_rig(w, .6, 4000, 10);
    c.relaxation = Relaxation{{{g, .7}}, {}};
    c.load.hold = 600;  // 860 tau
    c.rolling->run_all = true;
    const auto limit = [&](double speed, int periods) {
        c.rolling->speed = speed;
        c.rolling->periods = periods;
        return contact::run(c, *mdr::make_model(c));
    };
    const auto fast = limit(1e6, 60);
    EXPECT_NEAR(fast.limit_tangential_ratio, fast_limit(g, w),
                1e-5);  // springs at the edges: dx^1.5
    EXPECT_LT(fast.limit_tangential_ratio, .6);
    // The shift grows as fast as in the middle of the run; but sixty such periods are over before
    // the substrate creeps, so that the verdict is open.
    const auto& u = fast.shift_per_period;
    EXPECT_NEAR((u[59] - u[58]) / (u[29] - u[28]), 1, 1e-3);
    EXPECT_EQ(fast.verdict.state, contact::State::undecided);
    EXPECT_NE(fast.verdict.missing.find("still creeps"), std::string::npos);
    const auto slow = limit(1e-9, 60);
    EXPECT_NEAR(slow.limit_tangential_ratio, fast_limit(0, w), 1e-5);
    EXPECT_EQ(slow.verdict.state, contact::State::shakedown);
}

// Infinitely slow rolling is elastic; at the rig's speed the rubber's time is felt, if only just.
TEST(MdrViscoelastic, OscillatingRolling) {
    contact::Case c = mdr_test::sphere_rig(.24, .56, 1000, 10);
    auto settled = [](const contact::Case& of) { return contact::run(of, *mdr::make_model(of)); };
    const auto elastic = settled(c);
    c.relaxation = Relaxation{{{.3, .02}}, {}};
    const auto slow = settled(c);  // speed 0: infinitely slow
    // F_T is applied at once, on stiff rubber; what is settled does not know. Settled to 1e-7.
    EXPECT_LT(slow.static_shift, .9 * elastic.static_shift);
    EXPECT_NEAR(slow.shift_per_period.back() / elastic.shift_per_period.back(), 1, 1e-7);

    c.rolling->speed = 1e-3;  // of the rig: f tau = 4e-3
    c.load.hold = 60;
    c.rolling->run_all = true;
    const auto rig = settled(c);
    EXPECT_TRUE(rig.audit.passed());
    double material = 0;
    for (const auto& step : rig.steps) material += step.material_dissipation;
    EXPECT_GT(material, 0);
    EXPECT_NEAR(rig.shift_per_period.back() / elastic.shift_per_period.back(), 1, .02);
    EXPECT_GT(std::abs(rig.shift_per_period.back() / elastic.shift_per_period.back() - 1), 1e-5);

    // Thesis, eq. 5.1.17: eta = 40 Pa s, omega eta/G1 = 3e-5: elastic if F_T waits for the
    // pressing.
    c.load.press_time.reset();
    const double shear = c.substrate.shear_modulus();
    c.relaxation = Relaxation{{{1., 40 / shear}}, {}};
    const auto thesis = settled(c);
    EXPECT_NEAR(thesis.static_shift / elastic.static_shift, 1, 1e-4);
    EXPECT_NEAR(thesis.shift_per_period.back() / elastic.shift_per_period.back(), 1, 1e-4);
    EXPECT_NE(thesis.shift_per_period.back(), elastic.shift_per_period.back());
}

}  // namespace
}  // namespace tricontact::mdr_viscoelastic_test
