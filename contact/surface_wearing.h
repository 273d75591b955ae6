#pragma once

#include <cstddef>
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
class SurfaceWearing final : public WearingContact {
  public:
    /// Throws InputError for a cycle that rolls.
    SurfaceWearing(SurfaceModel& model, WearProblem problem);

    const std::vector<double>& area() const override { return model_.points().area; }
    WornCycle cycle(const std::vector<double>& worn) override;
    std::vector<double> jump(const std::vector<double>& worn, const WornCycle& now,
                             double n) override;
    void enlarge(const ContactAtEdge& reached) override { model_.enlarge(reached); }
    Surface surface() const override { return model_.surface(); }
    std::vector<double> on_surface(const std::vector<double>& field) const override;
    std::vector<std::size_t> line() const override;
    double x(std::size_t point) const override { return model_.points().x[point]; }

  private:
    struct Slipped;
    void add_step(const LoadStep& step, Slipped& sums);
    void require_sound() const;
    std::vector<double> heights() const;

    SurfaceModel& model_;
    WearProblem problem_;
};

}  // namespace tricontact::contact
