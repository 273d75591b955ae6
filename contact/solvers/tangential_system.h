#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "contact/base/vector2.h"
#include "contact/compliances/active_operator.h"
#include "contact/compliances/blocks.h"
#include "contact/compliances/compliance.h"

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

    bool is_plane() const { return parts_.empty(); }
    Tilt among(const std::vector<std::size_t>& points) const;

    Vector2 apply(std::size_t i, const Vector2& v) const {
        if (parts_.empty()) return v;
        const auto& [xx, xy, yy] = parts_[i];
        return {xx * v[0] + xy * v[1], xy * v[0] + yy * v[1]};
    }

  private:
    std::vector<std::array<double, 3>> parts_;
};

/// The Newton system of frictional contact for given stick and slip zones, on tangential fields
/// among the points in contact, which have an entry for each of these. Sticking points have two
/// unknowns; slipping ones move along the tangent of their friction disc only:
///   P A z + D z - C dU = r,   C' z = c,
/// P the projection onto the admissible directions, D = (s.e)/bound on slipping points (the
/// curvature of the disc), C the total forces in the force-controlled directions. Points that flow
/// have two unknowns too, and in D a part along their traction as well.
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
        TangentialField a_z;        ///< A z [m], not projected
        Vector2 shift_increment{};  ///< dU [m], zero in shift-controlled directions
        int iterations = 0;         ///< applications of the compliance
    };

    /// `active`: indices of the points in contact; `products`: the compliance among them.
    TangentialSystem(const Compliance& compliance, const std::vector<std::size_t>& active,
                     const ActiveOperator& products, std::array<bool, 2> force_controlled,
                     Tilt tilt = {});

    /// What stands per active point: whether it slips, and if so the unit tangent of its friction
    /// disc and the curvature D [m/Pa]. What flows does not slip and has D along its traction in
    /// `radial` > 0 [m/Pa] (empty: nothing flows), tangent and curvature; `along`: by what that
    /// part of its residual counts in the r.m.s., 0: as the local compliance beside a layer's.
    struct Zones {
        std::vector<std::uint8_t> slipping;
        std::vector<Vector2> tangent;
        std::vector<double> curvature, radial;
        double along = 1;
    };
    /// False if the force balance is singular on these zones.
    bool set_zones(Zones zones);

    /// `r` [m], `c` [N]: right-hand sides. The result stays valid until the next call.
    const Result& solve(const TangentialField& r, const Vector2& c, const Limits& limits);

  private:
    Vector2 projected(std::size_t k, const Vector2& f) const {
        return zones_.slipping[k] ? dot(zones_.tangent[k], f) * zones_.tangent[k] : f;
    }
    bool flows(std::size_t k) const { return !zones_.radial.empty() && zones_.radial[k] > 0; }
    /// Along the tangent and across it, each times a factor.
    Vector2 stretched(std::size_t k, const Vector2& f, double along, double across) const {
        const Vector2 part = dot(zones_.tangent[k], f) * zones_.tangent[k];
        return along * part + across * (f - part);
    }
    Vector2 scaled(std::size_t k, const Vector2& f) const {
        return flows(k) ? stretched(k, f, scaling_[k], radial_scaling_[k]) : scaling_[k] * f;
    }
    Vector2 resisted(std::size_t k, const Vector2& f) const {
        return flows(k) ? stretched(k, f, zones_.curvature[k], zones_.radial[k])
                        : zones_.curvature[k] * f;
    }
    void find_layer();
    void precondition(const TangentialField& r, TangentialField& z);
    void precondition_under_layer(const TangentialField& r, TangentialField& z);
    double inner(const TangentialField& a, const TangentialField& b) const;
    Vector2 total(const TangentialField& z) const;
    Vector2 constraint_multiplier(const Vector2& total_force) const;

    void start(const TangentialField& r);
    void carry(const Vector2& c);
    void apply();
    void move(double step);
    void turn(double beta);
    void precondition_balanced();
    double rms_residual() const;

    const double local_;  // see Compliance::local_tangential [m/Pa]
    const ActiveOperator& products_;
    const Blocks points_;
    std::array<bool, 2> force_controlled_;
    Tilt tilt_;
    std::vector<double> areas_;  // of the active points [m^2]
    double area_ = 0;            // their sum
    Zones zones_;
    std::vector<double> scaling_, radial_scaling_;
    std::optional<LayerCompliance> layer_;           // mean of what flows, if products know layers
    bool all_move_ = false;                          // no point sticks
    std::array<TangentialField, 2> constraint_;      // C
    std::array<TangentialField, 2> preconditioned_;  // M^-1 C
    std::array<std::array<double, 2>, 2> schur_inverse_{};
    // Work space of the iteration.
    Result result_;
    TangentialField residual_, direction_, a_direction_, h_direction_, z_, scaled_, under_layer_;
};

}  // namespace tricontact::contact
