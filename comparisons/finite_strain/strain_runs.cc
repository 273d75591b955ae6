#include "comparisons/finite_strain/strain_runs.h"

#include <algorithm>
#include <set>

#include "bem/settings.h"
#include "comparisons/half_space/half_space_deviation.h"
#include "contact/base/error.h"
#include "contact/cells.h"
#include "contact/models/model_kind.h"
#include "fem/settings.h"
#include "io/results/output.h"
#include "mdr/settings.h"

namespace tricontact::comparisons {

namespace {

using contact::Case;

constexpr std::array<double, 7> force_factors{.125, .25, .5, 1, 2, 4, 8};
constexpr std::array<double, 5> rolled_force_factors{.25, .5, 1, 2, 4};
constexpr std::array<double, 4> thickness_factors{.25, .5, 1, 2};
constexpr std::array<double, 6> tangential_ratios{.15, .3, .45, .6, .75, .9};
constexpr int periods_at_most = 60;
constexpr double elements_in_thickness = 3;  // at least
constexpr double growth = 3;                 // of elements outwards: both laws have the same mesh
constexpr int press_steps = 10;

void require_finite_strains(const Case& c) {
    c.require_coulomb("a deviation");
    c.refuse_extras("finite strains", {Case::Extra::bulk_stress, Case::Extra::relaxing_indenter});
    if (!contact::is_hertz_round(c))
        throw contact::InputError(
            "indenter.shape: at finite strains fem computes smooth paraboloids and spheres; take "
            "one "
            "of them");
    if (!c.contact.coupling)
        throw contact::InputError(
            "contact.coupling: at finite strains normal and tangential contact are always coupled; "
            "set it to true");
}

}  // namespace

Case::Law StrainContact::law() const {
    return c.law == Case::Law::linear ? Case::Law::neo_hookean : c.law;
}

double StrainContact::contact_radius(double normal_force, double thickness) const {
    const auto base = c.layer.base == Case::Base::frictionless ? theory::LayerBase::frictionless
                                                               : theory::LayerBase::bonded;
    return theory::solve_layer_contact(
               contact.layer(thickness / contact.hertz_diameter, c.substrate.poisson, base),
               *contact.indenter, {contact::NormalControl::Kind::force, normal_force})
        .contact_radius;
}

StrainContact strain_contact(const Case& c, double elements) {
    require_finite_strains(c);
    StrainContact result{.c = c, .contact = deviation_contact(c), .elements = elements};
    // Such a base holds no tangential force.
    if (c.layer.base == Case::Base::frictionless) result.contact.tangential_ratio = 0;
    const double f = result.contact.tangential_ratio, w = result.contact.amplitude_ratio;
    if (f > 0 && w > 0) result.amplitude = rolled_amplitudes(w, f).settling;
    return result;
}

bool is_rolled(const Quantity* q) {
    return q == &quantities::settled_shift || q == &quantities::shift_of_rolling;
}

StrainPoint own_point(const StrainContact& contact, bool rolled) {
    return {.normal_force = contact.contact.normal_force,
            .thickness = *contact.c.layer.thickness,
            .tangential_ratio = contact.contact.tangential_ratio,
            .rolled = rolled};
}

std::vector<StrainPoint> strain_points(const StrainContact& contact) {
    const StrainPoint own = own_point(contact, false);
    std::vector<StrainPoint> points;
    const auto add = [&](StrainPoint point, double force, double thickness) {
        point.normal_force *= force;
        point.thickness *= thickness;
        points.push_back(point);
    };
    for (const double thickness : thickness_factors)
        for (const double force : force_factors) add(own, force, thickness);
    if (own.tangential_ratio > 0)
        for (const double f : tangential_ratios)
            if (f != own.tangential_ratio)
                points.push_back({own.normal_force, own.thickness, f, false, 0});
    const auto add_finer = [&](const StrainPoint& point) {
        points.push_back(point);
        points.back().level = 1;
    };
    add_finer(own);
    if (contact.amplitude == 0) return points;
    const StrainPoint rolled = own_point(contact, true);
    for (const double force : rolled_force_factors) add(rolled, force, 1);
    add_finer(rolled);
    return points;
}

Case strain_case(const StrainContact& contact, const StrainPoint& point, bool finite) {
    const double radius = contact.contact_radius(point.normal_force, point.thickness);
    Case c = contact.c;
    c.models = {contact::models::fem};
    c.law = finite ? contact.law() : Case::Law::linear;
    if (!finite) c.c01_ratio.reset();
    c.layer.thickness = point.thickness;
    c.load.normal_force = point.normal_force;
    c.load.press_steps = press_steps << point.level;
    c.load.indentation.reset();
    c.load.tangential_force.reset();
    c.load.tangential_ratio.reset();
    if (point.tangential_ratio > 0) c.load.tangential_ratio = point.tangential_ratio;
    c.period.reset();
    c.of<contact::Cells>() = {.per_radius = contact.elements};
    c.kept.reset<bem::Settings>();
    c.kept.reset<mdr::Settings>();
    c.kept.reset<io::Output>();
    fem::Settings fem;
    fem.size = std::min(radius / contact.elements, point.thickness / elements_in_thickness);
    fem.growth = growth;
    fem.sides = c.of<fem::Settings>().sides;
    fem.tolerance = c.of<fem::Settings>().tolerance;
    fem.cache = "none";  // no layer is needed twice
    c.of<fem::Settings>() = fem;
    c.rolling.reset();
    if (!point.rolled) return c;
    Case::Rolling rolling;
    rolling.amplitude = contact.amplitude * radius;
    rolling.angle = contact.c.rolling->angle;
    rolling.periods = periods_at_most;
    rolling.steps = Case::Steps::turning_points;
    rolling.until = Case::Until::settled;
    c.rolling = rolling;
    return c;
}

std::optional<double> StrainPair::deviation(const Quantity* q) const {
    const double *a = found(linear, q), *b = found(finite, q);
    return a && b && *b != 0 ? std::optional(*a / *b - 1) : std::nullopt;
}

ByQuantity<double> strain_values(const std::optional<Results>& results) {
    ByQuantity<double> values;
    if (!results) return values;
    for (const Quantity* q : strain_quantities)
        if (const auto value = results->told(*q)) values[q] = *value;
    const double *settled = found(values, &quantities::settled_shift),
                 *pressed = found(values, &quantities::static_shift);
    if (settled && pressed) values[&quantities::shift_of_rolling] = *settled - *pressed;
    return values;
}

}  // namespace tricontact::comparisons
