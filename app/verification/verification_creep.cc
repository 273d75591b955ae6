#include <fmt/format.h>

#include <cmath>

#include "app/verification/verification_problems.h"
#include "app/verification/verification_rows.h"

namespace tricontact::app {

namespace {

using comparisons::Verification;
using contact::Case;

constexpr double ratio = 1.7, relaxes_in = .3, time = 3 * relaxes_in;

Case rubber() {
    Case c;
    c.indenter.radius = 40e-3;
    c.substrate = {4.5e6, .5};
    c.relaxation = contact::Relaxation{{{ratio, relaxes_in}}, {}};
    c.friction_coefficient = .5;
    c.contact.coupling = false;
    c.load.normal_force = 21.1;
    c.load.tangential_force = 0;
    return c;
}

/// d [mm] under F_N that was applied at once and stays.
double creep(contact::Model& model, const Case& c, int n_steps) {
    contact::LoadStep step = contact::press_step(c);
    step.duration = 0;
    model.advance(step);
    step.duration = time / n_steps;
    double d = 0;
    for (int k = 0; k < n_steps; ++k) d = model.advance(step).indentation;
    return d * 1e3;
}

}  // namespace

void verify_creep(bool brief, const Say& say, Verification& all) {
    const Case base = rubber();
    // d^(3/2) follows the creep function 1 - g/(1+g) exp(-t/((1+g) tau)).
    const double crept = 1 - ratio / (1 + ratio) * std::exp(-time / ((1 + ratio) * relaxes_in));
    const double exact =
        contact::half_space_scales(base).indentation * std::pow(crept, 2. / 3) * 1e3;
    const int steps = brief ? 3 : 8, coarser = brief ? 8 : 1;
    for (const char* const model : {"mdr", "bem"}) {
        comparisons::VerificationRow row{.problem = "Creep under F_N",
                                         .quantity = "d, mm, after 3 tau",
                                         .model = model,
                                         .source = "Lee and Radok (1960), J. Appl. Mech. 27, 438",
                                         .reference = exact,
                                         .tolerance = 5e-4 * coarser,
                                         .least_order = 1.6};
        for (const int factor : {1, 2, 4}) {
            Case c = base;
            c.bem.cells_per_radius = (brief ? 5 : 8) * factor;
            const int n = steps * factor;
            say(fmt::format("{}, creep in {} steps", model, n));
            row.sizes.push_back(time / n / relaxes_in);
            row.values.push_back(creep(*make_model(model, c, 1, say), c, n));
        }
        all.rows.push_back(std::move(row));
    }
}

}  // namespace tricontact::app
