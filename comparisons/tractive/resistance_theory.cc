#include "comparisons/tractive/resistance_theory.h"

#include "contact/relaxing_case.h"
#include "theory/foundation_rolling.h"
#include "theory/hunter.h"
#include "theory/slow_rolling.h"

namespace tricontact::comparisons::tractive {

namespace {

using contact::Case;

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

std::vector<ResistanceTheory> resistance_theories(const Case& c) {
    if (!c.relaxation || !is_parabolic(c.indenter.shape)) return {};
    std::vector<ResistanceTheory> theories;
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

}  // namespace tricontact::comparisons::tractive
