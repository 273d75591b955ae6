#include "fem/case/layer_condenser.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "contact/solvers/contact_share.h"
#include "fem/block/inside_solver.h"
#include "fem/case/indenter_body.h"
#include "fem/condensed_layer.h"
#include "fem/mortar/pressure_grid.h"
#include "fem/settings.h"

// Condensing takes minutes and gigabytes, a product milliseconds: so a layer is looked for in the
// cache first, waited for if another process makes it, and kept afterwards
// (docs/explanation/models/fem.md, "Condensation"). What was done is said in a line of the run.

namespace tricontact::fem {

using contact::Case;

LayerProblem problem_of(const Case& c, meshes::HexMesh mesh) {
    LayerProblem problem;
    problem.mesh = std::move(mesh);
    problem.materials = {c.substrate,
                         c.layer.lower.empty() ? c.substrate : c.layer.lower.front().material};
    problem.base = c.layer.base;
    // On a frictionless base only the sides can hold a layer that is pulled sideways.
    problem.sides =
        c.layer.base == Case::Base::frictionless ? Sides::fixed : c.of<Settings>().sides;
    if (c.is_cylindrical() || is_block(c))
        problem.line_length =
            std::min(c.indenter.length, c.layer.depth.value_or(c.indenter.length));
    return problem;
}

LayerCondenser::LayerCondenser(const Case& c, Say say)
    : case_(c), cache_(c.of<Settings>().cache), say_(std::move(say)) {}

CondensedPart LayerCondenser::part(LayerProblem of_body, const char* what) const {
    auto problem = std::make_shared<const LayerProblem>(std::move(of_body));
    const std::string key = LayerCache::key(*problem);
    LayerCache::Claim claim = cache_.claim(key, [&] {
        say(fmt::format("another process condenses this {}, which is waited for", what));
    });
    if (claim.layer) {
        say(fmt::format("condensed {} reused from {} ({} contact nodes)", what, cache_.path_of(key),
                        claim.layer->points.size()));
        return {std::move(problem), std::move(*claim.layer)};
    }
    if (!claim.why.empty()) say(fmt::format("condensed {} recomputed: {}", what, claim.why));
    const auto start = std::chrono::steady_clock::now();
    CondensedLayer layer = condense(*problem);
    std::string why;
    const bool kept = cache_.store(key, layer, &why);
    if (!kept && !why.empty()) say(fmt::format("condensed {} not kept: {}", what, why));
    say(fmt::format("{} of {} elements condensed to {} contact nodes in {:.1f} s{}", what,
                    problem->mesh.hexes.size(), layer.points.size(),
                    std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
                    kept ? fmt::format(", kept in {}", cache_.path_of(key)) : ""));
    return {std::move(problem), std::move(layer)};
}

bool LayerCondenser::couples_by_element_means() const {
    return case_.law == Case::Law::linear && contact::jumps_at_edge(*case_.friction.law());
}

std::unique_ptr<CondensedCompliance> LayerCondenser::make(meshes::HexMesh mesh) {
    CondensedPart layer = part(problem_of(case_, std::move(mesh)), "layer");
    std::unique_ptr<CondensedCompliance> made;
    // A tension over the gap asks for points that are alike.
    if (case_.adhesion) {
        const contact::ContactPoints grid = grid_on_nodes(layer.layer.points);
        PressureTransfer transfer = transfer_to(layer.layer.points, grid);
        layer.layer = on_grid(std::move(layer.layer), grid, transfer);
        made = std::make_unique<CondensedCompliance>(std::move(layer.problem),
                                                     std::move(layer.layer), std::move(transfer));
    } else {
        made = std::make_unique<CondensedCompliance>(
            std::move(layer.problem),
            case_.is_line_contact() ? contact_line(layer.layer) : std::move(layer.layer),
            case_.interface, couples_by_element_means());
    }
    made->solve_inside_by(block_inside_solver);
    return made;
}

/// A block ends at its outermost points.
CondensedLayer LayerCondenser::line_of(const CondensedLayer& slice) const {
    CondensedLayer line = contact_line(slice);
    line.points.is_whole_face = is_block(case_);
    return line;
}

// Its points have the substrate's x already, which are along its surface.
void LayerCondenser::to_frame_of_rolling(CondensedPart& indenter) const {
    if (!rolls_on_its_hub(case_)) return;
    indenter.round_radius = case_.indenter.radius;
    turn_to_round_frame(indenter.layer, indenter.round_radius);
}

// Areas of a line are those of the plane, as in space.
std::unique_ptr<contact::Compliance> LayerCondenser::on_rigid_plane(
    const meshes::LayerMeshSpec& spec, CondensedPart indenter) const {
    ContactSurface plane = plane_patch(spec);
    if (rolls_on_its_hub(case_) || case_.is_line_contact()) indenter.layer.points = plane.points;
    to_frame_of_rolling(indenter);
    if (case_.is_line_contact()) {
        indenter.layer = line_of(indenter.layer);
        plane = {{}, indenter.layer.points, {}};
    }
    return std::make_unique<PairCompliance>(std::move(plane), std::move(indenter), case_.interface,
                                            couples_by_element_means());
}

std::unique_ptr<contact::Compliance> LayerCondenser::make_contact(
    const meshes::LayerMeshSpec& spec) {
    if (!case_.indenter.body) return make(make_layer_mesh(spec));
    CondensedPart indenter = part(indenter_problem(case_, spec), "indenter");
    if (case_.has_rigid_substrate) return on_rigid_plane(spec, std::move(indenter));
    CondensedPart layer = part(problem_of(case_, make_layer_mesh(spec)), "layer");
    if (rolls_on_its_hub(case_) || case_.is_line_contact())
        indenter.layer.points = layer.layer.points;
    to_frame_of_rolling(indenter);
    if (case_.is_line_contact()) {
        indenter.layer = line_of(indenter.layer);
        layer.layer = line_of(layer.layer);
    }
    return std::make_unique<PairCompliance>(std::move(layer), std::move(indenter), case_.interface,
                                            couples_by_element_means());
}

}  // namespace tricontact::fem
