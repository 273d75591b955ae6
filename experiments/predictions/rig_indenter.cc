#include "experiments/predictions/rig_indenter.h"

#include <cmath>

#include "contact/base/special_values.h"
#include "contact/models/model_kind.h"
#include "experiments/records/experiment_evaluation.h"

namespace tricontact::experiments {

namespace {

using contact::Case;
using contact::History;

statistics::Estimate beside_coarser(double fine, double coarse) {
    return {fine, std::abs(numerical_error(fine, coarse))};
}

BodyContact pressed_by(const std::string& model, const Case& c,
                       const contact::ModelRunner& runner) {
    const History fine = runner.history_of(model, c), coarse = runner.history_of_coarser(model, c);
    return {beside_coarser(fine.scales.indentation, coarse.scales.indentation),
            beside_coarser(fine.scales.contact_radius, coarse.scales.contact_radius),
            beside_coarser(fine.scales.peak_pressure, coarse.scales.peak_pressure),
            {contact::undefined}};
}

}  // namespace

const char* model_of_indenter(const Rig& rig) {
    return rig.kind == Rig::Kind::cylinder ? contact::models::fem_plane
                                           : contact::models::fem_axisymmetric;
}

IndenterContacts indenter_contacts(const Rig& rig, const contact::ModelRunner& runner) {
    Case c = rig.c;
    c.rolling.reset();
    c.tractive_rolling.reset();
    c.relaxation.reset();
    c.load.hold = 0;
    c.load.normal_amplitude_ratio = c.load.tangential_amplitude_ratio = 0;
    c.load.set_tangential_ratio(0);
    c.load.press = Case::Press::frictionless;
    c.contact.coupling = false;
    c.layer.width.reset();
    c.layer.depth.reset();
    IndenterContacts contacts{pressed_by(model_of_indenter(rig), c, runner),
                              pressed_by(contact::models::bem_layer, c, runner)};
    // In plane strain a half-space has no depth of its own.
    if (rig.kind == Rig::Kind::cylinder)
        contacts.body.indentation = contacts.half_space.indentation = {contact::undefined};
    return contacts;
}

}  // namespace tricontact::experiments
