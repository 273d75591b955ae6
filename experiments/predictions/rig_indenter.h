#pragma once

#include "contact/model_makers.h"
#include "experiments/assumptions/check_rig.h"

namespace tricontact::experiments {

/// The model of sections that computes a rig's indenter as the body that it is.
const char* model_of_indenter(const Rig& rig);

/// The rig's indenter on its layer under F_N, pressed without friction: its body by a section, a
/// half-space in its place by bem-layer; standard errors by runs on meshes of twice the size.
/// Throws contact::InputError, contact::NotConverged.
IndenterContacts indenter_contacts(const Rig& rig, const contact::ModelRunner& runner);

}  // namespace tricontact::experiments
