#pragma once

#include "contact/model_makers.h"
#include "experiments/assumptions/rig.h"
#include "io/case/rig_file.h"

namespace tricontact::experiments {

/// The case without motion, relaxed, its loads constant, F_T/(mu F_N) as given.
contact::Case at_rest(contact::Case c, double tangential_ratio);

/// What a model has of a case at rest; standard errors by runs on cells or elements of twice the
/// size. Throws contact::InputError, contact::NotConverged.
BodyContact contact_by(const std::string& model, const contact::Case& c,
                       const contact::ModelRunner& runner);

/// The body of a rig's case, pressed by F_N and loaded by coupling_tangential_ratio, by boundary
/// elements with the case's settings; standard errors by runs on cells of twice the size. The
/// substrate is relaxed. Throws contact::InputError, contact::NotConverged.
BodyContacts body_contacts(const contact::Case& c, const contact::ModelRunner& runner);

/// The indenter of a rig's case, pressed by F_N, with and without a work of adhesion [J/m^2], by
/// the springs of mdr and mdr-layer; without numbers where they do not compute it.
AttractedContacts attracted_contacts(const contact::Case& c, double work,
                                     const contact::ModelRunner& runner);

/// rolling_rig() with the contacts of its body where that is neither sphere nor cylinder, and with
/// attracted_contacts() where no closed form has them. Throws also what body_contacts() does.
Rig rig_with_body(const io::RigFile& file, const contact::ModelRunner& runner);

}  // namespace tricontact::experiments
