#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "contact/base/memory.h"
#include "contact/base/vector2.h"
#include "contact/compliances/interior.h"

namespace tricontact::contact {

/// A tangential vector per contact point, by component.
struct TangentialField {
    std::vector<double> x, y;

    TangentialField() = default;
    /// Zeros, first touched by so many threads.
    explicit TangentialField(std::size_t n, int n_threads = 1)
        : x(large_field(n, n_threads)), y(large_field(n, n_threads)) {}
    TangentialField(const TangentialField& other)
        : x(large_copy(other.x)), y(large_copy(other.y)) {}
    TangentialField& operator=(const TangentialField& other) {
        copy_large(other.x, x);
        copy_large(other.y, y);
        return *this;
    }
    TangentialField(TangentialField&&) = default;
    TangentialField& operator=(TangentialField&&) = default;
    ~TangentialField() = default;
    std::size_t size() const { return x.size(); }
    Vector2 at(std::size_t i) const { return {x[i], y[i]}; }
    void set(std::size_t i, const Vector2& value) {
        x[i] = value[0];
        y[i] = value[1];
    }
};

/// Where tractions act and displacements are read. On a grid x runs fastest.
struct ContactPoints {
    std::vector<double> x, y;    ///< positions on the substrate [m]
    std::vector<double> area;    ///< tributary areas [m^2]
    int n_x = 0, n_y = 0;        ///< > 0 on a regular grid
    Vector2 first{}, spacing{};  ///< of a regular grid [m]
    /// Points with y >= 0 that stand for their mirror images at -y as well: areas count both
    /// sides, x and normal components are even in y, y components odd (zero at y = 0). Of a grid
    /// the first row is that at y = 0.
    bool mirrored = false;
    /// A grid of one period of a surface that has no edge.
    bool periodic = false;
    /// A grid between whose points pressures are bilinear: areas are those of these functions.
    bool bilinear = false;
    /// Length L along y [m] of a contact that the outermost points in y bound, since the indenter
    /// or the substrate ends there; 0: it may go on beyond them.
    double line_length = 0;
    /// The body that presses ends at the outermost points along x: a contact that reaches them is
    /// whole.
    bool is_whole_face = false;
    /// Displacement along over displacement into the surface by equal tractions on a place alone,
    /// E*/G*, where the response of one point does not tell it, as of a node of elements; 0: it
    /// does.
    double local_ratio = 0;
    /// On the springs of an elastic interface: pressures need not end as a root at the edge.
    bool on_springs = false;
    /// Nine-node quadrilaterals between the points where the surface is one of elements (corners,
    /// edges, centre; VTK's order of a biquadratic quadrilateral); else empty.
    std::vector<std::array<int, 9>> quads;

    std::size_t size() const { return x.size(); }
    /// Regular grid of n_x * n_y cells; `first` is the centre of the first one.
    static ContactPoints grid(int n_x, int n_y, Vector2 first, Vector2 spacing);
    /// The same on y >= 0, the first row at y = 0, mirrored.
    static ContactPoints mirrored_grid(int n_x, int n_y, double first_x, Vector2 spacing);
};

class ActiveOperator;
class NormalGrid;

/// The linear elasticity of both bodies as seen from the contact surface: tractions [Pa] on the
/// contact points give displacements [m] of the substrate relative to the indenter. Self-adjoint
/// and positive definite in the inner product weighted by the points' areas. One caller at a time:
/// products of a const object share its scratch, which on large grids is most of a run's memory.
/// Several threads take a model each.
class Compliance {
  public:
    virtual ~Compliance() = default;

    virtual const ContactPoints& points() const = 0;
    /// That loops over all points are worth.
    virtual int n_threads() const { return 1; }
    /// Normal traction displaces tangentially and vice versa.
    virtual bool is_coupled() const = 0;

    /// Displacement into the substrate under the pressure p.
    virtual void normal(std::span<const double> p, std::span<double> u_z) const = 0;
    /// `normal` of a grid large enough for NormalNewton; null of others.
    virtual const NormalGrid* normal_grid() const { return nullptr; }
    /// Displacement in the surface under the tangential traction t on the substrate.
    virtual void tangential(const TangentialField& t, TangentialField& u) const = 0;
    /// The coupling: displacement in the surface under the pressure p, and displacement into the
    /// substrate under the tangential traction t; one is the other's adjoint. None by default.
    virtual void tangential_from_normal(std::span<const double>, TangentialField& u) const {
        u = TangentialField(points().size());
    }
    virtual void normal_from_tangential(const TangentialField&, std::span<double> u_z) const {
        std::fill(u_z.begin(), u_z.end(), 0.0);
    }
    /// Displacement of a point under unit traction on its own area alone, a typical value [m/Pa].
    virtual double local_tangential() const = 0;
    /// A symmetric positive definite approximation of the inverse of `tangential`; its scale is
    /// free.
    virtual void precondition_tangential(const TangentialField& r, TangentialField& z) const = 0;
    /// Products among these points alone, where they cost less than those among all; else null.
    virtual std::unique_ptr<const ActiveOperator> among(
        const std::vector<std::size_t>& active) const;
    /// The whole matrix, displacement [m] over force (traction times area) [N]: 3n x 3n by columns,
    /// symmetric, component c of point i at c n + i (x, y, into the substrate); null where only
    /// products are known.
    virtual const double* dense() const { return nullptr; }
    /// Tractions by the consistent mass of an element surface instead of the points' areas; empty
    /// where there are no elements. `odd_in_y`: of a y component.
    virtual std::vector<double> consistent_traction(std::span<const double>,
                                                    [[maybe_unused]] bool odd_in_y) const {
        return {};
    }
    /// Force of the ground [N] plus the force of these tractions (z out of the substrate), zero but
    /// for errors; null where there is no ground.
    virtual std::optional<std::array<double, 3>> missing_reaction(std::span<const double>,
                                                                  const TangentialField&) const {
        return {};
    }
    /// What missing_reaction may be over the force, for the rounding of a stiff material.
    virtual double allowed_missing_reaction() const { return 1e-8; }
    /// What the body looks like inside under these tractions [Pa]; null if unavailable.
    virtual std::unique_ptr<const Interior> interior(std::span<const double>,
                                                     const TangentialField&) const {
        return nullptr;
    }
};

/// A weighted sum of compliances on the same contact points.
class CombinedCompliance final : public Compliance {
  public:
    using Parts = std::vector<std::shared_ptr<const Compliance>>;

    /// Weights are zero at first. Not `coupled`: the parts' coupling is left out.
    CombinedCompliance(Parts parts, bool coupled);

    void set_weights(std::vector<double> weights) {
        weights_ = std::move(weights);
        matrix_.clear();
    }
    const std::vector<double>& weights() const { return weights_; }

    const ContactPoints& points() const override { return parts_.front()->points(); }
    int n_threads() const override { return parts_.front()->n_threads(); }
    bool is_coupled() const override { return coupled_; }
    void normal(std::span<const double> p, std::span<double> u_z) const override;
    void tangential(const TangentialField& t, TangentialField& u) const override;
    void tangential_from_normal(std::span<const double> p, TangentialField& u) const override;
    void normal_from_tangential(const TangentialField& t, std::span<double> u_z) const override;
    double local_tangential() const override;
    void precondition_tangential(const TangentialField& r, TangentialField& z) const override;
    /// A single part's, where it stands for the sum.
    std::unique_ptr<const ActiveOperator> among(
        const std::vector<std::size_t>& active) const override;
    const double* dense() const override;
    std::vector<double> consistent_traction(std::span<const double> t,
                                            bool odd_in_y) const override {
        return parts_.front()->consistent_traction(t, odd_in_y);
    }
    /// The worst of the parts', by component.
    std::optional<std::array<double, 3>> missing_reaction(std::span<const double> p,
                                                          const TangentialField& t) const override;
    double allowed_missing_reaction() const override;

  private:
    template <class Displace>
    void sum_down(std::span<double> u_z, bool any, Displace displace) const;
    template <class Displace>
    void sum_in_surface(TangentialField& u, bool any, Displace displace) const;

    Parts parts_;
    bool coupled_;
    std::vector<double> weights_;
    mutable std::vector<double> matrix_;  // as dense() says, when it was asked for
};

}  // namespace tricontact::contact
