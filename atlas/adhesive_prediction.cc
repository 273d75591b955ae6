#include "atlas/adhesive_prediction.h"

#include <cmath>

#include "comparisons/adhesion/adhesion_forms.h"
#include "comparisons/quantities/left_out.h"
#include "comparisons/quantities/quantities.h"
#include "comparisons/quantities/reference.h"
#include "contact/base/special_values.h"
#include "theory/rolling/rolled_law.h"

namespace tricontact::atlas {

using comparisons::Quantity;
using contact::State;
namespace quantities = comparisons::quantities;

namespace {

/// Of springs that carry a strength over the adhesive contact.
void add_adhesive_friction(const comparisons::Reference& r, bool rolls, Prediction& p) {
    const auto set = [&p](const Quantity& q, double value) {
        if (std::isfinite(value)) p.entries.push_back({&q, {value, 0}});
    };
    const double unit = r.hertz.unit_shift;
    set(quantities::unit_shift, unit);
    set(quantities::tangential_ratio, r.tangential_ratio);
    if (r.static_shift_ratio > 0) {
        set(quantities::static_shift_ratio, r.static_shift_ratio);
        set(quantities::static_shift, r.static_shift_ratio * unit);
    }
    p.rests_on.emplace_back("closed forms of MDR over the adhesive contact");
    if (!rolls) return;
    set(quantities::amplitude_ratio, r.amplitude_ratio);
    set(quantities::amplitude, r.amplitude_ratio * r.hertz.contact_radius);
    if (!r.limit_tangential_ratio) return;
    set(quantities::limit_tangential_ratio, *r.limit_tangential_ratio);
    set(quantities::limit_amplitude_ratio, r.limit_amplitude_ratio.value_or(contact::undefined));
    p.state = r.tangential_ratio < *r.limit_tangential_ratio ? State::shakedown : State::ratcheting;
    if (!r.shakedown_shift_ratio) return;
    set(quantities::settled_shift_ratio, *r.shakedown_shift_ratio);
    set(quantities::settled_shift, *r.shakedown_shift_ratio * unit);
    set(quantities::kappa, theory::strength_rolling.mdr_mapping);
}

}  // namespace

Prediction adhesive_prediction(const contact::Case& c, const std::string& model) {
    const comparisons::AdhesiveForms forms = comparisons::adhesive_forms(c).value();
    Prediction p{.model = model,
                 .left_out = comparisons::left_out(c, model),
                 .limitations = comparisons::adhesion_sentences(c)};
    const auto set = [&p](const Quantity& q, double value) {
        if (std::isfinite(value)) p.entries.push_back({&q, {value, 0}});
    };
    set(quantities::normal_force, forms.normal_force);
    set(quantities::indentation, forms.indentation);
    set(quantities::contact_radius, forms.contact_radius);
    set(quantities::pull_off_force, forms.pull_off.force);
    set(quantities::pull_off_radius, forms.pull_off.radius);
    set(quantities::pull_off_indentation, forms.pull_off.indentation);
    set(quantities::last_indentation, forms.pull_off.last_indentation);
    p.rests_on = {"the half-space by " + forms.theory};
    if (c.friction.is_strength_alone() && !c.is_pressed_only() && !c.prescribed_path)
        add_adhesive_friction(comparisons::reference(c), c.rolling.has_value(), p);
    return p;
}

}  // namespace tricontact::atlas
