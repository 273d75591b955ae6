#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/finite_strain/strain_threshold.h"
#include "comparisons/quantities/results.h"
#include "contact/bodies/elastic_body.h"
#include "contact/case.h"

namespace tricontact::comparisons {

/// Deviations from a half-space up to which the size of a contact is asked.
inline constexpr std::array<double, 3> size_tolerances{.01, .02, .05};

/// What of a body is compared with Hertz' half-space, and what both have in common: the depth or
/// the normal force. A half-space in plane strain has no depth of its own.
struct SizeMeasure {
    const Quantity* quantity;
    bool at_depth;
    const char* key;  ///< "normal_force_at_equal_depth"
    bool of_lines;    ///< known of cylinders
};
const std::vector<SizeMeasure>& size_measures();
/// "normal force F_N at equal depth"
std::string name_of(const SizeMeasure& measure);

/// A body that is pressed on a rigid plane.
struct SizedBody {
    contact::ElasticBody body;
    double poisson = 0;

    friend bool operator==(const SizedBody& a, const SizedBody& b) {
        return a.body.form == b.body.form && a.body.support == b.body.support &&
               a.body.hub_radius == b.body.hub_radius && a.poisson == b.poisson;
    }
};

/// Of a case whose body is in question.
struct SizeContact {
    contact::Case c;
    SizedBody own;
    double size = 0;  ///< a/R of Hertz' contact at the case's own load

    bool is_line() const { return c.is_line_contact(); }
    /// The model of sections by which bodies are computed.
    const char* model() const;
};

/// The contact of a case. Throws contact::InputError for one that is not offered: no body, a
/// punch, a substrate that deforms, no Hertz' contact.
SizeContact size_contact(const contact::Case& c);

/// One run: the load is that under which Hertz' contact has this radius.
struct SizeRun {
    SizedBody body;
    double size = 0;  ///< a/R of Hertz
    int level = 0;    ///< 0: 16 elements in a; 1: 32
};

/// The case's body at its own load and over a/R; a ball beside a hemisphere or the other way round,
/// or hubs of other radii; the case's body with other Poisson's ratios. Each on two meshes.
std::vector<SizeRun> size_runs(const SizeContact& contact);

/// The case of a run; sizes that are too large for the section are none of size_runs().
contact::Case size_case(const SizeContact& contact, const SizeRun& run);

/// A ratio, body over Hertz' half-space.
struct SizePoint {
    double size = 0;  ///< a/R of Hertz at this depth or force
    double ratio = 1;
    double error = 0;  ///< half width: what the coarser mesh is off
    bool own = false;  ///< at the case's own load
};

struct SizeCurve {
    SizedBody body;
    std::map<const SizeMeasure*, std::vector<SizePoint>> points;  ///< size increasing
};

/// a/R up to which a quantity is within each of size_tolerances.
using SizeLimits = std::array<std::optional<StrainThreshold>, size_tolerances.size()>;
SizeLimits size_limits(const std::vector<SizePoint>& points);

struct SizeDeviation {
    SizeContact contact;
    std::vector<SizeCurve> curves;  ///< the case's body first
    std::size_t n_failed_runs = 0;
};

/// `results` in the order of size_runs(); empty where a run failed.
SizeDeviation size_deviation(const SizeContact& contact,
                             const std::vector<std::optional<Results>>& results);

/// "hemisphere on a holder", "cylinder on a hub of 0.6 R"
std::string name_of(const SizedBody& body, double radius);

}  // namespace tricontact::comparisons
