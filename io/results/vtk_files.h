#pragma once

#include <string>
#include <string_view>

#include "contact/solvers/interior.h"
#include "contact/surface.h"
#include "io/results/provenance.h"

namespace tricontact::io {

/// A file of a series for ParaView, not yet written.
struct VtkFile {
    std::string_view extension;  ///< ".vti" ...
    std::string bytes;
};

/// A contact surface: `.vti` (grid: cell data, cells centred on the points), `.vtp` (line: point
/// data on vertices and a polyline) or `.vtu` (nodes: point data on biquadratic quadrilaterals at
/// z = 0). Throws std::invalid_argument where a field has another size than the surface.
VtkFile vtk_file(double phase, const contact::Surface& surface, const Provenance& provenance);

/// The inside of the substrate: `.vtu` of triquadratic hexahedra or `.vtr` of a rectilinear grid,
/// point data, with von Mises' stress and the mean pressure (compression positive) beside the
/// stress. Throws std::invalid_argument.
VtkFile vtk_file(double phase, const contact::Interior& interior, const Provenance& provenance);

}  // namespace tricontact::io
