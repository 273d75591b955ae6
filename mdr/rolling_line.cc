#include "mdr/rolling_line.h"

#include <fmt/format.h>

#include <cmath>

#include "contact/error.h"

namespace tricontact::mdr {

void check_on_line(const std::string& model, const contact::LoadStep& step) {
    if (step.tangential[1].value != 0)
        throw contact::InputError(
            model +
            ": a tangential force or shift across the load (y) is not possible in a spring bed, "
            "which has one direction; set it to zero");
}

double line_coordinate(const std::string& model, const contact::Vector2& offset,
                       const contact::Vector2& direction, double spacing) {
    const double along = contact::dot(offset, direction);
    const double across = offset[1] * direction[0] - offset[0] * direction[1];
    if (!(std::abs(across) <= 1e-9 * (std::abs(along) + spacing)))
        throw contact::InputError(fmt::format(
            "{}: the rolling offset ({:.6g}, {:.6g}) m lies off the line of rolling, along which "
            "alone a spring bed extends",
            model, offset[0], offset[1]));
    return along;
}

}  // namespace tricontact::mdr
