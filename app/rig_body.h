#pragma once

#include "contact/case.h"
#include "experiments/assumptions/rig.h"
#include "io/case/rig_file.h"

namespace tricontact::app {

/// The body of a rig's case, pressed by F_N and loaded by experiments::coupling_tangential_ratio,
/// by boundary elements with the case's settings; standard errors by runs on cells of twice the
/// size. The substrate is relaxed. Throws contact::InputError, contact::NotConverged.
experiments::BodyContacts body_contacts(const contact::Case& c);

/// experiments::rolling_rig() with the contacts of its body where that is neither sphere nor
/// cylinder. Throws also what body_contacts() does.
experiments::Rig rig_with_body(const io::RigFile& file);

}  // namespace tricontact::app
