#pragma once

#include <memory>

#include "contact/bodies/indenter.h"
#include "contact/compliances/compliance.h"
#include "fem/case/layer_condenser.h"

namespace tricontact::fem {

/// Bodies of gmsh files as the contact sees them: joined by a pressure grid.
struct MeshedContact {
    std::unique_ptr<contact::Compliance> compliance;
    std::unique_ptr<contact::Indenter> indenter;  ///< the gap, known on the grid's points alone
};

/// The indenter of a case with indenter.mesh on its substrate: rigid, a layer of our own mesh, or
/// the body of fem.mesh. The indenter is let down along z until it touches. Throws
/// contact::InputError: files, bodies that overlap or do not face each other;
/// contact::NotConverged.
MeshedContact make_meshed_contact(const contact::Case& c, const LayerCondenser& condenser);

}  // namespace tricontact::fem
