#include "benchmarks/comparison/explained_pressing.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string_view>

#include "benchmarks/comparison/explained.h"
#include "benchmarks/reference/plane_contact.h"
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
        force += p * rings.areas()[static_cast<Eigen::Index>(i)];
        moment += p * rings.areas()[static_cast<Eigen::Index>(i)] * q;
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

/// What a law changes of the tractions of rings.
struct RingChange {
    std::vector<double> radii;     ///< [m]
    std::vector<double> pressure;  ///< [Pa]
    std::vector<double> traction;  ///< along x [Pa]; empty without
    double force = 0;              ///< change of it, of the depth where the force is given, over it
};

/// The tangential load of a case that applies it once behind the pressing, along x.
std::optional<contact::TangentialControl> applied_once(const Reference& reference) {
    using Control = contact::TangentialControl;
    const contact::Case& c = reference.c;
    if (!c.friction.is_coulomb() || !reference.has_friction() || c.rolling || c.tractive_rolling)
        return {};
    if (c.prescribed_path) {
        const auto& rows = c.prescribed_path->rows;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const auto& row = rows[i];
            if (row.tangential[1].value != 0 || row.rotation != 0) return {};
            if (i + 1 < rows.size() && row.tangential[0].value != 0) return {};
        }
        const Control& last = rows.back().tangential[0];
        if (!(last.value > 0)) return {};
        if (last.kind != Control::Kind::ratio) return last;
    }
    const ReferenceValue* force = reference.find(keys::tangential_force);
    if (!force || !(force->value > 0)) return {};
    return Control{Control::Kind::force,
                   force->value * (c.is_line_contact() ? c.indenter.length : 1)};
}

double relative_change(double with, double without) {
    return without == 0 ? 0 : with / without - 1;
}

std::optional<RingChange> ring_change(const Reference& reference, int n_rings,
                                      const InterfaceLaw& law) {
    const RingContact rings(reference.c, reference.contact_radius, n_rings);
    const contact::NormalControl control = final_normal(reference.c);
    const auto with = rings.solve(control, law), without = rings.solve(control, {});
    if (!with || !without) return {};
    RingChange found{.radii = rings.radii(), .pressure = with->pressure, .traction = {}};
    for (std::size_t i = 0; i < found.pressure.size(); ++i)
        found.pressure[i] -= without->pressure[i];
    found.force = control.kind == contact::NormalControl::Kind::force
                      ? relative_change(with->indentation, without->indentation)
                      : relative_change(with->force, without->force);
    const auto tangential = applied_once(reference);
    if (!tangential) return found;
    const double mu = reference.c.friction_coefficient();
    const auto sheared = rings.shear(*with, *tangential, mu, law),
               before = rings.shear(*without, *tangential, mu, {});
    if (!sheared || !before) return found;
    found.traction = sheared->traction;
    for (std::size_t i = 0; i < found.traction.size(); ++i)
        found.traction[i] -= before->traction[i];
    return found;
}

/// Of a field of rings (strips) of equal widths over |r| from 0 to `r` [m]: ∫ r dr, of strips ∫ dx,
/// odd.
double integrated(const std::vector<double>& radii, const std::vector<double>& field, double r,
                  bool is_plane) {
    const double width = radii[1] - radii[0], end = std::abs(r);
    double sum = 0;
    for (std::size_t i = 0; i < radii.size(); ++i) {
        const double inner = radii[i] - width / 2, outer = std::min(end, radii[i] + width / 2);
        if (outer > inner)
            sum += field[i] * (is_plane ? outer - inner : (outer * outer - inner * inner) / 2);
    }
    return is_plane && r < 0 ? -sum : sum;
}

/// Mean from low to high [m].
double mean_change(const RingChange& rings, const std::vector<double>& field, double low,
                   double high, bool is_plane) {
    const double area = is_plane ? high - low : (high * high - low * low) / 2;
    if (!(area > 0)) return 0;
    return (integrated(rings.radii, field, high, is_plane) -
            integrated(rings.radii, field, low, is_plane)) /
           area;
}

ReferenceSamples with_change(const UnderstoodMesh& mesh, ReferenceSamples samples,
                             const RingChange& rings) {
    const auto& points = mesh.result.points;
    const bool is_plane = mesh.result.geometry == Geometry::plane;
    for (std::size_t i = 0; i < points.size(); ++i) {
        double low, high;
        if (mesh.result.geometry == Geometry::spatial) {
            const double r = std::hypot(points[i].x, points[i].y),
                         half = std::sqrt(std::max(0., points[i].area)) / 2;
            low = std::max(0., r - half);
            high = r + half;
        } else {
            low = is_plane ? mesh.low[i] : std::max(0., mesh.low[i]);
            high = mesh.high[i];
        }
        samples.values[i].pressure += mean_change(rings, rings.pressure, low, high, is_plane);
        if (!rings.traction.empty())
            samples.values[i].traction_x += mean_change(rings, rings.traction, low, high, is_plane);
    }
    return samples;
}

bool has_ring_effects(const Reference& reference) {
    const contact::Case& c = reference.c;
    if (reference.has_singular_edge || c.tractive_rolling || c.rolling) return false;
    if (c.is_line_contact() != (reference.geometry == Geometry::plane)) return false;
    return has_exact_line_contact(c) ||
           (has_exact_radial_contact(c) && !contact::has_conical_tip(c));
}

bool is_displaced(const ContactMethod& method) {
    return method.kinematics == ContactMethod::Kinematics::displaced ||
           method.kinematics == ContactMethod::Kinematics::finite;
}

/// Strain of area, of a plane contact of length, that pressing leaves at the centre.
double central_strain(const Reference& reference) {
    const contact::NormalControl control = final_normal(reference.c);
    const double r = .1 * reference.contact_radius;
    if (reference.c.is_line_contact())
        return std::abs(PlaneContact(reference.c, control).displacement_along(r) / r);
    return std::abs(2 * RadialContact(reference.c, control).radial_displacement(r) / r);
}

/// Second order of the displaced surface, and what codes differ by in the area that a pressure acts
/// on.
double displaced_pressure_bar(const Reference& reference, double of_area) {
    const double slope = edge_slope(reference);
    return std::max(second_order * slope * slope, of_area);
}

/// What is explained of a resultant, by the envelope theorem.
double envelope_change(const Submission& submission, const Reference& reference,
                       std::initializer_list<const char*> quantities,
                       std::initializer_list<std::string_view> ids) {
    double change = 0;
    for (const char* key : quantities)
        for (const Explained& e : explained(key, submission, reference))
            if (std::ranges::find(ids, e.id) != ids.end()) change += e.change;
    return change;
}

/// By how much rings miss what the envelope theorem makes of the reference's own fields, over it:
/// they leave out coupling, and tractions across the load. 0 where neither changes anything.
double miss_of(double rings, double envelope) {
    constexpr double nothing = 1e-6;
    if (std::abs(envelope) < nothing) return std::abs(rings) < nothing ? 0 : 1;
    return std::abs(rings / envelope - 1);
}

/// Tractions of rings are those of the reference: nothing couples, and none stand across the load.
bool has_exact_shear(const contact::Case& c) {
    if (!is_uncoupled(c)) return false;
    return c.is_line_contact() || (!c.layer.thickness && c.materials().nu_over_g() == 0);
}

/// What stands of penalty and displaced surface; `force`: the rings' change of it.
NamedEffect pressing_effect(const Submission& submission, const Reference& reference,
                            double force) {
    const ContactMethod& method = submission.contact;
    const double miss =
        is_uncoupled(reference.c)
            ? 0
            : miss_of(force, envelope_change(submission, reference,
                                             {keys::normal_force, keys::indentation},
                                             {"penalty", "displaced_surface"}));
    if (!is_displaced(method)) return {"penalty", "normal penalty", miss};
    if (!method.stiffness) return {"displaced_surface", "contact on the displaced surface", miss};
    return {"interface", "normal penalty and displaced surface", miss};
}

}  // namespace

double strain_of_pressed_area(const Submission& submission, const Understanding& all,
                              const Reference& reference) {
    if (!is_displaced(submission.contact) || !has_ring_effects(reference)) return 0;
    const double strain = central_strain(reference);
    const bool set_back = std::ranges::any_of(
        all.conventions, [](const Convention& found) { return found.id == "deformed"; });
    if (set_back) return strain;  // which areas were integrated over is not the code's to tell
    const auto& meshes = all.meshes;
    if (meshes.empty() || !meshes.back().field_force) return strain;
    const auto& totals = meshes.back().result.totals;
    const auto total = totals.find(keys::normal_force);
    if (total == totals.end() || !(total->second > 0)) return strain;
    // Pressures per displaced area add up to a force that is off by about two thirds of the strain.
    const double apart = std::abs(*meshes.back().field_force / total->second - 1);
    return apart < strain / 4 ? std::min(strain, 2 * apart) : strain;
}

std::vector<Explained> explained_pressing(const std::string& key, const Submission& submission,
                                          const Reference& reference, double strain_of_area) {
    if ((key != keys::peak_pressure && key != keys::contact_radius) || !has_ring_effects(reference))
        return {};
    std::vector<Explained> all;
    const ContactMethod& method = submission.contact;
    const auto add = [&](const char* id, const char* title, const InterfaceLaw& law, double bar) {
        const auto fine = change(key, reference, fine_rings, law),
                   coarse = change(key, reference, fine_rings / 2, law);
        if (!fine || !coarse) return;
        const auto rings = ring_change(reference, fine_rings, law);
        const double of_envelope =
            envelope_change(submission, reference, {keys::normal_force, keys::indentation}, {id});
        const double miss = is_uncoupled(reference.c) ? 0 : miss_of(rings->force, of_envelope);
        if (miss > ExplainedField::most_miss) return;
        all.push_back({id, title, *fine, std::hypot(*fine - *coarse, bar, miss * *fine)});
    };
    if (method.stiffness)
        add("penalty", "normal penalty", {.compliance = 1 / *method.stiffness}, 0);
    if (is_displaced(method)) {
        const double slope = edge_slope(reference);
        const double bar = key == keys::peak_pressure
                               ? displaced_pressure_bar(reference, strain_of_area)
                               : second_order * slope * slope;
        add("displaced_surface", "contact on the displaced surface", {.is_displaced = true}, bar);
    }
    return all;
}

std::vector<ExplainedField> explained_fields(const Submission& submission,
                                             const Reference& reference,
                                             const std::vector<UnderstoodMesh>& meshes,
                                             const std::vector<ReferenceSamples>& samples,
                                             double strain_of_area) {
    const ContactMethod& method = submission.contact;
    const bool displaced = is_displaced(method);
    const bool slips =
        method.stick_slope && applied_once(reference) && has_exact_shear(reference.c);
    if ((!method.stiffness && !displaced && !slips) || samples.size() != meshes.size() ||
        samples.empty() || !reference.fields || !has_ring_effects(reference))
        return {};
    const InterfaceLaw law{.compliance = method.stiffness ? 1 / *method.stiffness : 0,
                           .is_displaced = displaced,
                           .tangential_compliance = slips ? 1 / *method.stick_slope : 0};
    const auto fine = ring_change(reference, fine_rings, law),
               coarse = ring_change(reference, fine_rings / 2, law);
    if (!fine || !coarse) return {};
    ExplainedField one;
    if (displaced || method.stiffness) {
        one.of_pressure = pressing_effect(submission, reference, fine->force);
        if (displaced) one.bar = displaced_pressure_bar(reference, strain_of_area);
    }
    if (slips)
        one.of_traction = displaced || method.stiffness
                              ? NamedEffect{"interface", "elastic slip and normal interface", 0}
                              : NamedEffect{"stick_slope", "elastic slip", 0};
    std::vector<ExplainedField> all;
    for (std::size_t k = 0; k < meshes.size(); ++k) {
        one.fine = with_change(meshes[k], samples[k], *fine);
        one.coarse = with_change(meshes[k], samples[k], *coarse);
        all.push_back(one);
    }
    return all;
}

}  // namespace tricontact::benchmarks
