#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/quantities/loading_study.h"
#include "comparisons/quantities/quantities.h"
#include "contact/case.h"
#include "contact/history.h"
#include "theory/layer/elastic_layer.h"
#include "theory/layer/line_contact.h"

namespace tricontact::comparisons {

/// A contact pressed without friction, SI units; empty where unknown.
struct PressedValues {
    double contact_radius = 0;               ///< a [m]
    double indentation = 0;                  ///< d [m]
    double normal_force = 0;                 ///< F_N [N]
    double peak_pressure = 0;                ///< p0 [Pa]
    std::optional<double> unit_shift;        ///< U_max [m]; none on a frictionless base
    std::optional<double> normal_stiffness;  ///< dF_N/dd [N/m]
};

/// A quantity of PressedValues, for tables and files.
struct PressedQuantity {
    const Quantity* quantity;
    std::optional<double> (*get)(const PressedValues&);
};
/// In the order of their members.
const std::vector<PressedQuantity>& pressed_quantities();

/// Young's moduli that an identification by Hertz' theory would find on the layer, from the force
/// and one more quantity: E_app [Pa].
struct ApparentModuli {
    double from_indentation = 0;            ///< F = 4/3 E* sqrt(R) d^(3/2)
    double from_contact_radius = 0;         ///< a^3 = 3 F R/(4 E*)
    std::optional<double> from_unit_shift;  ///< U_max = mu (E*/G*) d
};

/// What the thickness of the layer means for the models of a case.
struct LayerComparison {
    struct Model {
        std::string name;
        PressedValues values;
    };
    double thickness = 0;        ///< b of the upper layer [m]
    double thickness_ratio = 0;  ///< b over diameter or width of Hertz' contact
    /// Exact frictionless contact of the rigid indenter with an infinitely wide layer
    /// (theory/layer/elastic_layer.h); empty where theory does not cover the case, then `why_not`
    /// says so.
    std::optional<PressedValues> exact;
    std::string why_not;
    PressedValues half_space;  ///< Hertz, at the same force or indentation
    std::optional<ApparentModuli>
        apparent;  ///< from the exact values, by Hertz' theory of a round body
    std::vector<Model> models;
    /// Distance of the block's sides from its centre over its thickness, of all layers; empty:
    /// chosen by the program.
    std::optional<double> half_width, half_depth;
};

/// Why the exact theory of one layer under a rigid indenter (theory/layer/elastic_layer.h) does not
/// cover the case; empty where it does. The case has a thickness.
std::string why_no_exact_theory(const contact::Case& c);
/// The layer of such a case.
theory::ElasticLayer elastic_layer(const contact::Case& c);

/// Hertz' solution of the case's paraboloid, U_max of the uncoupled half-space, 2 E* a.
PressedValues hertz_values(const contact::Case& c);

/// The case's layer pressed by its indenter, exactly (theory/layer/elastic_layer.h); empty without
/// substrate.thickness and where theory does not cover the case.
std::optional<theory::LayerContact> exact_layer_contact(const contact::Case& c);

/// Empty without substrate.thickness. The models' values are their histories' scales; the stiffness
/// of half-space models is 2 E* a (Pharr, Oliver and Brotzen 1992), that of others the study's.
std::optional<LayerComparison> compare_with_layer(const contact::Case& c,
                                                  const std::vector<contact::History>& histories,
                                                  const LoadingStudy& study = {});

/// The exact frictionless plane contact of a cylinder with its layer; empty where there is no layer
/// or why_no_exact_theory() has a reason. Throws contact::InputError out of the theory's range,
/// contact::NotConverged.
std::optional<theory::LineContact> exact_line_contact(const contact::Case& c);

}  // namespace tricontact::comparisons
