#include "comparisons/quantities/reference.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bem/settings.h"
#include "comparisons/adhesion/adhesion_forms.h"
#include "contact/base/special_values.h"
#include "contact/half_space_scales.h"
#include "contact/models/model_kind.h"
#include "contact/section_scales.h"
#include "contact/substrates/normal_tangential.h"
#include "theory/oscillating_cylinder.h"
#include "theory/rolling/body_rolling.h"
#include "theory/rolling/rolled_law.h"

namespace tricontact::comparisons {

using contact::Case;

bool constant_loads(const contact::Case& c) {
    return !c.prescribed_path && c.load.normal_amplitude_ratio == 0 &&
           c.load.tangential_amplitude_ratio == 0;
}

bool in_unit_range(double ratio) {
    return ratio >= 0 && ratio <= 1;
}

double tangential_ratio(const contact::History& history) {
    return history.friction_limit > 0 ? history.tangential_force / history.friction_limit : 0;
}

double tangential_ratio(const contact::Case& c, const contact::FrictionLaw::Total& contact) {
    if (c.load.is_by_limit() || c.prescribed_path) return std::numeric_limits<double>::quiet_NaN();
    return c.load.tangential_ratio
               ? *c.load.tangential_ratio
               : c.load.tangential_force.value_or(0) / c.friction.law()->limit(contact);
}

double amplitude_ratio(const contact::History& history) {
    return history.amplitude / history.scales.contact_radius;
}

namespace {

/// Closed forms of the line contact in place of the point contact's.
void add_line_contact(const contact::Case& c, Reference& r) {
    if (!c.friction.is_coulomb()) return;
    const double f = r.tangential_ratio, w = r.amplitude_ratio;
    const double lambda = contact::line_shift_factor(c);
    r.static_shift_ratio = theory::line_static_shift_ratio(f, lambda);
    if (!c.rolling) r.stick_ratio = theory::line_stick_half_width(0, f);
    if (!c.rolling || !constant_loads(c) || !in_unit_range(w)) return;
    r.limit_tangential_ratio = theory::line_shakedown_limit(w);
    r.limit_amplitude_ratio = theory::line_amplitude_limit(f);
    r.stick_ratio = theory::line_stick_half_width(w, f);
    if (r.stick_ratio)
        r.shakedown_shift_ratio = theory::line_settled_shift_ratio(w, *r.stick_ratio, lambda);
}

void add_point_contact(const contact::Case& c, Reference& r) {
    const double f = r.tangential_ratio, w = r.amplitude_ratio;
    if (!theory::has_body_theory(c)) return;
    const theory::BodyRolling body(c);
    r.static_shift_ratio = body.static_shift_ratio(f);
    if (!c.rolling || !constant_loads(c) || !in_unit_range(w)) return;
    r.limit_tangential_ratio = body.shakedown_limit(w);
    r.limit_amplitude_ratio = body.amplitude_limit(f);
    r.shakedown_shift_ratio = body.bed_settled_shift_ratio(w, f);
}

/// Of surfaces that attract each other. A strength acts wherever they touch: what holds for it asks
/// for the contact's radius alone.
void add_adhesive_contact(const contact::Case& c, Reference& r) {
    const double hertz_radius = r.hertz.contact_radius;
    const auto forms = adhesive_forms(c);
    r.is_nominal = !forms;
    if (!forms) {
        r.hertz.friction_limit = r.hertz.unit_shift = contact::undefined;
    } else {
        r.hertz = {.contact_radius = forms->contact_radius,
                   .indentation = forms->indentation,
                   .normal_force = forms->normal_force,
                   .peak_pressure = contact::undefined,
                   .unit_shift = forms->unit_shift,
                   .half_widths = {forms->contact_radius, forms->contact_radius},
                   .friction_limit = forms->friction_limit};
    }
    r.tangential_ratio = tangential_ratio(c, {r.hertz.normal_force, r.hertz.friction_limit});
    if (c.rolling) {
        const bool of_model = c.rolling->amplitude_reference == Case::AmplitudeReference::model;
        const double radius = r.hertz.contact_radius;
        r.amplitude_ratio =
            contact::rolling_amplitude(*c.rolling, of_model ? radius : hertz_radius) / radius;
    }
    if (!forms || !c.friction.is_strength_alone()) return;
    const theory::RolledLaw& law = theory::strength_rolling;
    const double w = r.amplitude_ratio;
    const bool is_rolled = c.rolling && constant_loads(c) && in_unit_range(w);
    if (is_rolled && c.load.is_by_limit())
        r.tangential_ratio = c.load.ratio_by_limit(law.exact_limit(w));
    if (!in_unit_range(r.tangential_ratio)) return;
    r.static_shift_ratio = law.static_shift(r.tangential_ratio);
    if (!is_rolled) return;
    r.limit_tangential_ratio = law.exact_limit(w);
    r.limit_amplitude_ratio = law.amplitude_limit(r.tangential_ratio, law.mdr_mapping);
    r.shakedown_shift_ratio = law.settled_shift_ratio(w, r.tangential_ratio, law.mdr_mapping);
}

/// f_T of a load that is said by the limit; NaN where theory has none.
double ratio_by_limit(const contact::Case& c, double amplitude_ratio) {
    const std::optional<double> limit =
        !in_unit_range(amplitude_ratio) ? std::nullopt
        : c.is_cylindrical() && c.friction.is_coulomb() && !c.interface.is_elastic()
            ? theory::line_shakedown_limit(amplitude_ratio)
        : theory::has_body_theory(c) ? theory::shakedown_limit(c, amplitude_ratio)
                                     : std::nullopt;
    return c.load.ratio_by_limit(limit.value_or(std::numeric_limits<double>::quiet_NaN()));
}

}  // namespace

Reference reference(const contact::Case& c) {
    Reference r;
    r.hertz = contact::half_space_scales(c);
    r.is_nominal = contact::is_nominally_flat(c) || contact::is_section_alone(c);
    r.static_shift_is_relaxed = static_shift_is_relaxed(c);
    if (const theory::RolledLaw* law = mapped_law(c)) r.mdr_mapping = law->mdr_mapping;
    if (c.adhesion) {
        add_adhesive_contact(c, r);
        return r;
    }
    r.tangential_ratio = tangential_ratio(c, {r.hertz.normal_force, r.hertz.friction_limit});
    if (c.rolling)
        r.amplitude_ratio =
            contact::rolling_amplitude(*c.rolling, r.hertz.contact_radius) / r.hertz.contact_radius;
    if (c.load.is_by_limit()) r.tangential_ratio = ratio_by_limit(c, r.amplitude_ratio);
    if (contact::pressure_falls(c) && !contact::has_conical_tip(c) && !contact::is_section_alone(c))
        r.peak_pressure = r.hertz.peak_pressure;
    if (!in_unit_range(r.tangential_ratio) || c.interface.is_elastic() || c.has_bulk_stress() ||
        contact::is_section_alone(c))
        return r;
    if (c.is_cylindrical())
        add_line_contact(c, r);
    else
        add_point_contact(c, r);
    return r;
}

const theory::RolledLaw* mapped_law(const contact::Case& c) {
    const bool is_round = contact::is_hertz_round(c) && !c.interface.is_elastic();
    return is_round ? theory::rolled_law(c.friction) : nullptr;
}

std::string size_name(const contact::Case& c) {
    return c.is_cylindrical() || c.is_line_contact() ? "half width" : "contact radius";
}

const char* pressure_name(const contact::Case& c) {
    if (contact::has_conical_tip(c)) return "mean pressure";
    return contact::pressure_falls(c) ? "peak pressure" : "pressure at the centre";
}

bool is_half_space(const std::string& model) {
    return contact::model_kind(model).is_half_space();
}

bool half_spaces_couple(const Case& c) {
    return contact::half_spaces_couple(c.materials());
}

bool is_tabulated(const Case& c, const std::string& model) {
    return c.of<bem::Settings>().influence && contact::model_kind(model).reads_influence;
}

bool couples(const Case& c, const std::string& model) {
    const contact::ModelKind& kind = contact::model_kind(model);
    if (!c.contact.coupling || !kind.couples) return false;
    return !kind.is_half_space() || is_tabulated(c, model) || half_spaces_couple(c);
}

bool is_uncoupled_half_space(const Case& c, const std::string& model) {
    return is_half_space(model) && !is_tabulated(c, model) && !couples(c, model);
}

bool static_shift_is_relaxed(const Case& c) {
    constexpr double enough = 7;
    if (!c.relaxation) return true;
    return std::ranges::all_of(c.relaxation->branches, [&](const auto& branch) {
        return c.load.hold >= enough * branch.time;
    });
}

std::string static_theory(const Case& c) {
    if (c.is_cylindrical()) return "Cattaneo";
    if (!c.friction.is_coulomb()) return "springs under this law of friction";
    return contact::is_hertz_round(c) ? "Cattaneo and Mindlin" : "superposed normal contacts";
}

}  // namespace tricontact::comparisons
