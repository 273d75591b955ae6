#include "meshes/layer_mesh.h"

#include <gmsh.h>

#include "meshes/gmsh_blocks.h"
#include "meshes/gmsh_model.h"
#include "meshes/gmsh_session.h"
#include "meshes/grid_order.h"

namespace tricontact::meshes {

HexMesh make_layer_mesh(const LayerMeshSpec& spec) {
    const LayerGrid grid = layer_grid(spec);
    // gmsh has absolute tolerances: its unit of length is the element, whatever the layer's scale.
    const double unit = spec.size;
    HexMesh mesh;
    {
        const GmshSession session;
        GmshSession::call([&] {
            build_blocks(grid, unit);
            gmsh::model::mesh::generate(3);
            mesh = collect_model(unit, "layer mesh");
        });
    }
    return in_grid_order(mesh, grid);
}

}  // namespace tricontact::meshes
