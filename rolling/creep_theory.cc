#include "rolling/creep_theory.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "comparisons/quantities/reference.h"
#include "contact/models/model_kind.h"
#include "contact/relaxing_case.h"
#include "rolling/rolling_report.h"
#include "theory/creep_law.h"
#include "theory/rolling/kalker.h"
#include "theory/rolling/relaxing_rolling.h"

namespace tricontact::rolling {

namespace {

using contact::Case;

/// Kalker's table ends there.
constexpr double longest_axes_ratio = 10;

/// Of the theory for positive creepages: driven instead of braked is its mirror image.
CreepTheory of_both_signs(CreepTheory braked) {
    const auto odd = [](const auto& of_positive) {
        return [of_positive](double x) { return std::copysign(of_positive(std::abs(x)), x); };
    };
    return {std::move(braked.name), std::move(braked.key), odd(braked.force_ratio),
            odd(braked.creepage)};
}

CreepTheory cubic(std::string name, std::string key, double sliding) {
    return of_both_signs(
        {std::move(name), std::move(key),
         [=](double creepage) { return theory::cubic_force_ratio(creepage / sliding); },
         [=](double f) { return sliding * theory::cubic_creepage_ratio(f); }});
}

/// Without slip: a straight line up to sliding.
CreepTheory linear(std::string name, std::string key, double sliding) {
    return of_both_signs({std::move(name), std::move(key),
                          [=](double creepage) { return std::min(1., 3 * creepage / sliding); },
                          [=](double f) { return sliding * f / 3; }});
}

CreepTheory carter(double unit) {
    return of_both_signs(
        {"Carter", "carter",
         [=](double creepage) { return theory::carter_force_ratio(creepage / unit); },
         [=](double f) { return unit * theory::carter_creepage_ratio(f); }});
}

bool is_strength(const contact::Friction& friction) {
    return friction.shear_strength && !friction.coefficient;
}

CreepTheory carter_strength(const Case& c) {
    const double unit =
        4 / std::numbers::pi * *c.friction.shear_strength / c.materials().effective_modulus();
    return of_both_signs(
        {"Carter's problem, shear strength", "carter_strength",
         [=](double creepage) { return theory::strength_force_ratio(creepage / unit); },
         [=](double f) { return unit * theory::strength_creepage_ratio(f); }});
}

CreepTheory bed_strength(const Case& c) {
    const double unit = 2 * *c.friction.shear_strength / c.materials().effective_shear_modulus();
    return of_both_signs(
        {"MDR, closed form", "mdr_closed_form",
         [=](double creepage) { return theory::strength_bed_force_ratio(creepage / unit); },
         [=](double f) { return unit * theory::strength_bed_creepage_ratio(f); }});
}

bool rolls_freely(const Case& c) {
    return !c.load.is_tangential() && !c.tractive_rolling->longitudinal_creepage;
}

/// A parabola along x.
bool is_parabolic(Case::Shape shape) {
    return shape == Case::Shape::paraboloid || shape == Case::Shape::sphere ||
           shape == Case::Shape::ellipsoid || shape == Case::Shape::cylinder ||
           shape == Case::Shape::roller;
}

double hunter_ratio(const Case& c) {
    const auto& [ratio, time] = c.relaxation->branches.front();
    const double force = contact::half_space_scales(c).normal_force / c.indenter.length;
    const theory::HunterRolling rolling{c.materials().effective_modulus(), c.indenter.radius, ratio,
                                        c.tractive_rolling->speed * time};
    return theory::hunter_contact(rolling, force).lead / c.indenter.radius;
}

double mdr_ratio(const Case& c) {
    const theory::FoundationRolling bed =
        theory::mdr_foundation(*c.relaxation, c.tractive_rolling->speed,
                               c.materials().effective_modulus(), c.indenter.radius);
    const double force = contact::half_space_scales(c).normal_force;
    return theory::foundation_contact_under(bed, force).lead / bed.radius;
}

}  // namespace

double creepage_unit(const Case& c) {
    const contact::HalfSpaceScales scales = contact::half_space_scales(c);
    const double slope = c.is_line_contact() ? scales.contact_radius / c.indenter.radius
                                             : scales.indentation / scales.contact_radius;
    return c.friction.law()->ratio({scales.normal_force, scales.friction_limit}) * slope;
}

std::vector<CreepTheory> creep_theories(const Case& c) {
    if (c.relaxation || c.interface.is_elastic() || friction_changes(c) ||
        !free_creepages(c).empty())
        return {};
    const bool coulomb = c.friction.is_coulomb();
    if (c.is_line_contact())
        return coulomb                   ? std::vector{carter(creepage_unit(c))}
               : is_strength(c.friction) ? std::vector{carter_strength(c)}
                                         : std::vector<CreepTheory>{};
    const bool ellipse = c.indenter.shape == Case::Shape::ellipsoid;
    if (!contact::is_hertz_round(c) && !ellipse) return {};
    const theory::CombinedMaterial material = theory::combined_material(c.materials());
    const contact::HalfSpaceScales scales = contact::half_space_scales(c);
    const auto [a, b] = scales.half_widths;
    const auto sliding = [&](double coefficient) {
        return theory::sliding_creepage(scales.friction_limit, material.shear_modulus, a * b,
                                        coefficient);
    };
    std::vector<CreepTheory> theories;
    if (!ellipse && is_strength(c.friction)) theories.push_back(bed_strength(c));
    if (!ellipse && coulomb) {
        theories.push_back(cubic("Vermeulen and Johnson", "vermeulen_johnson",
                                 sliding(theory::vermeulen_johnson_coefficient(material.poisson))));
        theories.push_back(cubic("MDR, closed form", "mdr_closed_form",
                                 sliding(theory::mdr_coefficient(material.poisson))));
    }
    if (material.poisson < 0 || std::max(a / b, b / a) > longest_axes_ratio) return theories;
    const double kalker =
        sliding(theory::kalker_coefficients(a / b, material.poisson).longitudinal);
    theories.push_back(linear("Kalker, linear", "kalker_linear", kalker));
    if (coulomb) theories.push_back(cubic("cubic law with Kalker's C_11", "cubic_kalker", kalker));
    return theories;
}

bool has_thesis_creep_ratio(const Case& c) {
    return contact::is_coulomb_round(c) && straight(c) && !c.relaxation &&
           !comparisons::couples(c, contact::models::bem);
}

double thesis_creep_ratio(const Case& c) {
    const double nu = theory::combined_material(c.materials()).poisson;
    return theory::vermeulen_johnson_coefficient(nu) / theory::mdr_coefficient(nu);
}

std::vector<ClosedForm> free_creepages(const Case& c) {
    const double beta = c.materials().dundurs_beta();
    if (!c.is_line_contact() || !rolls_freely(c) ||
        !comparisons::couples(c, contact::models::bem) || c.relaxation || c.interface.is_elastic())
        return {};
    const double slope = contact::half_space_scales(c).contact_radius / c.indenter.radius;
    return {{"Bentall and Johnson, all sticks", "bentall_johnson_rough",
             slope * theory::rough_free_creepage(beta)},
            {"Bentall and Johnson, all slips", "bentall_johnson_smooth",
             slope * theory::smooth_free_creepage(beta)}};
}

std::vector<ClosedForm> resistance_theories(const Case& c) {
    if (!c.relaxation || c.interface.is_elastic() || !is_parabolic(c.indenter.shape)) return {};
    std::vector<ClosedForm> theories;
    if (contact::relaxes_as_one(c))
        theories.push_back({"slow rolling", "slow",
                            theory::slow_resistance_ratio(*c.relaxation, c.tractive_rolling->speed,
                                                          c.indenter.radius)});
    if (!contact::relaxes_as_one(contact::without_layer(c))) return theories;
    if (c.is_line_contact() && c.relaxation->branches.size() == 1)
        theories.push_back({"Hunter", "hunter", hunter_ratio(c)});
    if (contact::is_hertz_round(c))
        theories.push_back({"MDR, closed form", "mdr_closed_form", mdr_ratio(c)});
    return theories;
}

}  // namespace tricontact::rolling
