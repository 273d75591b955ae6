#pragma once

#include <cstddef>
#include <deque>
#include <vector>

#include "contact/surface_model.h"
#include "contact/wearing_contact.h"

namespace tricontact::contact {

/// Wear of a contact over any compliance, point by point.
///
/// A jump over n cycles takes the slips s_i of the last cycle and closes the gap
///   h_i + w_i + n e_i + n kappa s_i p_i + u_i(p) - d
/// under new pressures p: to the normal contact, wear is a spring of the compliance n kappa s_i at
/// each point. e_i is what the measured rate differs by from kappa s_i p_i of the present profile,
/// where pressures change within the cycle.
///
/// Of an indenter that rolls, where the same points of both bodies meet again and again, and of one
/// whose normal load changes in uncoupled contact, a jump takes the steps of the cycle one after
/// the other, each for all its n cycles with its own slips, load and place of the indenter: stable,
/// and of the first order in n as well.
class SurfaceWearing final : public WearingContact {
  public:
    /// Throws InputError where the indenter rolls in coupled contact.
    SurfaceWearing(SurfaceModel& model, WearProblem problem);

    const std::vector<double>& area() const override { return model_.points().area; }
    WornCycle cycle(const std::vector<double>& worn) override;
    std::vector<double> jump(const std::vector<double>& worn, const WornCycle& now,
                             double n) override;
    void enlarge(const ContactAtEdge& reached) override;
    Surface surface() const override { return model_.surface(); }
    std::vector<double> on_surface(const std::vector<double>& field) const override;
    std::vector<std::size_t> line() const override;
    double x(std::size_t point) const override { return model_.points().x[point]; }

  private:
    struct Slipped;
    /// What one part of a cycle wears, which may be all of it: per point.
    struct Part {
        LoadStep step;
        std::vector<double> slip, rate, pressure;  // [m], [m] worn, [Pa]
    };
    /// Of a cycle whose pressures change, its steps.
    struct RolledCycle {
        std::vector<double> worn;
        std::vector<Part> steps;
    };
    void add_step(const LoadStep& step, Slipped& sums);
    void require_sound() const;
    double wear_factor() const;
    std::vector<double> worn_by(const std::vector<double>& worn, const Part& part, double kappa,
                                double n);
    const std::vector<Part>& steps_of(const std::vector<double>& worn);
    std::vector<double> heights_at(const Vector2& offset) const;
    Model& driven() { return problem_.driven_by ? *problem_.driven_by : model_; }

    SurfaceModel& model_;
    WearProblem problem_;
    bool by_steps_;                   // jumps are those of the steps of a cycle
    std::vector<double> heights_;     // without wear, at the end of the cycle; empty: not known
    std::deque<RolledCycle> recent_;  // the last two, which jumps begin from
};

}  // namespace tricontact::contact
