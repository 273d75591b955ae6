#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "comparisons/quantities/quantity.h"
#include "contact/case.h"
#include "theory/rolling/mapped_shakedown.h"

namespace tricontact::atlas {

/// What maps are multiples of: formulas of the contact at the same amplitude over its own radius,
/// and the same load beside its own limit (docs/explanation/atlas-formulas.md). What is left is
/// smooth and of the order of 1, and has the limits of small amplitudes and loads built in.
class Baseline {
  public:
    /// NaN where the keys say nothing of it.
    struct Point {
        double w = 0;      ///< W/a
        double f = 0;      ///< F_T/(mu F_N), or over F_lim of another law
        double limit = 0;  ///< f_T,lim
        double u_stat = 0, u_sd = 0, mapping = 0;
        double increment = 0;  ///< what Delta u is a multiple of: w - w_lim, or a formula for it
        double slope = 0;      ///< the formula over w - w_lim
    };

    /// None: all formulas are 1.
    Baseline() = default;
    /// Of the case that a model is computed for over these keys; without formulas for a body that
    /// is no paraboloid, sphere or cylinder, and where w is no ratio to the model's own radius.
    /// Under a shear strength there are formulas of the paraboloid on a half-space only.
    Baseline(const contact::Case& base, const std::string& model,
             const std::vector<std::string>& keys);

    /// At these values of the keys.
    Point at(std::span<const double> values) const;
    /// The formula of a dimensionless quantity at the point: 1 if there is none.
    double of(const comparisons::Quantity& q, const Point& point) const;
    /// What `of` is, in words: "w - w_lim", empty if it is 1.
    std::string name_of(const comparisons::Quantity& q) const;

  private:
    /// In the order of the formulas' names; the last two under a shear strength.
    enum class Body {
        none,
        springs,
        round,
        round_layer,
        line,
        line_layer,
        strong_springs,
        strong_round
    };
    enum class Load { ratio, fraction, excess };
    /// Place among the keys, or the value of the case.
    struct Source {
        std::optional<std::size_t> place{};
        double value = 0;
        double at(std::span<const double> values) const { return place ? values[*place] : value; }
    };
    struct Formula {
        const comparisons::Quantity* quantity;
        double Point::*value;
        std::array<const char*, 7> names;  ///< from Body::springs on; null: none
    };
    static const Formula formulas[];

    const Formula* find(const comparisons::Quantity& q) const;
    const char* name(const Formula& formula) const;
    double load_ratio(double limit, double load) const;
    void add_round(Point& p, std::span<const double> values) const;
    void add_strong(Point& p, std::span<const double> values) const;
    theory::MappedRolling mapped(const Point& p, std::span<const double> values) const;
    bool is_strong() const { return body_ >= Body::strong_springs; }
    void add_layer(Point& p, std::span<const double> values) const;
    void add_line(Point& p, double lambda) const;
    double line_lambda(std::span<const double> values) const;

    Body body_ = Body::none;
    double lambda_ = 0;  // line_shift_factor of the case that is varied
    Source w_, load_, angle_, poisson_, thickness_, friction_;
    Load kind_ = Load::ratio;
};

}  // namespace tricontact::atlas
