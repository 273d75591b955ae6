#include "contact/solvers/staggered_iteration.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "contact/base/error.h"
#include "contact/solvers/fixed_point.h"

namespace tricontact::contact {

namespace {

constexpr double first_gap = 1e-2;  // the first iteration leaves some thousandths

}  // namespace

void stagger(const Staggering& settings, std::vector<double> height,
             const std::function<StaggeredIterate(const std::vector<double>& height,
                                                  double looseness)>& contact) {
    FixedPoint iteration;
    double residual = first_gap;
    for (int k = 1; k <= FixedPoint::max_iterations; ++k) {
        const double looseness = std::max(1., settings.of_gap * residual / settings.tolerance);
        StaggeredIterate now = contact(height, looseness);
        residual = now.residual;
        if (residual <= settings.tolerance && looseness == 1) return;
        // Where nothing touches, it is what friction had done before: only without it is that so.
        height = now.touches ? iteration.next(height, now.height, residual) : std::move(now.height);
    }
    throw NotConverged(fmt::format(
        "{}: normal and tangential contact do not agree{}: the gap still changes by {:.2e} of the "
        "indentation after {} staggered iterations (tolerance {:.1e})",
        settings.who, settings.where, residual, FixedPoint::max_iterations, settings.tolerance));
}

std::array<TangentialControl, 2> without_ratios(std::array<TangentialControl, 2> control,
                                                const FrictionLaw& friction,
                                                const FrictionLaw::Total& total) {
    for (auto& [kind, value] : control)
        if (kind == TangentialControl::Kind::ratio) {
            kind = TangentialControl::Kind::force;
            value = friction.limit(total, value);
        }
    return control;
}

}  // namespace tricontact::contact
