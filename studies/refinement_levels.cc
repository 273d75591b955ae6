#include "studies/refinement_levels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/models/model_kind.h"
#include "io/case/case_reader.h"
#include "io/case/rolling_on.h"

namespace tricontact::studies {

namespace {

using Overrides = std::vector<std::string>;

constexpr double least_growth = 1.05;  // that a case file may ask for

std::string length(double metres) {
    return fmt::format("\"{} m\"", metres);
}

double start_size(const Case& c, const RefineOptions& options, const Say& say) {
    if (!contact::model_kind(options.model).is_meshed())
        return c.bem.spacing
                   ? *c.bem.spacing
                   : contact::half_space_scales(c).contact_radius / *c.bem.cells_per_radius;
    if (c.fem.mesh)
        options.refuse("fem.mesh = " + *c.fem.mesh +
                       ": a mesh from a file cannot be refined; give fem.size or fem.accuracy "
                       "instead");
    return c.fem.size ? *c.fem.size : 2 * options.makers->block_of(c, say).size;
}

/// The case for the model alone.
Case case_of(const RefineOptions& options) {
    const Case all = io::read_case(options.file, options.overrides);
    io::refuse_rolling_on(all, options.file);
    if (!std::ranges::count(all.models, options.model))
        options.refuse("models: " + options.model +
                       " is not among the models of the case; add it, or name another with "
                       "--model");
    Overrides overrides = options.overrides;
    std::erase_if(overrides, [](const auto& text) { return text.starts_with("models="); });
    return io::read_case(options.file, overrides, {options.model});
}

/// The case with further keys set, checked like any case file.
Level make_level(const Case& c, const std::string& name, const std::string& what, double size,
                 Overrides overrides, const std::string& case_file) {
    // The folders of a level hold numbers; fields are for runs.
    overrides.insert(overrides.end(), {"output.vtk=none", "output.volume=none"});
    try {
        const Case level = io::parse_case(io::write_case(c), case_file, overrides);
        return {name, what, level, io::write_case(level), size};
    } catch (const contact::InputError& error) {
        throw contact::InputError(
            fmt::format("{}: {} ({}): {}", case_file, name, what, error.what()));
    }
}

Overrides resolution(const Case& c, const contact::ModelKind& kind, double size, int k) {
    Overrides result{std::string(kind.resolution) + "=" + length(size)};
    if (kind.is_meshed()) {
        const double growth = std::pow(c.fem.growth, std::pow(2., -k / 2.));
        result.push_back(fmt::format("fem.growth={}", std::max(growth, least_growth)));
    }
    return result;
}

Level wider(const Level& level, double factor, const RefineOptions& options, const Say& say) {
    const contact::MeshBlock block = options.makers->block_of(level.c, say);
    Overrides sides{"substrate.width=" + length(factor * block.width)};
    // Where a roller's substrate ends along y is part of the problem; a cylinder's does not.
    if (!level.c.is_cylindrical())
        sides.push_back("substrate.depth=" + length(factor * block.depth));
    return make_level(level.c, "wide",
                      fmt::format("{}, block {} times as wide", level.what, factor), level.size,
                      std::move(sides), options.file);
}

}  // namespace

RefinementPlan plan_refinement(const RefineOptions& options, const Say& say) {
    const Case c = case_of(options);
    const double coarsest = start_size(c, options, say);
    RefinementPlan plan;
    const contact::ModelKind& kind = contact::model_kind(options.model);
    plan.key = kind.resolution;
    for (int k = 0; k < options.levels; ++k) {
        const double size = coarsest * std::pow(2., -k / 2.);
        plan.levels.push_back(make_level(c, fmt::format("level_{}", k),
                                         fmt::format("{} = {:.4g} mm", plan.key, 1e3 * size), size,
                                         resolution(c, kind, size, k), options.file));
    }
    if (kind.sees_sides)
        plan.wide = wider(plan.levels[plan.levels.size() - 2], plan.wide_factor, options, say);
    return plan;
}

}  // namespace tricontact::studies
