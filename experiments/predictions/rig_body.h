#pragma once

#include "contact/model_makers.h"
#include "experiments/assumptions/rig.h"
#include "io/case/rig_file.h"

namespace tricontact::experiments {

/// The body of a rig's case, pressed by F_N and loaded by coupling_tangential_ratio, by boundary
/// elements with the case's settings; standard errors by runs on cells of twice the size. The
/// substrate is relaxed. Throws contact::InputError, contact::NotConverged.
BodyContacts body_contacts(const contact::Case& c, const contact::ModelRunner& runner);

/// rolling_rig() with the contacts of its body where that is neither sphere nor cylinder. Throws
/// also what body_contacts() does.
Rig rig_with_body(const io::RigFile& file, const contact::ModelRunner& runner);

}  // namespace tricontact::experiments
