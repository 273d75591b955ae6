#include <array>
#include <boost/math/tools/minima.hpp>
#include <numbers>

#include "app/verification/verification_problems.h"
#include "app/verification/verification_rows.h"
#include "contact/run.h"
#include "contact/solvers/subsurface.h"
#include "theory/axisymmetric_interior.h"

namespace tricontact::app {

namespace {

using contact::Case;

/// Von Mises' stress over p0 on the axis of Hertz' contact, at the depth z.
double on_axis(const Case& c, const contact::HalfSpaceScales& hertz, double z) {
    const double a = hertz.contact_radius, p0 = hertz.peak_pressure;
    const auto line_load = [&](double t) {
        return std::numbers::pi / 2 * p0 * (a - t) * (a + t) / a;
    };
    const auto response = theory::axisymmetric_interior(c.substrate, line_load, a, 0, 0, z);
    std::array<double, 6> stress{};
    for (int k = 0; k < 6; ++k) stress[k] = response.stress[k][2] / p0;
    return contact::von_mises(stress);
}

}  // namespace

void verify_subsurface(bool brief, const Say& say, comparisons::Verification& all) {
    const Case base = rig_sphere(0.3, 0);  // nu as in the textbooks
    const auto hertz = contact::half_space_scales(base);
    const double a = hertz.contact_radius;
    const auto lowest = boost::math::tools::brent_find_minima(
        [&](double z) { return -on_axis(base, hertz, z); }, .2 * a, a, 40);
    comparisons::VerificationRow row{
        .problem = "Below Hertz' contact",
        .quantity = "largest von Mises stress over p0, nu = 0.3",
        .model = "bem",
        .source = "Huber (1904); Johnson, Contact Mechanics (1985), eq. 3.45; at 0.48 a",
        .reference = -lowest.second,
        .tolerance = brief ? 4e-3 : 1e-3,
        .least_order = 0};  // points lie a/25 apart, wherever the peak is
    for (const Case& c : finer_cases(base, [&](Case&level, int factor) {
             level.bem.cells_per_radius = (brief ? 4 : 8) * factor;
         })) {
        say("bem, inside");
        const auto model = make_model("bem", c, 1, say);
        contact::run(c, *model);
        const auto inside = contact::subsurface_of(*model->interior(), 0, {0, 0});
        row.sizes.push_back(1 / *c.bem.cells_per_radius);
        row.values.push_back(inside.peak_von_mises / model->scales().peak_pressure);
    }
    all.rows.push_back(std::move(row));
}

}  // namespace tricontact::app
