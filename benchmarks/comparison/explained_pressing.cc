#include "benchmarks/comparison/explained_pressing.h"

#include <algorithm>
#include <cmath>

#include "benchmarks/comparison/explained.h"
#include "benchmarks/reference/radial_contact.h"
#include "benchmarks/reference/reference_kinds.h"
#include "benchmarks/reference/ring_contact.h"
#include "contact/half_space_scales.h"

namespace tricontact::benchmarks {

namespace {

namespace keys = quantity_keys;
constexpr int fine_rings = 100;       // in a
constexpr double fitted_within = .3;  // of a, as the peak of a code's field
constexpr double second_order = .4;   // as of the force, see explained.h

/// p0 by a paraboloid fitted inside .3 a; root of the second moment of the pressure over the force.
double number_of(const std::string& key, const RingContact& rings, const RingContact::State& state,
                 double a) {
    double s0 = 0, s1 = 0, s2 = 0, b0 = 0, b1 = 0, force = 0, moment = 0;
    for (std::size_t i = 0; i < rings.radii().size(); ++i) {
        const double r = rings.radii()[i], p = state.pressure[i], q = r * r / (a * a);
        force += p * r;
        moment += p * r * q;
        if (r > fitted_within * a) continue;
        s0 += 1;
        s1 += q;
        s2 += q * q;
        b0 += p;
        b1 += q * p;
    }
    return key == keys::peak_pressure ? (b0 * s2 - b1 * s1) / (s0 * s2 - s1 * s1)
                                      : std::sqrt(moment / force);
}

std::optional<double> change(const std::string& key, const Reference& reference, int n_rings,
                             const InterfaceLaw& law) {
    const RingContact rings(reference.c, reference.contact_radius, n_rings);
    const contact::NormalControl control = final_normal(reference.c);
    const auto with = rings.solve(control, law), without = rings.solve(control, {});
    if (!with || !without) return {};
    const double a = reference.contact_radius;
    return number_of(key, rings, *with, a) / number_of(key, rings, *without, a) - 1;
}

}  // namespace

std::vector<Explained> explained_pressing(const std::string& key, const Submission& submission,
                                          const Reference& reference) {
    const contact::Case& c = reference.c;
    if ((key != keys::peak_pressure && key != keys::contact_radius) || c.tractive_rolling ||
        c.rolling || !is_uncoupled(c) || !has_exact_radial_contact(c) ||
        contact::has_conical_tip(c))
        return {};
    std::vector<Explained> all;
    const auto add = [&](const char* id, const char* title, const InterfaceLaw& law, double bar) {
        const auto fine = change(key, reference, fine_rings, law),
                   coarse = change(key, reference, fine_rings / 2, law);
        if (fine && coarse) all.push_back({id, title, *fine, std::hypot(*fine - *coarse, bar)});
    };
    const ContactMethod& method = submission.contact;
    if (method.stiffness)
        add("penalty", "normal penalty", {.compliance = 1 / *method.stiffness}, 0);
    if (method.kinematics == ContactMethod::Kinematics::displaced ||
        method.kinematics == ContactMethod::Kinematics::finite) {
        const double slope = edge_slope(reference);
        double bar = second_order * slope * slope;
        if (key == keys::peak_pressure) {
            const RadialContact contact(c, final_normal(c));
            const double r = .1 * contact.radius();
            bar = std::max(bar, std::abs(2 * contact.radial_displacement(r) / r));
        }
        add("displaced_surface", "contact on the displaced surface", {.is_displaced = true}, bar);
    }
    return all;
}

}  // namespace tricontact::benchmarks
