#include "mdr/bed_data.h"

#include <fmt/format.h>

#include <cmath>

#include "contact/error.h"

namespace tricontact::mdr {

using contact::InputError;

const BedData& checked(const BedData& data) {
    if (!data.profile) throw InputError("mdr: no indenter profile");
    auto positive = [](const char* name, double value) {
        if (!(value > 0) || !std::isfinite(value))
            throw InputError(fmt::format("mdr: {} = {:.6g} must be positive", name, value));
    };
    positive("effective modulus E*", data.effective_modulus);
    positive("effective shear modulus G*", data.effective_shear_modulus);
    positive("friction coefficient", data.friction_coefficient);
    positive("half length of the bed", data.half_length);
    if (data.n_springs < 10)
        throw InputError(fmt::format("mdr: {} springs are too few, give at least 10 (mdr.springs)",
                                     data.n_springs));
    if (data.relaxation) contact::check(*data.relaxation);
    return data;
}

void check_positive(const contact::NormalControl& control) {
    if (!(control.value > 0) || !std::isfinite(control.value))
        throw InputError(fmt::format(
            "mdr: the {} = {:.6g} must be positive: contact is lost",
            control.kind == contact::NormalControl::Kind::force ? "normal force" : "indentation",
            control.value));
}

void check_carried(const contact::TangentialControl& control, double limit) {
    if (control.kind == contact::TangentialControl::Kind::shift) return;
    if (!(std::abs(control.value) < limit))
        throw InputError(fmt::format(
            "mdr: the tangential force {:.6g} N reaches the friction limit mu F_N = {:.6g} N: the "
            "indenter slides; lower tangential_force or tangential_ratio",
            control.value, limit));
}

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
