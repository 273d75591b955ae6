#pragma once

#include "contact/case.h"
#include "contact/models/model_kind.h"
#include "fem/case/model.h"
#include "fem/cell_response.h"

namespace tricontact::fem {

/// What the section of a case's bodies displaces under a strip of its surface, one element long,
/// for a contact that rolls on, as far as strips within `half_width` [m] to either side of it are
/// apart; at least for the contact and a third of it more. Elements as in make_section_model(),
/// which says what is thrown.
CellResponse section_cells(const contact::ModelKind& kind, const contact::Case& c,
                           double half_width, const Say& say);

}  // namespace tricontact::fem
