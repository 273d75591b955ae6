#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace tricontact::experiments {

/// A number of a rig that is to be found.
struct FreeParameter {
    /// In which it is searched and, between its bounds, as likely beforehand everywhere: ln v,
    /// low/v, v, or v over its `size` where it has either sign or may be zero.
    enum class Scale { logarithmic, reciprocal, linear, either_sign, from_zero };

    std::string key;        ///< of the case: "substrate.young"
    std::size_t index = 0;  ///< of a list's element
    std::string name;       ///< of files: "young_Pa"
    std::string symbol;     ///< "E"
    std::string unit = {};  ///< "Pa"; empty: a pure number
    Scale scale = Scale::logarithmic;
    /// Looked at between these [SI], positive; linear: low may be 0, from_zero: it is; of either
    /// sign: all but bounds.
    double low = 0, high = 0;
    double start = 0;  ///< a guess [SI]
    double size = 0;   ///< [SI] what a parameter of either sign, or from zero, is large against
    /// From which the search starts as well [SI].
    std::vector<double> further_starts = {};

    double coordinate(double value) const;
    double value(double coordinate) const;
    /// What a relative change of 1 is [SI]: v, so that relative ones are those of ln v; `size`
    /// where v has either sign or may be zero.
    double unit_of_change(double value) const;
    /// Of the coordinate by relative change.
    double slope(double value) const;
    /// Relative change from a value to another one, and the value that is as far from the first.
    double change(double from, double to) const;
    double changed(double from, double change) const;
    /// Least and largest coordinate.
    double least() const;
    double largest() const;
    /// Whether the bounds are some.
    bool has_range() const;
    /// Its coordinate is v over `size`.
    bool is_sized() const { return scale == Scale::either_sign || scale == Scale::from_zero; }
    /// At a bound, to 1e-6 of the range of coordinates.
    bool is_at_bound(double value) const;
    /// "4.20 MPa", "0.570".
    std::string shown(double value) const;
    /// "4.20 MPa (4.11 MPa to 4.29 MPa)", with as many digits as tell the ends apart.
    std::string shown(double value, double low, double high) const;
};

/// Young's modulus [Pa], from this to that part of the start.
FreeParameter young_parameter(double start);
/// Coefficient of friction: the largest F_T/F_N of the observations held, so it is not less.
FreeParameter friction_parameter(double largest_force_ratio);

std::vector<double> coordinates_of(const std::vector<FreeParameter>& parameters,
                                   const std::vector<double>& values);
std::vector<double> values_of(const std::vector<FreeParameter>& parameters,
                              const std::vector<double>& coordinates);

}  // namespace tricontact::experiments
