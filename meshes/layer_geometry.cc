#include <fmt/format.h>
#include <fmt/ranges.h>

#include "meshes/layer_grid.h"

namespace tricontact::meshes {

namespace {

std::string axis_text(char name, const GridAxis& axis) {
    std::vector<int> n;
    std::vector<double> ratios;
    for (const GridAxis::Strip& strip : axis.strips) {
        n.push_back(strip.n);
        ratios.push_back(strip.ratio);
    }
    return fmt::format("{0}[] = {{{1}}};\nn_{0}[] = {{{2}}};\nratio_{0}[] = {{{3}}};\n", name,
                       fmt::join(axis.planes, ", "), fmt::join(n, ", "), fmt::join(ratios, ", "));
}

std::string geometry_text(const LayerMeshSpec& spec, const LayerGrid& grid) {
    std::string text = fmt::format(
        "// Elastic layer, lengths in m. Mesh: gmsh layer.geo -3 -format msh41 -o layer.msh\n"
        "// z points out of the substrate, whose surface is z = 0; the contact is about the "
        "origin.\n"
        "Geometry.Tolerance = {:g};  // 1e-6 elements\n\n"
        "// Planes between blocks; per block the number of elements and the ratio of an element to "
        "the\n"
        "// one before it.\n",
        1e-6 * spec.size);
    for (int d = 0; d < 3; ++d) text += axis_text("xyz"[d], grid.axes[d]);
    text += fmt::format(
        "patch_i = {}; patch_j = {}; last_patch_j = {};  // the blocks under the contact, from 0\n"
        "half_model = {};  // 1: the face at the least y is a plane of symmetry\n"
        "slice = {};       // 1: that at the greatest y, too\n",
        grid.patch_x, grid.patch_y, grid.last_patch_y, grid.symmetric_low ? 1 : 0,
        grid.symmetric_high ? 1 : 0);
    return fmt::format("{}\n{}", text, layer_blocks);
}

}  // namespace

std::string layer_geometry(const LayerMeshSpec& spec) {
    return geometry_text(spec, layer_grid(spec));
}

}  // namespace tricontact::meshes
