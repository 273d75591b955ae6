#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "atlas/baseline.h"
#include "contact/case.h"
#include "io/case/study_reader.h"
#include "statistics/polynomial_fit.h"

namespace tricontact::atlas {

/// A coordinate outside the atlas: nothing is said there.
class OutsideDomain : public std::domain_error {
  public:
    using std::domain_error::domain_error;
};

/// A key of case files over which the maps go, in its SI unit.
struct Axis {
    Axis(std::string its_key, const io::Study::Range& its_range)
        : key(std::move(its_key)), range(its_range), from(range.from), to(range.to) {}

    std::string key;         ///< "rolling.amplitude_ratio"
    io::Study::Range range;  ///< how its coordinate in [-1, 1] follows from the value
    /// Where the maps say something: all of the range, but for ends at which quantities are
    /// undefined at some points of the study.
    double from, to;

    double tolerance() const { return 1e-9 * (range.to - range.from); }  ///< of rounding at an end
    bool is_inside(double value) const {
        return value >= from - tolerance() && value <= to + tolerance();
    }
};

/// One quantity over the axes.
struct Map {
    const comparisons::Quantity* quantity = nullptr;
    bool is_logarithmic = true;  ///< the fit is that of ln(quantity/baseline), else of the quotient
    /// Of what the finest runs gave, with its error from points left out of the fit.
    statistics::PolynomialFit fit;
    /// From the finest runs to no mesh and no steps, by Richardson's rule from the next coarser
    /// ones; added to the fit. Atlas::safety_factor times its amount is the numerical error. No
    /// terms if nothing tells it.
    statistics::SparsePolynomial correction;
    std::size_t n_points = 0;  ///< where the quantity is defined
};

/// A value with the half width of its bar of 95 %: interpolation and numerical error together.
struct Value {
    double value, error;

    double standard_error() const { return error / 1.96; }
};

/// Results of a model over keys of its case, computed at some points and interpolated between them
/// by sparse sums of Chebyshev polynomials. Dimensionless: of a quantity with a unit the map is its
/// quotient by the closed form of the half-space.
struct Atlas {
    std::string name;  ///< of its study
    std::string title;
    std::string model;         ///< that of a run: "bem"
    std::string version;       ///< of the program that computed it
    std::string numerics;      ///< digest of the sources that its numbers depend on
    std::string digest;        ///< of its points and their results
    std::string study;         ///< the text of its study
    std::string base;          ///< the resolved text of the case that the study varies
    double largest_error = 1;  ///< of a value over it: beyond it is outside the domain
    double safety_factor = 1;  ///< what bars count of the correction for cells and steps
    std::size_t n_points = 0, n_failed = 0;  ///< of the study; points without results
    std::vector<Axis> axes;
    std::vector<Map> maps;
    Baseline baseline;
    contact::Case kept;  ///< the resolved case: values of the keys that are no axes

    /// Null if it has none of it.
    const Map* find(const comparisons::Quantity& q) const;
    /// Null if it does not go over this key.
    const Axis* axis(std::string_view key) const;
    /// [SI] of a key that is no axis; NaN if the case has no such number.
    double kept_value(std::string_view key) const;
};

/// Whether the maps say something at one coordinate per axis.
bool is_inside(const std::vector<Axis>& axes, std::span<const double> coordinates);

/// The point of [-1, 1]^n of one coordinate per axis, which are taken into the domain.
std::vector<double> unit_coordinates(const Atlas& atlas, std::span<const double> coordinates);

/// The maps of an atlas at one point after another. Keeps a table; not for two threads at once.
class Reader {
  public:
    /// The atlas stays with the caller.
    explicit Reader(const Atlas& atlas);

    /// One coordinate per axis, in SI units. Throws OutsideDomain, naming axis and range;
    /// std::invalid_argument for another number of coordinates.
    void go_to(std::span<const double> coordinates);
    /// Of one of the atlas' maps, there. NaN with its bar where that is longer than
    /// Atlas::largest_error allows.
    Value read(const Map& map) const;
    /// Goes to the coordinates and reads; what errors of the first ones do to the value adds to its
    /// bar. Throws as go_to.
    Value read_with_errors(const Map& map, std::vector<double> coordinates,
                           std::span<const double> errors);

  private:
    const Atlas& atlas_;
    statistics::ChebyshevTable table_;
    std::vector<double> unit_;
    Baseline::Point point_{};
};

/// A value that a map has; throws OutsideDomain, naming the map, for NaN where it says none.
Value said(const Atlas& atlas, const Map& map, const Value& value);

/// Reader::read_with_errors by a reader of its own, which takes ten times as long.
Value read_with_errors(const Atlas& atlas, const Map& map, std::vector<double> coordinates,
                       std::span<const double> errors);

/// Values of a map at many points, the coordinates of one after those of the other; NaN outside the
/// domain, and where a bar is longer than Atlas::largest_error allows. Several times faster per
/// point than one by one, and equal to that but for rounding. Throws std::invalid_argument unless
/// the coordinates are whole points.
struct Values {
    std::vector<double> values, errors;
};
Values read_all(const Atlas& atlas, const Map& map, std::span<const double> points);

}  // namespace tricontact::atlas
