#include "experiments/predictions/rig_indenter.h"

#include "contact/base/special_values.h"
#include "contact/models/model_kind.h"
#include "experiments/predictions/rig_body.h"

namespace tricontact::experiments {

namespace {

using contact::Case;

/// Nothing is pulled: there is no static shift.
BodyContact pressed_by(const std::string& model, const Case& c,
                       const contact::ModelRunner& runner) {
    BodyContact found = contact_by(model, c, runner);
    found.static_shift = {contact::undefined};
    return found;
}

}  // namespace

const char* model_of_indenter(const Rig& rig) {
    return rig.kind == Rig::Kind::cylinder ? contact::models::fem_plane
                                           : contact::models::fem_axisymmetric;
}

IndenterContacts indenter_contacts(const Rig& rig, const contact::ModelRunner& runner) {
    Case c = at_rest(rig.c, 0);
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
