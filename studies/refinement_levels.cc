#include "studies/refinement_levels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "comparisons/resolution/fineness.h"
#include "contact/cells.h"
#include "contact/models/model_kind.h"
#include "fem/settings.h"
#include "io/case/case_reader.h"
#include "io/case/rolling_on.h"
#include "mdr/settings.h"

namespace tricontact::studies {

namespace {

using Overrides = std::vector<std::string>;

/// The case at the resolution of the coarsest level.
Case coarsest_case(Case c, const contact::ModelKind& kind, const RefineOptions& options,
                   const Say& say) {
    if (kind.is_on_cells()) c.of<contact::Cells>().spacing = contact::cell_side(c);
    if (!kind.is_meshed()) return c;
    auto& elements = c.of<fem::Settings>();
    if (elements.mesh)
        options.refuse("fem.mesh = " + *elements.mesh +
                       ": a mesh from a file cannot be refined; give fem.size or fem.accuracy "
                       "instead");
    if (c.indenter.body && c.indenter.body->mesh)
        options.refuse("indenter.mesh = " + *c.indenter.body->mesh +
                       ": a mesh from a file cannot be refined; give indenter.body instead");
    if (!elements.size && kind.is_section())
        options.refuse("fem.size: " + std::string(kind.name) +
                       " is refined from this size, which is not given; give it");
    if (!elements.size) elements.size = 2 * options.makers->block_of(c, say).size;
    return c;
}

/// "fem.size = 0.5 mm", "mdr.springs = 14141".
std::string what_is_set(const Case& c, const contact::ModelKind& kind, double size) {
    if (!kind.is_on_line()) return fmt::format("{} = {:.4g} mm", kind.resolution, 1e3 * size);
    const auto& line = c.of<mdr::Settings>();
    return fmt::format(
        "{} = {}", mdr::line_resolution(kind, c.interface),
        mdr::springs_are_independent(kind, c.interface) ? line.springs : line.elements_per_radius);
}

/// The case for the model alone.
Case case_of(const RefineOptions& options) {
    const Case all = io::read_case(options.file, options.overrides);
    io::refuse_rolling_on(all, options.file);
    if (!std::ranges::count(all.models, options.model))
        options.refuse("models: " + options.model +
                       " is not among the models of the case; add it, or name another with "
                       "--models");
    Overrides overrides = options.overrides;
    std::erase_if(overrides, [](const auto& text) { return text.starts_with("models="); });
    return io::read_case(options.file, overrides, {options.model});
}

/// The case with further keys set, checked like any case file.
Level make_level(const Case& c, const std::string& name, const std::string& what, double size,
                 Overrides overrides, const RefineOptions& options) {
    // The folders of a level hold numbers; fields are for runs.
    overrides.insert(overrides.end(), {"output.vtk=none", "output.volume=none"});
    try {
        const Case level = io::parse_case(io::write_case(c), options.file, overrides);
        return {name, what,
                StudyPoint{.model = options.model,
                           .c = level,
                           .resolved = io::write_case(level),
                           .key = key_of(level, options.model)},
                size};
    } catch (const contact::InputError& error) {
        throw contact::InputError(
            fmt::format("{}: {} ({}): {}", options.file, name, what, error.what()));
    }
}

Level wider(const Level& level, double factor, const RefineOptions& options, const Say& say) {
    using comparisons::length_key;
    const contact::MeshBlock block = options.makers->block_of(level.c(), say);
    Overrides sides{length_key("substrate.width", factor * block.width)};
    // Where a roller's substrate ends along y is part of the problem; a cylinder's does not.
    if (!level.c().is_cylindrical())
        sides.push_back(length_key("substrate.depth", factor * block.depth));
    return make_level(level.c(), "wide",
                      fmt::format("{}, block {} times as wide", level.what, factor), level.size,
                      std::move(sides), options);
}

}  // namespace

RefinementPlan plan_refinement(const RefineOptions& options, const Say& say) {
    const contact::ModelKind& kind = contact::model_kind(options.model);
    const Case c = case_of(options), start = coarsest_case(c, kind, options, say);
    RefinementPlan plan;
    plan.key = kind.resolution;
    for (int k = 0; k < options.levels; ++k) {
        const double ratio = std::pow(2., -k / 2.);
        const comparisons::Fineness by{.coarser = ratio};
        Case changed = start;
        comparisons::change_resolution(changed, kind, by);
        const double size = comparisons::cell_size(changed, kind);
        plan.levels.push_back(make_level(c, fmt::format("level_{}", k),
                                         what_is_set(changed, kind, size), size,
                                         comparisons::level_keys(start, kind, by), options));
    }
    if (kind.sees_sides && !c.has_rigid_substrate)
        plan.wide = wider(plan.levels[plan.levels.size() - 2], plan.wide_factor, options, say);
    return plan;
}

}  // namespace tricontact::studies
