#include "mdr/bed.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "contact/base/error.h"
#include "contact/base/special_values.h"
#include "mdr/normal_bed.h"

namespace tricontact::mdr {

using contact::InputError;
using contact::NormalControl;
using contact::TangentialControl;

namespace {

const BedData& checked(const BedData& data) {
    if (!data.profile) throw InputError("mdr: no indenter profile");
    if (!data.friction) throw InputError("mdr: no law of friction");
    auto positive = [](const char* name, double value) {
        if (!contact::is_positive_and_finite(value))
            throw InputError(fmt::format("mdr: {} = {:.6g} must be positive", name, value));
    };
    positive("effective modulus E*", data.effective_modulus);
    positive("effective shear modulus G*", data.effective_shear_modulus);
    positive("friction coefficient", data.friction->ratio_at(data.effective_modulus));
    positive("half length of the bed", data.half_length);
    if (data.n_springs < 10)
        throw InputError(fmt::format("mdr: {} springs are too few, give at least 10 (mdr.springs)",
                                     data.n_springs));
    if (data.relaxation) contact::check(*data.relaxation);
    return data;
}

}  // namespace

double position_on_line(const std::string& model, const contact::LoadStep& step,
                        const contact::Vector2& direction, double spacing) {
    if (step.rotation != 0)
        throw InputError(model + ": a line of springs cannot be twisted; take bem or bem-layer");
    if (step.tangential[1].value != 0)
        throw InputError(
            model +
            ": a tangential force or shift across the load (y) is not possible in a spring bed, "
            "which has one direction; set it to zero");
    const double along = contact::dot(step.offset, direction);
    const double across = step.offset[1] * direction[0] - step.offset[0] * direction[1];
    if (!(std::abs(across) <= 1e-9 * (std::abs(along) + spacing)))
        throw InputError(fmt::format(
            "{}: the rolling offset ({:.6g}, {:.6g}) m lies off the line of rolling, along which "
            "alone a spring bed extends",
            model, step.offset[0], step.offset[1]));
    return along;
}

Bed::Bed(const BedData& data)
    : effective_modulus_(checked(data).effective_modulus),
      effective_shear_modulus_(data.effective_shear_modulus),
      law_(data.friction),
      direction_{std::cos(data.rolling_angle), std::sin(data.rolling_angle)},
      bound_ratio_(law_->coulomb().value_or(std::numeric_limits<double>::quiet_NaN()) *
                   effective_modulus_ / effective_shear_modulus_) {}

void Bed::check_positive(const NormalControl& control) {
    if (!contact::is_positive_and_finite(control.value))
        throw InputError(
            fmt::format("mdr: the {} = {:.6g} must be positive: contact is lost",
                        control.kind == NormalControl::Kind::force ? "normal force" : "indentation",
                        control.value));
}

void Bed::check_carried(const TangentialControl& control) const {
    const double limit = friction_limit();
    if (!(std::abs(control.value) < limit))
        throw InputError(fmt::format(
            "mdr: the tangential force {:.6g} N reaches the friction limit {}{:.6g} N: the "
            "indenter slides; lower tangential_force or tangential_ratio",
            control.value, law_->coulomb() ? "mu F_N = " : "", limit));
}

void Bed::audit_forces(const contact::LoadStep& step, const SlipSums& sums, double peak_bound,
                       bool held) {
    audit_.record("friction_bound", sums.bound_excess / peak_bound, 0);
    audit_.record("slip_along_traction", -sums.lowest_work / (peak_bound * peak_bound), 0);
    if (step.normal.kind == NormalControl::Kind::force)
        audit_.record("normal_force", std::abs(normal_force_ / step.normal.value - 1), rounding);
    const TangentialControl& control = step.tangential[0];
    if (held && control.kind == TangentialControl::Kind::force)
        audit_.record("tangential_force",
                      std::abs(tangential_force_ - control.value) / friction_limit(), rounding);
}

contact::StepRecord Bed::record(const contact::LoadStep& step, const ShiftSolution& shift,
                                double depth, double spacing, const Springs& n, bool held) const {
    auto disc = [spacing](double n_springs) {
        return std::numbers::pi / 4 * n_springs * n_springs * spacing * spacing;
    };
    contact::StepRecord r;
    r.phase = step.phase;
    r.offset = step.offset;
    r.normal_force = normal_force_;
    r.tangential_force = {tangential_force_, 0};
    r.indentation = depth;
    r.shift = {shift_, 0};
    r.contact_area = disc(n.in_contact);
    r.stick_area = disc(n.sticking);
    r.slip_area = r.contact_area - r.stick_area;
    r.open_area = disc(n.all) - r.contact_area;
    r.tangential_iterations = shift.iterations;
    r.tangential_residual = shift.residual;
    if (step.normal.kind == NormalControl::Kind::force)
        r.normal_residual = std::abs(normal_force_ / step.normal.value - 1);
    r.force_residual = r.normal_residual;
    const TangentialControl& control = step.tangential[0];
    if (held && control.kind == TangentialControl::Kind::force)
        r.force_residual = std::max(r.force_residual,
                                    std::abs(tangential_force_ - control.value) / friction_limit());
    return r;
}

}  // namespace tricontact::mdr
