#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "contact/solvers/compliance.h"
#include "contact/vector2.h"

namespace tricontact::contact {

/// How the surface's own directions at each point lie to the plane z = 0 in which the body is
/// shifted and forces are counted: D = E'[x y], E the two orthonormal directions of the tilted
/// surface, is symmetric where E is x and y turned by the shortest way. A rigid shift U moves the
/// point by D U along them, tractions t along them carry D t in the plane.
class Tilt {
  public:
    Tilt() = default;  ///< of a plane surface
    /// `slope` [-]: of the surface, per point.
    explicit Tilt(const TangentialField& slope);

    Vector2 apply(std::size_t i, const Vector2& v) const {
        if (parts_.empty()) return v;
        const auto& [xx, xy, yy] = parts_[i];
        return {xx * v[0] + xy * v[1], xy * v[0] + yy * v[1]};
    }

  private:
    std::vector<std::array<double, 3>> parts_;
};

/// The tangential compliance among the points in contact, for many products with tractions that
/// vanish elsewhere. Fields have an entry for each point of the compliance; only those of active
/// points are read.
class ActiveOperator {
  public:
    virtual ~ActiveOperator() = default;

    /// u = A t on the active points at least; on all points if `displaces_all`.
    virtual void apply(const TangentialField& t, TangentialField& u) const = 0;
    virtual bool displaces_all() const = 0;
    /// A symmetric positive definite approximation of the inverse of `apply`, up to a factor.
    virtual void precondition(const TangentialField& r, TangentialField& z) const = 0;
};

/// Gathered and factorised where the compliance exposes its matrix, else the compliance's products.
std::unique_ptr<const ActiveOperator> make_active_operator(const Compliance& compliance,
                                                           const std::vector<std::size_t>& active);

/// The Newton system of frictional contact for given stick and slip zones, on tangential fields
/// that vanish outside the contact. Sticking points have two unknowns; slipping ones move along the
/// tangent of their friction disc only:
///   P A z + D z - C dU = r,   C' z = c,
/// P the projection onto the admissible directions, D = (s.e)/bound on slipping points (the
/// curvature of the disc), C the total forces in the force-controlled directions.
class TangentialSystem {
  public:
    /// Conjugate gradients stop when the r.m.s. residual [m] is below both limits.
    struct Limits {
        double relative;  ///< to the first residual
        double absolute;  ///< [m]
        int iterations;
    };

    struct Result {
        TangentialField z;          ///< [Pa]
        TangentialField a_z;        ///< A z [m] on the active points, not projected
        Vector2 shift_increment{};  ///< dU [m], zero in shift-controlled directions
        int iterations = 0;         ///< applications of the compliance
    };

    /// `active`: indices of the points in contact; `products`: the compliance among them.
    TangentialSystem(const Compliance& compliance, const std::vector<std::size_t>& active,
                     const ActiveOperator& products, std::array<bool, 2> force_controlled,
                     Tilt tilt = {});

    /// What stands per active point: whether it slips, and if so the unit tangent of its friction
    /// disc and the curvature D [m/Pa]. False if the force balance is singular on these zones.
    bool set_zones(const std::vector<std::uint8_t>& slipping, std::vector<Vector2> tangent,
                   std::vector<double> curvature);

    /// `r` [m], `c` [N]: right-hand sides. The result stays valid until the next call.
    const Result& solve(const TangentialField& r, const Vector2& c, const Limits& limits);

  private:
    void project(TangentialField& f) const;
    void precondition(const TangentialField& r, TangentialField& z);
    void add(TangentialField& to, double factor, const TangentialField& from) const {
        for (const std::size_t i : active_) to.set(i, to.at(i) + factor * from.at(i));
    }
    double inner(const TangentialField& a, const TangentialField& b) const;
    Vector2 total(const TangentialField& z) const;
    Vector2 constraint_multiplier(const Vector2& total_force) const;

    void start(const TangentialField& r);
    void carry(const Vector2& c);
    void apply();
    void move(double step) {
        add(result_.z, step, direction_);
        add(result_.a_z, step, a_direction_);
        add(residual_, -step, h_direction_);
    }
    void turn(double beta) {
        for (const std::size_t i : active_) direction_.set(i, z_.at(i) + beta * direction_.at(i));
    }
    void precondition_balanced();
    double rms_residual() const { return std::sqrt(inner(residual_, residual_) / area_); }

    const Compliance& compliance_;
    const std::vector<std::size_t>& active_;
    const ActiveOperator& products_;
    std::array<bool, 2> force_controlled_;
    Tilt tilt_;
    double area_ = 0;  // of the active points [m^2]
    std::vector<std::uint8_t> slipping_;
    std::vector<Vector2> tangent_;
    std::vector<double> curvature_, scaling_;
    std::array<TangentialField, 2> constraint_;      // C
    std::array<TangentialField, 2> preconditioned_;  // M^-1 C
    std::array<std::array<double, 2>, 2> schur_inverse_{};
    // Work space of the iteration; large fields are allocated once.
    Result result_;
    TangentialField residual_, direction_, a_direction_, h_direction_, z_, scaled_, full_;
};

}  // namespace tricontact::contact
