#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "comparisons/quantities/quantity.h"
#include "contact/case.h"

namespace tricontact::atlas {

/// What maps are multiples of: closed forms of the uncoupled half-space at the same amplitude over
/// the contact's own radius, and the same load beside its own limit. What is left is smooth and of
/// the order of 1, and has the limits of small amplitudes and loads built in.
class Baseline {
  public:
    /// On the half-space; NaN where the keys say nothing of them.
    struct Point {
        double w = 0;      ///< W/a
        double f = 0;      ///< F_T/(mu F_N)
        double limit = 0;  ///< f_T,lim
        double u_stat = 0, u_sd = 0;
        double excess = 0;  ///< w - w_lim
    };

    /// None: all closed forms are 1.
    Baseline() = default;
    /// Of the case that is varied over these keys; without closed forms for a body that is no
    /// paraboloid, sphere or cylinder, and where w is no ratio to the model's own radius.
    Baseline(const contact::Case& base, const std::vector<std::string>& keys);

    /// At these values of the keys.
    Point at(std::span<const double> values) const;
    /// The closed form of a dimensionless quantity at the point: 1 if there is none.
    static double of(const comparisons::Quantity& q, const Point& point);
    /// What `of` is, in symbols: "MDR's u_sd", empty if it is 1.
    static std::string name_of(const comparisons::Quantity& q);

  private:
    enum class Load { none, ratio, fraction, excess };
    /// Place among the keys, or the value of the case.
    struct Source {
        std::optional<std::size_t> place;
        double value = 0;
        double at(std::span<const double> values) const { return place ? values[*place] : value; }
    };

    double load_ratio(double limit, double load) const;
    void add_round(Point& p) const;
    void add_line(Point& p) const;

    bool is_line_ = false;
    double lambda_ = 0;  // line_shift_factor of the case that is varied
    Source w_, load_;
    Load kind_ = Load::none;
};

}  // namespace tricontact::atlas
