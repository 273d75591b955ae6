#include "fem/case/body_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/base/error.h"
#include "contact/load_path.h"
#include "contact/models/model_kind.h"
#include "fem/case/cell_load.h"
#include "fem/case/indenter_body.h"
#include "fem/case/mesh_choice.h"
#include "fem/case/row_response.h"
#include "fem/settings.h"
#include "meshes/layer_mesh.h"

// A layer and a sphere are the same anywhere along their surfaces, so that one cell tells of all:
//
//   a mesh around the cell, graded outwards --> factor --> three loads, one at a time --> fields
//       along the surface at all relative positions --> sum of both bodies
//
// Cells are four elements wide. What acts along y is what acts along x, turned by 90 degrees: the
// block is square. Of a cylinder the compliance of a slice is there anyway, and is taken by
// elements.

namespace tricontact::fem {

namespace {

using contact::Case;

constexpr double least_cells_room = 1.33;  // of the cells beside the contact
constexpr double cells_in_radius = 20;

/// By the means of whole elements, of the matrix of a row of nodes.
std::vector<double> by_elements(const double* nodes, std::size_t n_nodes) {
    constexpr std::array<double, 3> part{1. / 6, 4. / 6, 1. / 6};  // Simpson's
    const std::size_t n = (n_nodes - 1) / 2;
    std::vector<double> matrix(9 * n * n, 0);
    for (std::size_t column = 0; column < 3 * n; ++column)
        for (std::size_t row = 0; row < 3 * n; ++row)
            for (std::size_t b = 0; b < 3; ++b)
                for (std::size_t a = 0; a < 3; ++a) {
                    const std::size_t of = column / n * n_nodes + 2 * (column % n) + b;
                    const std::size_t at = row / n * n_nodes + 2 * (row % n) + a;
                    matrix[column * 3 * n + row] +=
                        part[a] * part[b] * nodes[of * 3 * n_nodes + at];
                }
    return matrix;
}

CellResponse slice_cells(const Case& c, LayerCondenser& condenser, double half_width,
                         CellResponse response) {
    const double h = response.size;
    const int n = static_cast<int>(std::ceil(half_width / h)) + 1;
    const meshes::LayerMeshSpec spec = spec_for(c, h, (2 * n + 2) * h);
    const auto compliance = make_fitting(c, spec, condenser);
    const auto matrix = by_elements(compliance->dense(), compliance->points().size());
    set_row_response(matrix, h * compliance->points().line_length, 2 * n + 1, response);
    return response;
}

/// Around one cell, four elements across.
meshes::LayerMeshSpec spec_of_cell(const Case& c, double size) {
    meshes::LayerMeshSpec spec = spec_for(c, size / 4, size);
    spec.half_model = true;
    if (!c.has_rigid_substrate && std::abs(spec.half_x - spec.half_y) > 1e-9 * spec.half_x)
        throw contact::InputError(fmt::format(
            "substrate.depth: fem rolls on over a square block, {:.4g} m long, which is as stiff "
            "along y as along x; leave it out or give it that length",
            2 * spec.half_x));
    return spec;
}

/// Positions along each axis, for cells within this half width, as far as the block goes.
int positions_within(const meshes::LayerMeshSpec& spec, const Case& c, double half_width,
                     const CellResponse& response) {
    const double h = response.size;
    const int wanted = 2 * static_cast<int>(std::ceil(half_width / h)) + 3;
    if (c.has_rigid_substrate) return wanted;
    const int there = static_cast<int>(std::floor(spec.half_x / h * (1 - 1e-9))) + 1;
    const double both_ends = 2.1 * response.contact_radius;
    if ((there - 2) * h < both_ends)
        throw contact::InputError(
            fmt::format("substrate.width: fem rolls on by what a cell displaces at the other end "
                        "of the contact, "
                        "{:.4g} m away, but the block reaches {:.4g} m; enlarge it or leave it out",
                        both_ends, spec.half_x));
    return std::min(wanted, there);
}

void add(const SurfaceFields& fields, double sign_across, CellResponse& response) {
    const auto at = [&](int i, int j) { return static_cast<std::size_t>(j) * response.n_x + i; };
    for (int j = 0; j < response.n_y; ++j)
        for (int i = 0; i < response.n_x; ++i) {
            auto& one = response.cells[at(i, j)];
            const auto &by_x = fields.by_x[at(i, j)], &by_z = fields.by_z[at(i, j)];
            one.xx += by_x[0];
            one.xy += by_x[1];
            one.yy += fields.by_x[at(j, i)][0];
            one.xz += sign_across * by_z[0];
            one.yz += sign_across * by_z[1];
            one.zz += by_z[2];
        }
}

/// Of a layer whose sides are this much nearer [m].
SurfaceFields layer_fields(const Case& c, meshes::LayerMeshSpec spec, double nearer,
                           const CellGrid& cells) {
    spec.half_x -= nearer;
    spec.half_y -= nearer;
    return cell_fields(problem_of(c, make_layer_mesh(spec)), cells);
}

}  // namespace

CellResponse body_cells(const Case& c, double half_width, const Say& say) {
    LayerCondenser condenser(c, say);
    CellResponse response;
    contact::NormalControl hardest = contact::press_step(c).normal;
    response.contact_radius = probe_radius(c, hardest, condenser);
    const double a = response.contact_radius;
    response.size = c.of<Settings>().size.value_or(a / cells_in_radius);
    if (response.size > a / 2)
        throw contact::InputError(fmt::format(
            "fem.size: fewer than 2 cells across the contact's {:.4g} m; reduce it", a));
    half_width = std::max(half_width, least_cells_room * a);
    if (c.is_line_contact()) {
        response = slice_cells(c, condenser, half_width, response);
        say_cells(contact::models::fem, response, say);
        return response;
    }
    const meshes::LayerMeshSpec spec = spec_of_cell(c, response.size);
    const int n = positions_within(spec, c, half_width, response);
    response.n_x = response.n_y = n;
    response.cells.assign(static_cast<std::size_t>(n) * n, {});
    const CellGrid cells{response.size, n, c.indenter.body ? c.indenter.radius : 0};
    if (c.indenter.body) add(cell_fields(indenter_problem(c, spec), cells), 1, response);
    if (!c.has_rigid_substrate) {
        const CellGrid plane{response.size, n, 0};
        const SurfaceFields whole = layer_fields(c, spec, 0, plane);
        add(whole, -1, response);
        if (c.layer.width || c.layer.depth) {
            CellGrid fewer = plane;  // as far as the block goes then
            fewer.n = std::min(n, static_cast<int>((spec.half_x - a) / response.size));
            response.variation = largest_difference(whole, layer_fields(c, spec, a, fewer)) /
                                 response.cells.front().zz;
        }
    }
    say_cells(contact::models::fem, response, say);
    return response;
}

}  // namespace tricontact::fem
