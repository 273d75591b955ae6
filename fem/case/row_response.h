#pragma once

#include <span>
#include <string>

#include "fem/case/model.h"
#include "fem/cell_response.h"

namespace tricontact::fem {

/// From the compliance of a row of equal cells, displacement over force (as
/// contact::Compliance::dense() says), `area` [m^2] being that of a cell: what the middle of the
/// row has, at so many positions, and how far other places differ. Size and radius are there.
void set_row_response(std::span<const double> matrix, double area, int n_positions,
                      CellResponse& response);

/// What a contact that rolls on is computed with.
void say_cells(const std::string& model, const CellResponse& response, const Say& say);

}  // namespace tricontact::fem
