#pragma once

#include <memory>
#include <span>
#include <vector>

#include "contact/compliances/cholesky.h"
#include "contact/compliances/compliance.h"

namespace tricontact::contact {

/// What a layer over the surface adds to the compliance at each point, a symmetric matrix [m/Pa].
struct LayerCompliance {
    double xx = 0, xy = 0, yy = 0;
    bool operator==(const LayerCompliance&) const = default;
};

/// The compliance among the points in contact, for many products with tractions that vanish
/// elsewhere. Fields have an entry for each of these points, in their order.
class ActiveOperator {
  public:
    virtual ~ActiveOperator() = default;

    /// u = A t.
    virtual void apply(const TangentialField& t, TangentialField& u) const = 0;
    /// The same for corrections of t: in single precision where that costs less.
    virtual void apply_roughly(const TangentialField& t, TangentialField& u) const { apply(t, u); }
    /// A symmetric positive definite approximation of the inverse of `apply`, up to a factor.
    virtual void precondition(const TangentialField& r, TangentialField& z) const = 0;
    /// The same, with that factor, of the compliance under a layer.
    virtual bool knows_layers() const { return false; }
    virtual void precondition_under(const LayerCompliance&, const TangentialField&,
                                    TangentialField&) const {}

    /// It knows the normal products too.
    virtual bool has_normal() const { return false; }
    virtual void normal(std::span<const double>, std::span<double>) const {}
    virtual void precondition_normal(std::span<const double>, std::span<double>) const {}
};

/// What one dense operator after the other works in: new memory for each costs as much as filling
/// it.
struct OperatorMemory {
    std::vector<double> lower;
    std::vector<float> rough;
    Cholesky<float> inverse;
};

/// Gathered and factorised where the compliance exposes its matrix, else the compliance's products.
/// `memory`: for this operator alone as long as it lives; null: its own.
std::unique_ptr<const ActiveOperator> make_active_operator(const Compliance& compliance,
                                                           const std::vector<std::size_t>& active,
                                                           OperatorMemory* memory = nullptr);

}  // namespace tricontact::contact
