#pragma once

#include "meshes/msh_model.h"

namespace tricontact::meshes {

/// Divides each tetrahedron of 10 nodes into four hexahedra, one about each corner, and each
/// triangle of 6 nodes into three quadrilaterals: by the nodes amid its edges, and new ones amid
/// its faces and itself, where its quadratic functions put them. Curved surfaces keep their form at
/// all nodes. Other elements stay, and so do tetrahedra if one of them has a node that the model
/// has not.
void divide_tetrahedra(MshModel& model);

}  // namespace tricontact::meshes
