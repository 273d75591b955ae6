#include "app/models/roll_elements.h"

#include <algorithm>
#include <cmath>

#include "bem/case_grid.h"
#include "bem/grid_compliance.h"
#include "bem/influence_file.h"
#include "contact/base/error.h"
#include "contact/models/model_kind.h"
#ifdef TRICONTACT_WITH_FEM
#include "app/models/fem_entries.h"
#endif

namespace tricontact::app {

#ifdef TRICONTACT_WITH_FEM

namespace {

/// Of a rolled contact that coupling moves: enough for Dundurs' beta = 1/2 and mu = 0.6.
constexpr double usual_aside = .25;
constexpr double cells_margin = 1.08;

bem::InfluenceTable table_of(const fem::CellResponse& response) {
    bem::InfluenceTable table{response.size, response.n_x, response.n_y, {}};
    for (const auto& one : response.cells)
        table.cells.push_back({one.xx, one.xy, one.yy, one.xz, one.yz, one.zz});
    return table;
}

/// Half width of the largest grid that the table knows [m].
double widest_grid(const bem::InfluenceTable& table) {
    return (std::floor((table.n_x - 1) / 2.) - .5) * table.spacing;
}

}  // namespace

RolledElements rolled_elements(const std::string& model, const Case& c, const RollRuns& runs,
                               double aside) {
    const contact::ModelKind& kind = contact::model_kind(model);
    const double hertz = contact::half_space_scales(c).contact_radius;
    const double further = std::max(aside, usual_aside);
    const fem::CellResponse response = fem_entries().cell_response(
        kind, c, aside > 0 ? (cells_margin + further) * hertz : 0, runs.say);
    bem::InfluenceTable table = table_of(response);
    const double h = response.size;
    const double half =
        std::min(widest_grid(table), std::max((cells_margin + further) * response.contact_radius,
                                              aside > 0 ? (cells_margin + further) * hertz : 0));
    const bem::Cells cells{{h, h}, {0, 0}};
    auto grid = c.is_line_contact() ? bem::make_long_grid(half, cells, c.indenter.length, true)
                                    : bem::make_grid(half, half, cells, false);
    return {std::make_unique<contact::ElasticSubstrate>(bem::tabulated_compliance(
                std::move(table), model, true, std::move(grid), runs.threads, c.interface)),
            response.variation};
}

#else

RolledElements rolled_elements(const std::string& model, const Case&, const RollRuns&, double) {
    throw contact::InputError("models: this program was built without the model " + model);
}

#endif

}  // namespace tricontact::app
