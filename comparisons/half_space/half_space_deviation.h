#pragma once

#include <array>
#include <vector>

#include "comparisons/half_space/exact_deviation.h"
#include "comparisons/half_space/layer.h"
#include "comparisons/half_space/needed_thickness.h"
#include "comparisons/half_space/rolled_deviation.h"
#include "contact/case.h"

namespace tricontact::comparisons {

/// Deviations for which the needed thickness is asked.
inline constexpr std::array<double, 3> deviation_tolerances{.01, .02, .05};

using NeededThicknesses = std::array<NeededThickness, deviation_tolerances.size()>;

/// Exact ratios over b/D_c of layers of one material. On a frictionless base no ratio depends on
/// nu, which stands for any there.
struct ExactCurve {
    double poisson = 0;
    theory::LayerBase base = theory::LayerBase::bonded;
    std::vector<double> thickness_ratios;  ///< increasing
    std::vector<ExactRatios> ratios;
    ByQuantity<NeededThicknesses> needed;
};

/// Exact ratios of bonded layers over b/D_c and nu, uncoupled.
struct ExactMap {
    std::vector<double> thickness_ratios, poissons;  ///< increasing
    std::vector<ExactRatios> ratios;                 ///< thickness fastest
};

/// Computed ratios over b/D_c of bonded layers of one material.
struct RolledCurve {
    double poisson = 0;
    bool coupled = true;
    std::vector<RolledDeviation> points;  ///< thickness increasing
    /// Undefined where fewer than three neighbouring points know it.
    ByQuantity<NeededThicknesses> needed;
};

/// How far the layer of a case, and layers in general, are from a half-space.
struct HalfSpaceDeviation {
    contact::Case c;
    DeviationContact contact;
    double thickness_ratio = 0;  ///< b/D_c of the case
    theory::LayerBase base = theory::LayerBase::bonded;
    ExactRatios here;                ///< of the case's own layer
    ApparentModuli apparent;         ///< what Hertz' theory would identify on it [Pa]
    std::vector<ExactCurve> curves;  ///< the first of the case's material and base
    ExactMap map;
    RolledAmplitudes amplitudes;
    std::vector<RolledCurve> rolled;  ///< empty without runs
    std::size_t n_failed_runs = 0;
};

/// The contact of a case: its force, or that of its indentation on the layer. Throws
/// contact::InputError for a case without a layer, or of which exact theory or a constant load does
/// not hold.
DeviationContact deviation_contact(const contact::Case& c);

/// What exact theory says; no runs.
HalfSpaceDeviation exact_deviation(const contact::Case& c);

/// The bodies on which runs complete it: bonded layers from D_c/4 to 16 D_c at four Poisson's
/// ratios and that of the case, coupled and not, the case's own layer, and their half-spaces. None
/// on a frictionless base, which holds no tangential force, or without one.
std::vector<RolledBody> rolled_bodies(const HalfSpaceDeviation& deviation);

/// Sorts the ratios of the runs into curves and finds the needed thicknesses.
void add_rolled(const std::vector<RolledResult>& results, HalfSpaceDeviation& deviation);

}  // namespace tricontact::comparisons
