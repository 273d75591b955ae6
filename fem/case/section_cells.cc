#include "fem/case/section_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "contact/base/error.h"
#include "fem/case/row_response.h"
#include "fem/case/section_compliance.h"
#include "fem/settings.h"

namespace tricontact::fem {

namespace {

constexpr double least_room = 1.33;  // of the cells beside the contact

}  // namespace

CellResponse section_cells(const contact::ModelKind& kind, const contact::Case& c,
                           double half_width, const Say& say) {
    require_bodies(c, kind);
    const planar::Solid solid = solid_of(kind);
    CellResponse response;
    response.contact_radius = probed_section(c, solid).radius;
    const auto& given = c.of<Settings>().size;
    response.size = given ? *given : chosen_size(c, response.contact_radius);
    const double h = response.size, a = response.contact_radius;
    if (h > a / 2)
        throw contact::InputError(fmt::format(
            "fem.size: {}: fewer than 2 elements across the contact's {:.4g} m; reduce it",
            kind.name, a));
    const int n = static_cast<int>(std::ceil(std::max(half_width, least_room * a) / h)) + 1;
    const auto patch = section_patch(c, (2 * n + 2) * h, h);
    if (patch.half_width > widest_patch(c)) refuse_too_large(c, patch.half_width);
    const auto compliance = section_compliance(c, solid, patch, SectionPoints::elements);
    const std::span matrix(compliance->dense(),
                           9 * compliance->points().size() * compliance->points().size());
    set_row_response(matrix, compliance->points().area.front(), 2 * n + 1, response);
    say_cells(kind.name, response, say);
    return response;
}

}  // namespace tricontact::fem
