#include "comparisons/adhesion/adhesion_forms.h"

#include <cmath>
#include <memory>
#include <numbers>

#include "contact/attraction/adhesive_edge.h"
#include "contact/base/special_values.h"
#include "contact/bodies/body_shapes.h"
#include "contact/half_space_scales.h"
#include "contact/load_path.h"
#include "report/format.h"
#include "theory/adhesion.h"
#include "theory/adhesive/adhesive_hysteresis.h"
#include "theory/adhesive/maugis_dugdale.h"

namespace tricontact::comparisons {

namespace {

using contact::Adhesion;
using contact::Case;
using contact::NormalControl;
using std::numbers::pi;

bool is_on_a_half_space(const Case& c) {
    return !c.layer.thickness && !c.has_hole() && !c.period && !c.indenter.body &&
           !c.indenter.roughness;
}

bool is_of_revolution(const Case& c) {
    return !c.is_cylindrical() && !contact::is_nominally_flat(c) &&
           c.indenter.shape != Case::Shape::ellipsoid &&
           c.indenter.shape != Case::Shape::flat_punch && !c.indenter.is_long_punch();
}

AdhesiveForms short_ranged_forms(const Case& c) {
    const auto body = c.make_axisymmetric_indenter();
    const double modulus = c.materials().effective_modulus(), work = c.adhesion->work;
    theory::AdhesiveHysteresis curve(theory::half_space_contacts(*body, modulus), modulus, work,
                                     c.adhesion->approach_work.value_or(work), work / modulus,
                                     body->outer_radius() * (1 - 1e-6));
    const auto pressed = curve.follow({}, contact::press_step(c).normal).state;
    return {.contact_radius = pressed.radius,
            .indentation = pressed.indentation,
            .normal_force = pressed.force,
            .pull_off = curve.pull_off(pressed.radius),
            .theory = "Johnson, Kendall and Roberts"};
}

theory::MaugisUnits maugis_units(const Case& c) {
    return theory::maugis_units(c.indenter.radius, c.adhesion->work,
                                c.materials().effective_modulus());
}

double maugis_lambda(const Case& c) {
    return theory::maugis_parameter(c.indenter.radius, c.adhesion->work,
                                    c.materials().effective_modulus(), c.adhesion->strength());
}

AdhesiveForms maugis_forms(const Case& c) {
    const auto unit = maugis_units(c);
    const double lambda = maugis_lambda(c);
    const theory::MaugisContact off = theory::maugis_pull_off(lambda);
    const NormalControl press = contact::press_step(c).normal;
    const theory::MaugisContact pressed =
        press.kind == NormalControl::Kind::force
            ? theory::maugis_contact_under(lambda, press.value / unit.force)
            : theory::maugis_contact_at(lambda, press.value / unit.indentation);
    return {.contact_radius = pressed.radius * unit.radius,
            .indentation = pressed.indentation * unit.indentation,
            .normal_force = pressed.force * unit.force,
            .pull_off = {.force = -off.force * unit.force,
                         .radius = off.radius * unit.radius,
                         .indentation = off.indentation * unit.indentation,
                         .last_indentation = std::numeric_limits<double>::quiet_NaN()},
            .theory = "Maugis"};
}

const char* regime_of(double tabor) {
    return tabor > 5    ? "short-ranged, as Johnson, Kendall and Roberts have it"
           : tabor < .1 ? "long-ranged, as Derjaguin, Muller and Toporov have it"
                        : "between the theories, Maugis' transition";
}

}  // namespace

std::optional<AdhesiveForms> adhesive_forms(const Case& c) {
    if (!c.adhesion || !is_on_a_half_space(c) || !is_of_revolution(c) || c.has_rigid_substrate)
        return {};
    const bool is_short = c.adhesion->is_short_ranged();
    if (!is_short && (!contact::is_hertz_round(c) || c.adhesion->law != Adhesion::Law::dugdale))
        return {};
    AdhesiveForms forms = is_short ? short_ranged_forms(c) : maugis_forms(c);
    forms.friction_limit = forms.unit_shift = contact::undefined;
    if (c.friction.is_strength_alone()) {
        const double a = forms.contact_radius, strength = *c.friction.shear_strength;
        forms.friction_limit = pi * a * a * strength;
        forms.unit_shift = 2 * strength * a / c.materials().effective_shear_modulus();
    }
    return forms;
}

std::vector<AdhesiveEquilibria> adhesive_equilibria(const Case& c) {
    const auto forms = adhesive_forms(c);
    if (!forms) return {};
    const std::shared_ptr body = c.make_axisymmetric_indenter();
    const auto short_ranged = [&](const std::string& branch, double work) {
        const auto curve = std::make_shared<const theory::AdhesiveCurve>(
            theory::half_space_curve(*body, c.materials().effective_modulus(), work));
        return AdhesiveEquilibria{"Johnson, Kendall and Roberts" + branch, [body, curve](double a) {
                                      const auto s = curve->at(a);
                                      return contact::Vector2{s.indentation, s.force};
                                  }};
    };
    const double work = c.adhesion->work;
    if (!c.adhesion->is_reversible()) {
        std::vector<AdhesiveEquilibria> all{short_ranged(", separation", work)};
        if (*c.adhesion->approach_work > 0)
            all.push_back(short_ranged(", approach", *c.adhesion->approach_work));
        return all;
    }
    const AdhesiveEquilibria no_range = short_ranged("", work);
    if (c.adhesion->is_short_ranged()) return {no_range};
    const auto unit = maugis_units(c);
    const AdhesiveEquilibria maugis{
        forms->theory, [unit, lambda = maugis_lambda(c)](double a) {
            const auto s = theory::maugis_contact(lambda, a / unit.radius);
            return contact::Vector2{s.indentation * unit.indentation, s.force * unit.force};
        }};
    // Hertz' contact under 2 pi w R more.
    const AdhesiveEquilibria stiff{
        "Derjaguin, Muller and Toporov", [unit, r = c.indenter.radius](double a) {
            const double reduced = a / unit.radius;
            return contact::Vector2{a * a / r, unit.force * (std::pow(reduced, 3) - 2)};
        }};
    return {maugis, no_range, stiff};
}

std::optional<double> tabor_parameter(const Case& c) {
    if (!c.adhesion || !contact::is_hertz_round(c)) return {};
    if (c.adhesion->is_short_ranged()) return contact::infinity;
    return theory::tabor_parameter(c.indenter.radius, c.adhesion->work,
                                   c.materials().effective_modulus(), c.adhesion->distance());
}

std::vector<report::DerivedValue> adhesive_values(const Case& c) {
    std::vector<report::DerivedValue> all;
    if (!c.adhesion) return all;
    const auto tabor = tabor_parameter(c);
    if (tabor && std::isfinite(*tabor))
        all.push_back({"mu_T", *tabor, "1", "Tabor's parameter of the attraction"});
    const auto forms = adhesive_forms(c);
    if (!forms) return all;
    const std::string by = " by " + forms->theory;
    all.push_back({"a_adh", forms->contact_radius, "m", "contact radius under attraction" + by});
    all.push_back({"d_adh", forms->indentation, "m", "indentation under attraction" + by});
    all.push_back({"F_adh", forms->normal_force, "N", "normal force under attraction" + by});
    all.push_back({"F_off", forms->pull_off.force, "N", "pull-off force" + by});
    all.push_back({"a_off", forms->pull_off.radius, "m", "contact radius at pull-off" + by});
    if (!c.friction.is_strength_alone()) return all;
    all.push_back(
        {"F_lim", forms->friction_limit, "N", "what friction carries over the adhesive contact"});
    all.push_back({"U_adh", forms->unit_shift, "m", "shift at the onset of sliding there"});
    return all;
}

std::vector<std::string> adhesion_sentences(const Case& c) {
    if (!c.adhesion) return {};
    if (c.adhesion->is_short_ranged()) {
        std::vector<std::string> of_edge{
            "Adhesion has no range: the edge of the contact lets go as a crack grows (Johnson, "
            "Kendall and Roberts)."};
        if (c.of<contact::AdhesiveEdge>().is_by_cell())
            of_edge.emplace_back(
                "In bem cells let go one by one (Pohrt and Popov 2015): rows of them hold the "
                "edge, "
                "so that pull-off takes about 1.4 over the cells in its radius more.");
        if (!c.adhesion->is_reversible())
            of_edge.push_back("Separation takes " + report::quantity(c.adhesion->work, "J/m^2") +
                              " and the approach gains " +
                              report::quantity(*c.adhesion->approach_work, "J/m^2") +
                              ": in between the edge of the contact stays in its place.");
        return of_edge;
    }
    const double strength = c.adhesion->strength();
    // Dugdale's crack under K^2 = 2 E* w: pi/8 (K/sigma_0)^2.
    const double zone =
        pi / 4 * c.materials().effective_modulus() * c.adhesion->work / (strength * strength);
    std::vector<std::string> sentences;
    if (const auto tabor = tabor_parameter(c))
        sentences.push_back("Tabor's parameter is " + report::significant(*tabor, 3) +
                            ": the attraction is " + regime_of(*tabor) + ".");
    sentences.push_back("Beside the edge of the contact it acts over a ring of about " +
                        report::quantity(zone, "m") +
                        " at most, which takes four cells or elements to be resolved.");
    return sentences;
}

}  // namespace tricontact::comparisons
