#pragma once

#include "contact/compliances/compliance.h"

namespace tricontact::contact {

/// A compliance that exposes its matrix, for a contact of few of its points. While it is focused
/// on some, tractions of all others are taken for zero, and normal displacements and the coupling
/// are those of these points alone, by gathered blocks that stay in the cache; elsewhere zero.
/// Tangential displacements are those of all points always.
class FocusedCompliance final : public Compliance {
  public:
    /// Focused on nothing: it is the same as `all`, which has to outlive it.
    explicit FocusedCompliance(const Compliance& all) : all_(all) {}

    void focus(std::vector<std::size_t> points);
    void focus_on_all() { is_focused_ = false; }
    /// To be told when `all` has changed: blocks stay as long as the points do. Focused on nothing.
    void forget() {
        is_focused_ = false;
        some_.clear();
    }
    bool is_focused() const { return is_focused_; }

    const ContactPoints& points() const override { return all_.points(); }
    bool is_coupled() const override { return all_.is_coupled(); }
    void normal(std::span<const double> p, std::span<double> u_z) const override;
    void tangential(const TangentialField& t, TangentialField& u) const override {
        all_.tangential(t, u);
    }
    void tangential_from_normal(std::span<const double> p, TangentialField& u) const override;
    void normal_from_tangential(const TangentialField& t, std::span<double> u_z) const override;
    double local_tangential() const override { return all_.local_tangential(); }
    void precondition_tangential(const TangentialField& r, TangentialField& z) const override {
        all_.precondition_tangential(r, z);
    }
    const double* dense() const override { return all_.dense(); }

  private:
    void gather_forces(std::span<const double> traction, std::size_t first) const;

    const Compliance& all_;
    bool is_focused_ = false;
    std::vector<std::size_t> some_;  // of the last focus, whose blocks are kept
    std::vector<double> normal_;     // lower triangle by columns, displacement over force [m/N]
    std::vector<double> coupled_;    // normal displacements over forces along x, then y, by columns
    mutable std::vector<double> force_, displacement_;
};

}  // namespace tricontact::contact
