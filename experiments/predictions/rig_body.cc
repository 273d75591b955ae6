#include "experiments/predictions/rig_body.h"

#include <cmath>

#include "comparisons/quantities/map_border.h"
#include "contact/base/special_values.h"
#include "contact/models/model_kind.h"
#include "experiments/assumptions/check_rig.h"
#include "experiments/records/experiment_evaluation.h"

namespace tricontact::experiments {

namespace {

using contact::Case;
using contact::History;

statistics::Estimate with_error(double fine, double coarse) {
    return {fine, std::abs(numerical_error(fine, coarse))};
}

AttractedContact attracted_contact(const std::string& model, Case c, double work,
                                   const contact::ModelRunner& runner) {
    AttractedContact found{};
    found.radius_without = runner.history_of(model, c).scales.contact_radius;
    c.adhesion = contact::Adhesion{.work = work};
    const History history = runner.history_of(model, c);
    found.radius = history.scales.contact_radius;
    found.pull_off = history.pull_off.value().force;
    return found;
}

}  // namespace

Case at_rest(Case c, double tangential_ratio) {
    c.rolling.reset();
    c.tractive_rolling.reset();
    c.relaxation.reset();
    c.load.hold = 0;
    c.load.normal_amplitude_ratio = c.load.tangential_amplitude_ratio = 0;
    c.load.set_tangential_ratio(tangential_ratio);
    return c;
}

BodyContact contact_by(const std::string& model, const Case& c,
                       const contact::ModelRunner& runner) {
    const History fine = runner.history_of(model, c), coarse = runner.history_of_coarser(model, c);
    return {with_error(fine.scales.indentation, coarse.scales.indentation),
            with_error(fine.scales.contact_radius, coarse.scales.contact_radius),
            contact::has_conical_tip(c)
                ? statistics::Estimate{contact::undefined}
                : with_error(fine.scales.peak_pressure, coarse.scales.peak_pressure),
            with_error(fine.static_shift, coarse.static_shift),
            comparisons::border_force_share(c, fine).value_or(0)};
}

BodyContacts body_contacts(const Case& c, const contact::ModelRunner& runner) {
    Case still = at_rest(c, coupling_tangential_ratio);
    Case uncoupled = still;
    uncoupled.contact.coupling = false;
    still.contact.coupling = true;
    return {contact_by(contact::models::bem, uncoupled, runner),
            contact_by(contact::models::bem_layer, uncoupled, runner),
            contact_by(contact::models::bem_layer, still, runner).static_shift};
}

AttractedContacts attracted_contacts(const Case& c, double work,
                                     const contact::ModelRunner& runner) {
    const Case still = at_rest(c, 0);
    AttractedContacts found{};
    try {
        found.half_space = attracted_contact(contact::models::mdr, still, work, runner);
        found.layer = attracted_contact(contact::models::mdr_layer, still, work, runner);
    } catch (const contact::InputError& error) {
        found.why_none = error.what();
    } catch (const contact::NotConverged& error) {
        found.why_none = error.what();
    }
    return found;
}

Rig rig_with_body(const io::RigFile& file, const contact::ModelRunner& runner) {
    Rig rig = rolling_rig(file);
    if (rig.kind == Rig::Kind::body) rig.body = body_contacts(file.c, runner);
    const bool has_forms = rig.kind != Rig::Kind::body && !has_soft_indenter(rig);
    if (!has_forms && rig.kind != Rig::Kind::cylinder && rig.Dgamma.is_known())
        rig.attracted = attracted_contacts(file.c, rig.Dgamma, runner);
    return rig;
}

}  // namespace tricontact::experiments
