#pragma once

#include <span>
#include <string>
#include <vector>

#include "contact/case.h"
#include "experiments/assumptions/check_rig.h"
#include "experiments/assumptions/rig_quantities.h"
#include "theory/layer/elastic_layer.h"
#include "theory/layer/line_contact.h"

// The quantities of a rolling rig and its contact, for the files of its assumptions.
namespace tricontact::experiments {

/// W [m], the least of the drive and that at which the pivot was measured; f_0 [Hz].
extern const Formula smallest_amplitude, pivot_amplitude, excitation_frequency;

/// What the contact follows from on a half-space, and on the layer under a rigid roller.
inline constexpr Inputs materials{&Rig::E_1, &Rig::nu_1, &Rig::E_2, &Rig::nu_2};
inline constexpr Inputs hertz_inputs = Inputs{&Rig::R, &Rig::F_N} + materials + Inputs{&Rig::L};
inline constexpr Inputs layer_inputs{&Rig::R, &Rig::F_N, &Rig::b, &Rig::E_2, &Rig::nu_2, &Rig::L};

contact::MaterialPair materials_of(const RigData& r);
/// At mu = 1.
contact::HalfSpaceScales hertz_of(const RigData& r);
/// Hertz' half width [m] of a cylinder.
double line_half_width_of(const RigData& r);
/// Half the size of the contact with the half-space: radius, half width of a cylinder's [m].
RigNumber half_size(const Rig& rig);
theory::ElasticLayer layer_with(const RigData& r);
theory::LayerContact layer_of(const RigData& r);
theory::LineContact layer_line_of(const RigData& r);

/// The layer's theory takes the roller as rigid: that is so where the roller has less than 1 % of
/// the compliance, a fifth of what counts as a difference here.
bool roller_is_rigid(const Rig& rig);
inline constexpr const char* theory_of_elastic_roller =
    "not computed: no theory here for an elastic indenter on a layer";
inline constexpr const char* exact_layer = "exact contact with a bonded layer";

/// Relative differences up to here count as none: the scatter of repeated runs of such rigs.
inline constexpr double accepted_difference = 0.05;
inline constexpr const char* accepted_reason = "below the scatter of repeated runs";

/// "3.12 %" of a share.
std::string percent_text(double share, int digits = 3);
/// "36.3 % below Hertz", of a quantity over Hertz'.
std::string beside_hertz(double ratio);

/// A quantity of the contact, by both theories: of `hertz_inputs` and of `layer_inputs`.
struct ComparedQuantity {
    const char *name, *symbol, *formula, *source, *unit;
    double (*half_space)(const RigData&);
    double (*layer)(const RigData&);

    /// The layer's over the half-space's.
    double ratio(const RigData& r) const { return layer(r) / half_space(r); }
};
/// What a theory of the layer is called, and what the comparison says where the roller is rigid.
struct LayerTheory {
    const char *formula, *source;
    std::string (*consequence)(const Rig&);
};
/// Of both shapes: the thesis' rule for b/D_c, and both theories of all that is compared.
Assumption half_space_assumption(const Rig& rig, Calculation thickness_ratio,
                                 std::span<const ComparedQuantity> compared,
                                 const LayerTheory& theory);

/// elastic_substrate() of a substrate with several branches of relaxation.
Assumption relaxed_substrate(const Rig& rig);

/// Whether these are the data of one of the thesis' three rolling rigs (Wetter 2016, tables 5.1.1
/// to 5.1.3): shape, R, b, E_2, mu and F_N. Remarks on the thesis' text are made of no other.
bool is_thesis_rig(const Rig& rig);

}  // namespace tricontact::experiments
