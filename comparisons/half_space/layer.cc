#include "comparisons/half_space/layer.h"

#include <cmath>
#include <numbers>

#include "bem/settings.h"
#include "comparisons/quantities/reference.h"
#include "contact/base/stopped.h"
#include "contact/half_space_scales.h"
#include "contact/load_path.h"
#include "contact/section_scales.h"
#include "theory/hertz.h"

namespace tricontact::comparisons {

namespace {

using contact::Case;
using contact::History;
using contact::NormalControl;

/// Compliance of the indenter over the substrate's up to which it counts as rigid.
constexpr double negligible_compliance = 1e-3;

theory::LayerContact solve(const Case& c) {
    return theory::solve_layer_contact(elastic_layer(c), *c.make_axisymmetric_indenter(),
                                       contact::press_step(c).normal);
}

PressedValues exact_values(const Case& c) {
    if (c.is_line_contact()) {
        const theory::LineContact line = exact_line_contact(c).value();
        const double length = c.indenter.length;  // the shift of full sliding is left out
        return {
            line.half_width,        line.indentation, line.load * length, line.centre_pressure, {},
            line.stiffness * length};
    }
    const theory::LayerContact exact = solve(c);
    std::optional<double> shift = exact.unit_shift;
    if (!c.friction.is_coulomb()) shift.reset();
    if (shift) *shift *= c.friction_coefficient();
    return {
        exact.contact_radius,  exact.indentation, exact.normal_force, exact.centre_pressure, shift,
        exact.normal_stiffness};
}

void add_exact(const Case& c, LayerComparison& result) {
    result.why_not = why_no_exact_theory(c);
    if (!result.why_not.empty()) return;
    // Out of the theory's range, or not converged.
    result.why_not = contact::why_it_stopped([&] { result.exact = exact_values(c); });
}

ApparentModuli apparent_moduli(const Case& c, const PressedValues& layer) {
    const contact::MaterialPair pair = c.materials();
    const double force = layer.normal_force, radius = c.indenter.radius;
    // All moduli in proportion: E_app/E = E*_app/E*.
    const auto young = [&](double effective_modulus) {
        return c.substrate.young * effective_modulus / pair.effective_modulus();
    };
    const auto from_indentation = [&](double d) {
        return young(theory::hertz_modulus_from_indentation(force, radius, d));
    };
    ApparentModuli result{
        from_indentation(layer.indentation),
        young(theory::hertz_modulus_from_contact_radius(force, radius, layer.contact_radius)),
        {}};
    if (layer.unit_shift && c.friction.is_coulomb())
        result.from_unit_shift =
            from_indentation(*layer.unit_shift * pair.effective_shear_modulus() /
                             (c.friction_coefficient() * pair.effective_modulus()));
    return result;
}

/// dF_N/dd [N/m] at the contact radius or half width a [m]: 2 E* a, of a cylinder
/// pi E* L/(2 ln(2 L/a)).
double half_space_stiffness(const Case& c, double a) {
    const double modulus = c.materials().effective_modulus(), length = c.indenter.length;
    return c.is_line_contact()
               ? std::numbers::pi * modulus * length / (2 * std::log(2 * length / a))
               : 2 * modulus * a;
}

template <class Scales>
PressedValues pressed_values(const Scales& s, std::optional<double> stiffness) {
    return {s.contact_radius, s.indentation, s.normal_force,
            s.peak_pressure,  s.unit_shift,  stiffness};
}

PressedValues values_of(const Case& c, const History& history, const LoadingStudy& study) {
    const contact::Scales& s = history.scales;
    if (is_half_space(history.model))
        return pressed_values(s, half_space_stiffness(c, s.contact_radius));
    const auto found = study.normal_stiffness.find(history.model);
    return pressed_values(
        s, found != study.normal_stiffness.end() ? std::optional(found->second) : std::nullopt);
}

}  // namespace

theory::ElasticLayer elastic_layer(const Case& c) {
    return {c.substrate, *c.layer.thickness,
            c.layer.base == Case::Base::bonded ? theory::LayerBase::bonded
                                               : theory::LayerBase::frictionless};
}

std::string why_no_exact_theory(const Case& c) {
    if (c.indenter.shape == Case::Shape::ellipsoid)
        return "the exact theory covers bodies of revolution, the indenter is an ellipsoid";
    if (c.indenter.roughness || contact::is_nominally_flat(c))
        return "the exact theory covers smooth bodies, the indenter is rough";
    if (contact::is_section_alone(c))
        return "the exact theory covers bodies of revolution with a smooth edge, and cylinders";
    if (!c.layer.lower.empty()) return "the exact theory covers one layer, the case has more";
    if (c.layer.base == Case::Base::half_space)
        return "the exact theory covers a rigid ground, that of the case is elastic";
    if (c.adhesion)
        return "the exact theory has surfaces that do not attract each other, those of the case do";
    if (c.interface.is_elastic())
        return "the exact theory takes the interface as rigid, that of the case has springs";
    if (c.period) return "the exact theory covers one indenter, the case has one in each period";
    if (c.of<bem::Settings>().influence)
        return "the influence coefficients of the case come from a file";
    if (c.indenter.material && c.indenter.material->plane_compliance() >
                                   negligible_compliance * c.substrate.plane_compliance())
        return "the exact theory takes the indenter as rigid, that of the case is not";
    return {};
}

const std::vector<PressedQuantity>& pressed_quantities() {
    using Values = const PressedValues&;
    using Value = std::optional<double>;
    static const std::vector<PressedQuantity> pressed{
        {&quantities::contact_radius, [](Values v) -> Value { return v.contact_radius; }},
        {&quantities::indentation, [](Values v) -> Value { return v.indentation; }},
        {&quantities::normal_force, [](Values v) -> Value { return v.normal_force; }},
        {&quantities::peak_pressure, [](Values v) -> Value { return v.peak_pressure; }},
        {&quantities::unit_shift, [](Values v) { return v.unit_shift; }},
        {&quantities::normal_stiffness, [](Values v) { return v.normal_stiffness; }}};
    return pressed;
}

PressedValues hertz_values(const Case& c) {
    const contact::HalfSpaceScales h = contact::half_space_scales(c);
    return pressed_values(h, half_space_stiffness(c, h.contact_radius));
}

std::optional<theory::LayerContact> exact_layer_contact(const Case& c) {
    if (!c.layer.thickness || !why_no_exact_theory(c).empty()) return {};
    std::optional<theory::LayerContact> exact;  // empty: out of the theory's range, not converged
    contact::why_it_stopped([&] { exact = solve(c); });
    return exact;
}

std::optional<LayerComparison> compare_with_layer(const Case& c,
                                                  const std::vector<History>& histories,
                                                  const LoadingStudy& study) {
    if (!c.layer.thickness) return {};
    LayerComparison result;
    result.thickness = *c.layer.thickness;
    result.half_space = hertz_values(c);
    result.thickness_ratio = result.thickness / (2 * result.half_space.contact_radius);
    add_exact(c, result);
    if (result.exact && contact::is_hertz_round(c))
        result.apparent = apparent_moduli(c, *result.exact);
    for (const History& history : histories)
        result.models.push_back({history.model, values_of(c, history, study)});
    const double total = c.layer.total_thickness();
    if (c.layer.width) result.half_width = *c.layer.width / 2 / total;
    if (c.layer.depth) result.half_depth = *c.layer.depth / 2 / total;
    return result;
}

std::optional<theory::LineContact> exact_line_contact(const Case& c) {
    if (!c.layer.thickness || !why_no_exact_theory(c).empty()) return {};
    using Kind = theory::LineControl::Kind;
    const theory::LineControl control =
        c.load.normal_force
            ? theory::LineControl{Kind::load, *c.load.normal_force / c.indenter.length}
            : theory::LineControl{Kind::indentation, *c.load.indentation};
    return theory::solve_line_contact(elastic_layer(c), c.indenter.radius, control);
}

}  // namespace tricontact::comparisons
