#include <array>

#include "bem/model.h"
#include "contact/cells.h"
#include "contact/models/model_kind.h"
#include "contact/solvers/contact_region.h"
#include "contact/solvers/normal_solver.h"
#include "mdr/settings.h"
#include "rolling/creep_theory.h"
#include "rolling/linear_creep.h"
#include "theory/creep_law.h"
#include "theory/rolling/kalker.h"
#include "verification/verification_rows.h"

namespace tricontact::verification {

namespace {

constexpr double rolling_force = .56;

Case rolling_on(double nu) {
    Case c = rig_sphere(nu, rolling_force);
    c.tractive_rolling.emplace().distance = .01;
    return c;
}

Case cylinder() {
    Case c = rolling_on(.5);
    c.indenter.shape = Case::Shape::cylinder;
    c.indenter.length = 8;  // (a/L)^2 of the strip is nothing
    *c.load.normal_force *= 100;
    return c;
}

/// Of bem, with so many cells in the radius, which `c` keeps.
rolling::RollingState steady_state(Case& c, double cells, const char* what, const Runner& runner) {
    c.of<contact::Cells>().per_radius = cells;
    runner.say(fmt::format("bem, {}, {} cells", what, cells));
    return runner.roll(contact::models::bem, c).history.steady;
}

/// Errors of cells are of the first order: adds rows of what two grids, one half as fine as the
/// other, lead to.
template <class Level>
void add_extrapolated(std::vector<VerificationRow> rows, Verification& all, const Level& level) {
    std::vector<double> before;
    for (const int factor : {1, 2, 4, 8}) {
        const auto [size, values] = level(factor);
        for (std::size_t i = 0; i < before.size(); ++i) {
            rows[i].sizes.push_back(size);
            rows[i].values.push_back(2 * values[i] - before[i]);
        }
        before.assign(values.begin(), values.end());
    }
    for (VerificationRow& row : rows) all.rows.push_back(std::move(row));
}

void verify_springs(bool brief, const Runner& runner, Verification& all) {
    double exact = 0;
    for (const auto& theory : rolling::creep_theories(rolling_on(.5)))
        if (theory.key == "mdr_closed_form") exact = theory.creepage(rolling_force);
    add_row(
        {"Springs of MDR rolled on", "xi, f_T = 0.56, nu = 1/2", contact::models::mdr,
         "Wetter, thesis (TU Berlin 2016), eqs. 2.2.24 and 2.2.27", exact, brief ? 2e-2 : 2e-3, .9},
        all, [&](int factor) -> LevelValue {
            Case c = rolling_on(.5);
            c.tractive_rolling->distance = 5;
            c.of<mdr::Settings>().springs = (brief ? 400 : 2500) * factor;
            runner.say(fmt::format("mdr, rolling on, {} springs", c.of<mdr::Settings>().springs));
            return {7. / c.of<mdr::Settings>().springs,
                    runner.roll(contact::models::mdr, c).history.steady.creepage.longitudinal};
        });
}

void verify_carter(bool brief, const Runner& runner, Verification& all) {
    add_extrapolated(
        {{"Carter", "xi R/(mu a), f_T = 0.56", contact::models::bem,
          "Carter (1926); Johnson, Contact Mechanics (1985), eq. 8.48; extrapolated "
          "from this and twice the size of cells",
          theory::carter_creepage_ratio(rolling_force), brief ? 2e-2 : 3e-3},
         {"Carter", "c/a, f_T = 0.56", contact::models::bem,
          "Johnson, Contact Mechanics (1985), eq. 8.46; likewise; whole cells stick",
          theory::carter_stick_ratio(rolling_force), brief ? .05 : 3e-3}},
        all, [&](int factor) {
            Case c = cylinder();
            const auto steady =
                steady_state(c, (brief ? 10 : 40) * factor, "rolling cylinder", runner);
            return std::pair(relative_size(contact::models::bem, c),
                             std::array{steady.creepage.longitudinal / rolling::creepage_unit(c),
                                        steady.stick_area / steady.contact_area});
        });
}

/// C11, C22, C23 and C33 of the pressed contact, a circle of the area that its pressure has.
std::array<double, 4> coefficients(const Case& c) {
    const auto compliance = bem::case_compliance(c, 1, bem::Body::half_space);
    const auto pressed =
        contact::NormalSolver(*compliance, 1e-9)
            .solve(contact::heights_over(compliance->points(), *c.make_indenter(), {}),
                   contact::press_step(c).normal);
    const auto creep = rolling::linear_creep(*compliance, pressed.pressure);
    const double a = contact::half_space_scales(c).contact_radius;
    const double stiffness = theory::combined_material(c.materials()).shear_modulus * a * a;
    return {creep[0][0] / stiffness, creep[1][1] / stiffness, creep[1][2] / (stiffness * a),
            creep[2][2] / (stiffness * a * a)};
}

void verify_kalker(const Runner& runner, Verification& all) {
    constexpr const char* names[] = {"C11", "C22", "C23", "C33"};
    constexpr double half_digit = 6e-3;  // half of the last digit of 1.16, and cells
    for (const double nu : {0., .25, .5}) {
        const theory::KalkerCoefficients table = theory::kalker_coefficients(1, nu);
        const double expected[] = {table.longitudinal, table.lateral, table.spin, table.moment};
        std::vector<VerificationRow> rows;
        for (std::size_t i = 0; i < 4; ++i)
            rows.push_back({"Linear creep", fmt::format("{}, nu = {}", names[i], nu),
                            contact::models::bem,
                            "Kalker (1990), Three-Dimensional Elastic Bodies in Rolling "
                            "Contact, table E.3, three digits; extrapolated from this and "
                            "twice the size of cells",
                            expected[i], half_digit});
        add_extrapolated(std::move(rows), all, [&](int factor) {
            const Case c = with_cells(rolling_on(nu), 8 * factor);
            runner.say(fmt::format("bem, creep without slip, nu = {}, {} cells", nu,
                                   *c.of<contact::Cells>().per_radius));
            return std::pair(relative_size(contact::models::bem, c), coefficients(c));
        });
    }
}

/// Rolled freely over a relaxing half-space: the pressure leads the cylinder.
void verify_hunter(bool brief, const Runner& runner, Verification& all) {
    constexpr double relaxation_time = .3;
    Case c = cylinder();
    c.load.tangential_ratio = 0;
    c.relaxation = contact::Relaxation{{{2, relaxation_time}}, {}};
    c.tractive_rolling->speed = .5 * contact::half_space_scales(c).contact_radius / relaxation_time;
    double exact = 0;
    for (const auto& theory : rolling::resistance_theories(c))
        if (theory.key == "hunter") exact = 1e3 * theory.value;
    add_row(
        {"Cylinder over a standard solid, v tau = a/2, G2 = 2 G1", "1000 W/F_N",
         contact::models::bem, "Hunter (1961), J. Appl. Mech. 28, 611", exact, brief ? 1e-2 : 2e-3},
        all, [&](int factor) -> LevelValue {
            const auto steady = steady_state(c, (brief ? 6 : 10) * factor, "relaxing", runner);
            return {relative_size(contact::models::bem, c),
                    1e3 * steady.resistance / *c.load.normal_force};
        });
}

/// A rigid cylinder on a half-space of nu = 0, the most dissimilar that there is, without F_T; so
/// little friction that all slips.
void verify_free_rolling(bool brief, const Runner& runner, Verification& all) {
    Case c = cylinder();
    c.substrate.poisson = 0;
    c.contact.coupling = true;
    c.friction.coefficient = .002;
    c.load.tangential_ratio = 0;
    add_row({"Free rolling, Dundurs' beta = 0.5", "xi R/a, mu = 0.002", contact::models::bem,
             "Bentall and Johnson (1967), Int. J. Mech. Sci. 9, 389, without friction "
             "(theory/creep_law.h): the difference is of the order of mu/beta",
             theory::smooth_free_creepage(.5), brief ? 2e-2 : 5e-3},
            all, [&](int factor) -> LevelValue {
                const auto steady = steady_state(c, 15 * factor, "dissimilar cylinders", runner);
                return {relative_size(contact::models::bem, c),
                        steady.creepage.longitudinal * c.indenter.radius /
                            contact::half_space_scales(c).contact_radius};
            });
}

}  // namespace

void verify_rolling(bool brief, const Runner& runner, Verification& all) {
    verify_springs(brief, runner, all);
    verify_carter(brief, runner, all);
    verify_kalker(runner, all);
    verify_hunter(brief, runner, all);
    verify_free_rolling(brief, runner, all);
}

}  // namespace tricontact::verification
