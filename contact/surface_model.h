#pragma once

#include <map>
#include <memory>
#include <tuple>

#include "contact/compliance.h"
#include "contact/indenter.h"
#include "contact/model.h"
#include "contact/normal_solver.h"
#include "contact/tangential_solver.h"

namespace tricontact::contact {

/// The contact reached the edge of the points that the compliance knows.
class ContactAtEdge : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Contact of an indenter over any compliance, with Coulomb friction, in world-fixed coordinates:
/// surface points keep their displacement when the indenter rolls away from them.
class SurfaceModel final : public Model {
  public:
    /// `tolerance` [-]: of the tangential solver; the normal solver gets a tenth of it.
    SurfaceModel(std::string name, std::unique_ptr<Compliance> compliance,
                 std::unique_ptr<Indenter> indenter, double friction_coefficient, double tolerance);

    std::string name() const override { return name_; }
    StepRecord advance(const LoadStep& step) override;
    Scales scales() const override;
    Surface surface() const override;
    double limit_tangential_ratio() const override;
    void start_limit() override;
    const Audit& audit() const override { return audit_; }

  private:
    using Key = std::tuple<Vector2, NormalControl::Kind, double>;  // offset and normal control

    const NormalSolution& solve_normal(const LoadStep& step, bool& reused);
    void solve_tangential(const LoadStep& step);
    void update_slip(const TangentialField& displacement_before);
    double elastic_energy() const;
    StepRecord record(const LoadStep& step, bool normal_reused) const;
    void audit_step(const LoadStep& step, const TangentialField& traction_before,
                    const TangentialField& displacement_before, double energy_before);

    std::string name_;
    std::unique_ptr<Compliance> compliance_;
    std::unique_ptr<Indenter> indenter_;
    double friction_coefficient_;
    double tolerance_;
    NormalSolver normal_solver_;
    TangentialSolver tangential_solver_;

    Vector2 offset_{};
    Vector2 shift_{};
    std::shared_ptr<const NormalSolution> normal_;
    std::map<Key, std::shared_ptr<const NormalSolution>> normal_cache_;
    std::vector<double> bound_;  // mu p [Pa]
    TangentialSolution tangential_;
    TangentialField slip_;  // of the last step [m]
    std::vector<ContactState> contact_state_;
    std::vector<double> least_pressure_;  // since start_limit()
    double least_pressure_force_ = 0;     // F_N at start_limit()
    Audit audit_;
};

}  // namespace tricontact::contact
