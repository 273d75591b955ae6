#include <cmath>
#include <numbers>

#include "app/verification/verification_problems.h"
#include "app/verification/verification_rows.h"
#include "theory/friction_pressing.h"

namespace tricontact::app {

namespace {

using comparisons::Verification;
using comparisons::VerificationRow;
using contact::Case;
using contact::StepRecord;

Case pressing_case(double nu, double friction) {
    Case c;
    c.indenter.radius = 40e-3;
    c.substrate = {5e6, nu};
    c.friction_coefficient = friction;
    c.load.normal_force = 20;
    c.load.tangential_force = 0;
    return c;
}

/// F_N rises with friction in equal steps.
std::vector<StepRecord> press(const Case& c, int n_steps, const Say& say) {
    const auto model = make_model("bem", c, 1, say);
    contact::LoadStep step = contact::press_step(c);
    std::vector<StepRecord> records;
    for (int k = 1; k <= n_steps; ++k) {
        step.normal.value = *c.load.normal_force * k / n_steps;
        records.push_back(model->advance(step));
    }
    return records;
}

/// Cells and steps halve together: a ring that has just come into contact starts undragged.
void add_pressing(VerificationRow row, const Case& base, int cells, int steps, const Say& say,
                  Verification& all, double (*value)(const Case&, const std::vector<StepRecord>&)) {
    row.model = "bem";
    for (const int factor : {1, 2, 4}) {
        Case c = base;
        c.bem.cells_per_radius = cells * factor;
        row.sizes.push_back(1 / *c.bem.cells_per_radius);
        row.values.push_back(value(c, press(c, steps * factor, say)));
    }
    all.rows.push_back(std::move(row));
}

double stick_ratio(const Case&, const std::vector<StepRecord>& records) {
    return std::sqrt(records.back().stick_area / records.back().contact_area);
}

/// dF/dd over 4 G a of the last quarter.
double stiffness_ratio(const Case& c, const std::vector<StepRecord>& records) {
    const StepRecord &last = records.back(), &before = records[records.size() * 3 / 4];
    const double a = std::sqrt((last.contact_area + before.contact_area) / 2 / std::numbers::pi);
    return (last.normal_force - before.normal_force) / (last.indentation - before.indentation) /
           (4 * c.substrate.shear_modulus() * a);
}

}  // namespace

void verify_friction_pressing(const Say& say, Verification& all) {
    const double nu = .45, beta = (1 - 2 * nu) / (2 - 2 * nu), beta_over_mu = 1.4;
    VerificationRow stick{.problem = "Pressed with friction",
                          .quantity = "c/a, nu = 0.45, beta/mu = 1.4",
                          .source =
                              "Goodman (1962), Spence (1968); Johnson, Contact Mechanics "
                              "(1985), section 5.4, weak coupling",
                          .reference = theory::spence_stick_ratio(beta_over_mu),
                          .tolerance = .02,
                          .least_order = .8};
    add_pressing(stick, pressing_case(nu, beta / beta_over_mu), 12, 10, say, all, stick_ratio);
    VerificationRow stiffness{.problem = "Pressed without slip",
                              .quantity = "dF/dd over 4 G a, nu = 0",
                              .source = "Mossakovskii (1954), Spence (1968)",
                              .reference = theory::stuck_normal_stiffness_ratio(0),
                              .tolerance = 8e-3};
    add_pressing(stiffness, pressing_case(0, 5), 12, 8, say, all, stiffness_ratio);
}

}  // namespace tricontact::app
