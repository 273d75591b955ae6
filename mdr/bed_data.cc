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

}  // namespace tricontact::mdr
