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

/// What a law changes of the pressures of rings.
struct RingChange {
    std::vector<double> radii, change;  ///< [m], [Pa]
};

std::optional<RingChange> ring_change(const Reference& reference, int n_rings,
                                      const InterfaceLaw& law) {
    const RingContact rings(reference.c, reference.contact_radius, n_rings);
    const contact::NormalControl control = final_normal(reference.c);
    const auto with = rings.solve(control, law), without = rings.solve(control, {});
    if (!with || !without) return {};
    RingChange found{.radii = rings.radii(), .change = with->pressure};
    for (std::size_t i = 0; i < found.change.size(); ++i) found.change[i] -= without->pressure[i];
    return found;
}

/// Mean over rings of equal widths from low to high [m].
double mean_change(const RingChange& rings, double low, double high) {
    const double width = rings.radii[1] - rings.radii[0];
    double sum = 0;
    for (std::size_t i = 0; i < rings.radii.size(); ++i) {
        const double inner = std::max(low, rings.radii[i] - width / 2),
                     outer = std::min(high, rings.radii[i] + width / 2);
        if (outer > inner) sum += rings.change[i] * (outer * outer - inner * inner);
    }
    return high > low ? sum / (high * high - low * low) : 0;
}

ReferenceSamples with_change(const UnderstoodMesh& mesh, ReferenceSamples samples,
                             const RingChange& rings) {
    const auto& points = mesh.result.points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        double low, high;
        if (mesh.result.geometry == Geometry::spatial) {
            const double r = std::hypot(points[i].x, points[i].y),
                         half = std::sqrt(std::max(0., points[i].area)) / 2;
            low = std::max(0., r - half);
            high = r + half;
        } else {
            low = std::max(0., mesh.low[i]);
            high = mesh.high[i];
        }
        samples.values[i].pressure += mean_change(rings, low, high);
    }
    return samples;
}

bool has_ring_effects(const Reference& reference) {
    const contact::Case& c = reference.c;
    return !reference.has_singular_edge && !c.tractive_rolling && !c.rolling && is_uncoupled(c) &&
           has_exact_radial_contact(c) && !contact::has_conical_tip(c);
}

bool is_displaced(const ContactMethod& method) {
    return method.kinematics == ContactMethod::Kinematics::displaced ||
           method.kinematics == ContactMethod::Kinematics::finite;
}

/// Second order of the displaced surface, and the areal strain at the centre: codes differ in the
/// area that a pressure acts on.
double displaced_pressure_bar(const Reference& reference) {
    const double slope = edge_slope(reference);
    const RadialContact contact(reference.c, final_normal(reference.c));
    const double r = .1 * contact.radius();
    return std::max(second_order * slope * slope, std::abs(2 * contact.radial_displacement(r) / r));
}

}  // namespace

std::vector<Explained> explained_pressing(const std::string& key, const Submission& submission,
                                          const Reference& reference) {
    if ((key != keys::peak_pressure && key != keys::contact_radius) || !has_ring_effects(reference))
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
    if (is_displaced(method)) {
        const double slope = edge_slope(reference);
        const double bar = key == keys::peak_pressure ? displaced_pressure_bar(reference)
                                                      : second_order * slope * slope;
        add("displaced_surface", "contact on the displaced surface", {.is_displaced = true}, bar);
    }
    return all;
}

std::vector<ExplainedField> explained_fields(const Submission& submission,
                                             const Reference& reference,
                                             const std::vector<UnderstoodMesh>& meshes,
                                             const std::vector<ReferenceSamples>& samples) {
    const ContactMethod& method = submission.contact;
    const bool displaced = is_displaced(method);
    if ((!method.stiffness && !displaced) || samples.size() != meshes.size() || samples.empty() ||
        !reference.fields || !has_ring_effects(reference))
        return {};
    const InterfaceLaw law{.compliance = method.stiffness ? 1 / *method.stiffness : 0,
                           .is_displaced = displaced};
    const auto fine = ring_change(reference, fine_rings, law),
               coarse = ring_change(reference, fine_rings / 2, law);
    if (!fine || !coarse) return {};
    ExplainedField one;
    one.id = !displaced ? "penalty" : method.stiffness ? "interface" : "displaced_surface";
    one.title = !displaced         ? "normal penalty"
                : method.stiffness ? "normal penalty and displaced surface"
                                   : "contact on the displaced surface";
    if (displaced) one.bar = displaced_pressure_bar(reference);
    std::vector<ExplainedField> all;
    for (std::size_t k = 0; k < meshes.size(); ++k) {
        one.fine = with_change(meshes[k], samples[k], *fine);
        one.coarse = with_change(meshes[k], samples[k], *coarse);
        all.push_back(one);
    }
    return all;
}

}  // namespace tricontact::benchmarks
