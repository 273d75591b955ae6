#include "bem/summed_compliance.h"

#include <algorithm>
#include <cmath>

#include "bem/grid_compliance.h"

// Relaxing bodies are weighted sums of elastic ones on one grid
// (docs/explanation/models/relaxation.md): where y = 0 mirrors, one transform of the tractions
// serves all of them.

namespace tricontact::bem {

namespace {

void add(InfluenceCoefficients& sum, double weight, const InfluenceCoefficients& k) {
    using K = InfluenceCoefficients;
    for (double K::*const c : {&K::xx, &K::xy, &K::yy, &K::xz, &K::yz, &K::zz})
        sum.*c += weight * k.*c;
}

InfluenceTable weighted_sum(const std::vector<InfluenceTable>& tables,
                            const std::vector<double>& weights) {
    InfluenceTable sum = tables.front();
    std::ranges::fill(sum.cells, InfluenceCoefficients{});
    for (std::size_t j = 0; j < tables.size(); ++j)
        for (std::size_t i = 0; i < sum.cells.size(); ++i)
            add(sum.cells[i], weights[j], tables[j].cells[i]);
    return sum;
}

}  // namespace

contact::PartlyRelaxingSubstrate::Sum sum_of(const contact::CombinedCompliance::Parts& parts,
                                             int n_threads) {
    const auto tables = std::make_shared<std::vector<InfluenceTable>>();
    for (const auto& part : parts) {
        const auto* const on_grid = dynamic_cast<const GridCompliance*>(part.get());
        if (!on_grid) return {};
        tables->push_back(on_grid->influence());
    }
    const bool coupled =
        std::ranges::any_of(parts, [](const auto& part) { return part->is_coupled(); });
    auto of = [tables, grid = parts.front()->points(), coupled,
               n_threads](const std::vector<double>& weights) {
        const auto sum = std::make_shared<const InfluenceTable>(weighted_sum(*tables, weights));
        const auto at = [sum, cell = grid.spacing](double x, double y) {
            return sum->at(static_cast<int>(std::lround(x / cell[0])),
                           static_cast<int>(std::lround(y / cell[1])));
        };
        return std::make_shared<const GridCompliance>(at, grid, coupled, n_threads);
    };
    auto displacements = [](const contact::CombinedCompliance::Parts& sums,
                            const contact::SurfaceField& t, std::vector<contact::SurfaceField>& u) {
        std::vector<const GridCompliance*> bodies;
        for (const auto& sum : sums)
            bodies.push_back(static_cast<const GridCompliance*>(sum.get()));
        GridCompliance::displacements(bodies, t, u);
    };
    return {of, displacements};
}

}  // namespace tricontact::bem
