#include "fem/case/layer_condenser.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "contact/solvers/contact_share.h"
#include "fem/condensed_layer.h"
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
    if (c.is_cylindrical())
        problem.line_length =
            std::min(c.indenter.length, c.layer.depth.value_or(c.indenter.length));
    return problem;
}

LayerCondenser::LayerCondenser(const Case& c, Say say)
    : case_(c), cache_(c.of<Settings>().cache), say_(std::move(say)) {}

std::unique_ptr<CondensedCompliance> LayerCondenser::make(meshes::HexMesh mesh) {
    auto problem = std::make_shared<const LayerProblem>(problem_of(case_, std::move(mesh)));
    const std::string key = LayerCache::key(*problem);
    const auto compliance_of = [&](CondensedLayer layer) {
        return std::make_unique<CondensedCompliance>(
            problem, case_.is_line_contact() ? contact_line(layer) : std::move(layer),
            case_.interface,
            case_.law == Case::Law::linear && contact::jumps_at_edge(*case_.friction.law()));
    };
    LayerCache::Claim claim = cache_.claim(
        key, [&] { say("another process condenses this layer, which is waited for"); });
    if (claim.layer) {
        say(fmt::format("condensed layer reused from {} ({} contact nodes)", cache_.path_of(key),
                        claim.layer->points.size()));
        return compliance_of(std::move(*claim.layer));
    }
    if (!claim.why.empty()) say(fmt::format("condensed layer recomputed: {}", claim.why));
    const auto start = std::chrono::steady_clock::now();
    CondensedLayer layer = condense(*problem);
    std::string why;
    const bool kept = cache_.store(key, layer, &why);
    if (!kept && !why.empty()) say(fmt::format("condensed layer not kept: {}", why));
    say(fmt::format("layer of {} elements condensed to {} contact nodes in {:.1f} s{}",
                    problem->mesh.hexes.size(), layer.points.size(),
                    std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
                    kept ? fmt::format(", kept in {}", cache_.path_of(key)) : ""));
    return compliance_of(std::move(layer));
}

}  // namespace tricontact::fem
