#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "contact/surface_model.h"

namespace tricontact::fem {

/// A body between two plates that are not alike, pressed without friction. The lower contact is the
/// contact of the model: force, depth, surface. Depths are those of either plate to the mean of the
/// body's middle plane. Both contacts carry the same force; each is pressed on the surface that the
/// pressures of the other leave it, one after the other until that surface stands still.
class PlatesModel final : public contact::Model {
  public:
    /// On points that are those of both contacts.
    struct Compliances {
        std::shared_ptr<const contact::Compliance> lower, upper;
        /// Displacement at one contact by the pressures of the other.
        std::shared_ptr<const contact::Compliance> across;
    };
    struct Setup {
        std::string name;
        std::shared_ptr<const contact::Indenter> body;
        std::shared_ptr<const contact::FrictionLaw> friction;
        double tolerance = 0;  ///< see contact::StaggeredSolver
        contact::Case::Contact options = {};
        double shear_modulus = 0;  ///< of a body of revolution, see ModelOfRevolution [Pa]; else 0
        /// On a patch so many times as wide as the first. Throws contact::InputError.
        std::function<Compliances(double growth)> compliances = {};
        double growth = 1;  ///< of the patch when a contact reaches its edge
    };

    explicit PlatesModel(Setup setup);
    ~PlatesModel() override;

    std::string name() const override { return setup_.name; }
    double step_accuracy() const override { return setup_.tolerance; }
    contact::StepRecord advance(const contact::LoadStep& step) override;
    void release() override;
    void enlarge(const contact::ContactAtEdge& reached) override;
    contact::Scales scales() const override;
    /// The indentation is that of the upper plate.
    std::optional<contact::Scales> upper_scales() const override;
    contact::Surface surface() const override;
    std::vector<contact::ContactState> contact_states() const override;
    double limit_tangential_ratio() const override;
    void start_limit() override;
    std::unique_ptr<contact::Model> sibling(const contact::Case::Contact& options) const override;
    std::string write_state() const override;
    void read_state(std::string_view bytes) override;
    /// Of both contacts.
    const contact::Audit& audit() const override { return audit_; }

  private:
    class Side;

    PlatesModel(Setup setup, Compliances compliances);
    void make_sides();
    /// What both contacts have under a step.
    struct Pressed {
        contact::StepRecord lower, upper;
        double change = 0;  ///< the most that the pressures of one moved the surface of the other
    };
    Pressed press(const contact::LoadStep& step);
    void note(const Pressed& pressed);
    double shared_energy() const;

    Setup setup_;
    double room_ = 1;  // of the patch, over the first
    Compliances compliances_;
    std::unique_ptr<Side> lower_, upper_;
    contact::Audit audit_;
};

}  // namespace tricontact::fem
