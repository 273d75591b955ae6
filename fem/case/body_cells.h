#pragma once

#include "contact/case.h"
#include "fem/case/model.h"
#include "fem/cell_response.h"

namespace tricontact::fem {

/// The same as section_cells() in three dimensions: of a slice in plane strain under a cylinder,
/// else of square cells. Throws contact::InputError, contact::NotConverged.
CellResponse body_cells(const contact::Case& c, double half_width, const Say& say);

}  // namespace tricontact::fem
