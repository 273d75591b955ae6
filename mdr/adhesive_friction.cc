#include "mdr/adhesive_friction.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "contact/base/error.h"
#include "mdr/stores_shear.h"

namespace tricontact::mdr {

using contact::NormalControl;

AdhesiveFriction::AdhesiveFriction(std::unique_ptr<contact::Model> unattracted)
    : unattracted_(std::move(unattracted)) {
    if (!dynamic_cast<const StoresShear*>(unattracted_.get()))
        throw std::logic_error("AdhesiveFriction: of springs alone");
}

double AdhesiveFriction::stored() const {
    return dynamic_cast<const StoresShear&>(*unattracted_).shear_energy();
}

void AdhesiveFriction::advance(const contact::LoadStep& step, double depth,
                               contact::StepRecord& record, contact::Audit& audit) {
    if (!(depth > 0))
        throw contact::InputError(
            unattracted_->name() +
            ": friction of a contact that is narrower than the flat end of its indenter is not "
            "computed under adhesion; press harder, or take another indenter.shape");
    contact::LoadStep pressed = step;
    pressed.normal = {NormalControl::Kind::indentation, depth};
    const contact::StepRecord along = unattracted_->advance(pressed);
    record.offset = along.offset;
    record.tangential_force = along.tangential_force;
    record.shift = along.shift;
    record.dissipation = along.dissipation;
    record.stored_energy += stored();
    // Elements are whole ones; the contact is known better.
    const double sticks = std::clamp(along.stick_area / along.contact_area, 0., 1.);
    record.stick_area = sticks * record.contact_area;
    record.slip_area = record.contact_area - record.stick_area;
    record.tangential_iterations = along.tangential_iterations;
    record.tangential_residual = along.tangential_residual;
    record.force_residual = along.force_residual;
    constexpr std::array along_the_surface{"friction_bound", "slip_along_traction",
                                           "tangential_force"};
    for (const auto& check : unattracted_->audit().checks())
        if (std::ranges::count(along_the_surface, check.name) || !check.passed())
            audit.record(check.name, check.worst, check.allowed);
}

void AdhesiveFriction::let_go(const contact::LoadStep& step, contact::StepRecord& record) {
    if (std::ranges::any_of(step.tangential, [](const auto& one) { return one.value != 0; }))
        throw contact::InputError(fmt::format(
            "{}: contact is lost at phase {:.4g}, and nothing holds the tangential load or shift "
            "any more; pull less, or take it back before",
            unattracted_->name(), step.phase));
    record.offset = step.offset;
    record.released_energy += stored();
    unattracted_->release();
}

}  // namespace tricontact::mdr
