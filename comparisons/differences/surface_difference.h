#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/resolution/numerical_error.h"
#include "contact/case.h"
#include "contact/history.h"
#include "io/results/vtk_files.h"
#include "report/document.h"

namespace tricontact::comparisons {

/// The largest difference of a field and where it is.
struct LargestDifference {
    double value = 0;          ///< a minus b, of a vector the magnitude [Pa]
    contact::Vector2 place{};  ///< [m]
    double l2 = 0;             ///< sqrt(∫ difference^2 dA / ∫ b^2 dA) [-]; 0 where b is nowhere
    double over = 0;           ///< the largest value of b [Pa]
};

/// Two surfaces at one instant on one grid, cells centred on its points.
struct SurfaceDifference {
    std::string name_a, name_b;  ///< "fem", "bem-layer"; "A", "B"
    std::string title = {};      ///< for readers; empty: of the names
    double phase = 0;            ///< of the instant
    contact::Surface a, b;       ///< grid layout; n_y = 1: along x alone
    LargestDifference pressure, traction;

    std::size_t size() const { return a.size(); }
    /// a minus b; empty where one of them lacks the field.
    std::vector<double> of(std::vector<double> contact::Surface::*field) const;
};

/// On the finer of the two grids; surfaces of nodes are resampled first (resample.h), the springs
/// of MDR stand for what is axisymmetric about the indenter. Beyond a surface nothing touches, and
/// displacements are NaN. Fields: tractions, bound, displacements, gap.
SurfaceDifference difference_of(const contact::Surface& a, const contact::Surface& b);

/// Of each pair of models with surfaces in the last state that both have, the later model first:
/// what assumes least minus what assumes more.
std::vector<SurfaceDifference> model_differences(const std::vector<contact::History>& histories);

/// `.vti` on that grid (io::image_grid), SI units, z out of the body: of normal_traction,
/// tangential_traction and displacement "normal_traction_NAME_Pa" of either and
/// "normal_traction_difference_Pa", a minus b.
io::VtkFile difference_vtk(const SurfaceDifference& difference, const io::Provenance& provenance);
/// "difference_fem_bem-layer.vti"
std::string difference_file(const std::string& a, const std::string& b);
/// All that a run of these models may write.
std::vector<std::string> difference_files(const std::vector<std::string>& models);

/// Maps of a 2D difference, or curves over x, of pressure and of traction along x, over the largest
/// pressure and traction of b. `id`: ends their names.
std::vector<report::Figure> difference_figures(const SurfaceDifference& difference,
                                               const std::string& id);
/// A row per pair: largest differences, where they are, norms.
report::DocumentTable difference_table(const std::vector<SurfaceDifference>& differences);

/// The section of a run's report, with the numerical half width of p_0 beside; empty without
/// differences.
std::optional<report::DocumentSection> difference_section(
    const std::vector<SurfaceDifference>& differences,
    const std::vector<contact::History>& histories, const std::optional<NumericalError>& error);

}  // namespace tricontact::comparisons
