#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "contact/base/error.h"
#include "contact/compliances/interior.h"
#include "contact/history.h"
#include "contact/load_path.h"
#include "contact/surface.h"

namespace tricontact::contact {

/// A model of the contact: remembers its state and takes quasi-static steps.
class Model {
  public:
    virtual ~Model() = default;

    virtual std::string name() const = 0;
    /// Takes the step and returns its record. Throws NotConverged, ContactAtEdge.
    virtual StepRecord advance(const LoadStep& step) = 0;
    /// Normal and tangential contact influence each other: the way of pressing matters.
    virtual bool is_coupled() const { return false; }
    /// Accuracy of its steps [-], which bounds how well its periods repeat each other: that of the
    /// solver, of rounding where steps are exact.
    virtual double step_accuracy() const { return 1e-7; }
    /// Forgets all steps: the indenter is out of contact, the substrate at rest.
    virtual void release() = 0;
    /// Begins anew, at rest, on a larger grid than that whose edge the contact has reached. Throws
    /// `reached` where there is none, InputError where it would be too large, NotConverged.
    virtual void enlarge(const ContactAtEdge& reached) { throw reached; }
    /// A period of rolling begins: Surface::slip_path and friction_work are summed up from here.
    virtual void start_period() {}
    /// Scales of the present normal state.
    virtual Scales scales() const = 0;
    /// Of a body between two plates that are not alike: likewise of the contact with the upper one,
    /// the other being the contact of the model; empty of all others.
    virtual std::optional<Scales> upper_scales() const { return {}; }
    /// Of surfaces that attract each other; empty: not known.
    virtual std::optional<PullOff> pull_off() const { return {}; }
    /// Fields of the present state.
    virtual Surface surface() const = 0;
    /// What every point did in the last step, also where `surface` is thinned out.
    virtual std::vector<ContactState> contact_states() const { return surface().contact_state; }
    /// What friction carries at the least pressures, the minimum taken over all states since
    /// `start_limit`, over what it carries at `start_limit`: under Coulomb's law (1/F_N) ∫ min p
    /// dA, the exact shakedown limit of F_T/(mu F_N) in uncoupled contact.
    virtual double limit_tangential_ratio() const = 0;
    virtual void start_limit() = 0;
    /// The inside of the substrate in the present state; null where the model does not know it.
    virtual std::unique_ptr<const Interior> interior() { return nullptr; }
    /// Another model over the same elasticity, which is shared, at rest and with other `options`;
    /// null where there are no such options.
    virtual std::unique_ptr<Model> sibling(const Case::Contact&) const { return nullptr; }
    /// The present state as bytes, for a run that is to go on after a kill; empty: not supported.
    /// A model that reads all states of a run in their order goes on as that run would have.
    virtual std::string write_state() const { return {}; }
    virtual void read_state(std::string_view) {}
    /// Checks of all solutions so far.
    virtual const Audit& audit() const = 0;
};

}  // namespace tricontact::contact
