#include <tuple>

#include "comparisons/quantities/map_border.h"
#include "comparisons/quantities/quantities.h"
#include "contact/models/model_kind.h"

namespace tricontact::comparisons::quantities {

namespace {

/// Scales of a nominally flat contact are no solution.
QuantityValue exact(const Reference& r, double value) {
    return r.is_nominal ? QuantityValue() : finite(value);
}

/// All of a face with a sharp edge touches.
bool touches_sharp_edge(const Subject& s) {
    constexpr double rounding = 1e-6;
    const contact::IndenterData& body = s.c.indenter;
    return body.shape == contact::Case::Shape::flat_punch &&
           s.history.scales.contact_radius > body.flat_radius * (1 - rounding);
}

constexpr const char* in_a_hole = "of a pin in a hole";
constexpr const char* between_plates =
    "of bodies between unlike plates, beside runs, unless they are asked to go without studies";

/// Set by results_beside.
QuantityValue found_beside(const Subject&) {
    return {};
}

}  // namespace

constinit const Quantity normal_force{
    .key = "normal_force_N",
    .symbol = "F_N",
    .unit = "N",
    .name = "normal force",
    .meaning = "Force that presses the indenter on, of oscillating loads the mean.",
    .of = [](const Subject& s) { return finite(s.history.scales.normal_force); },
    .is_refined = true};

constinit const Quantity indentation{
    .key = "indentation_m",
    .symbol = "d",
    .unit = "m",
    .name = "indentation",
    .meaning = "Approach of the indenter, pressed upright and without friction.",
    .source = "Johnson (1985), 4.2",
    .of = [](const Subject& s) { return finite(s.history.scales.indentation); },
    .exact = [](const Reference& r) { return exact(r, r.hertz.indentation); },
    .part = Part::pressed,
    .is_refined = true};

constinit const Quantity contact_radius{
    .key = "contact_radius_m",
    .symbol = "a",
    .unit = "m",
    .name = "contact radius",
    .meaning = "Radius of the contact pressed without friction, half width of a line contact.",
    .source = "Johnson (1985), 4.2",
    .of = [](const Subject& s) { return finite(s.history.scales.contact_radius); },
    .exact = [](const Reference& r) { return exact(r, r.hertz.contact_radius); },
    .part = Part::pressed,
    .is_refined = true,
    .is_counted = true};

constinit const Quantity peak_pressure{
    .key = "peak_pressure_Pa",
    .symbol = "p_0",
    .unit = "Pa",
    .name = "peak pressure",
    .meaning = "Largest normal traction, pressed without friction.",
    .defined =
        "not under a conical tip or a sharp edge, where it is infinite: that of a mesh grows "
        "with the mesh",
    .source = "Johnson (1985), 4.2",
    .of = [](const Subject& s) -> QuantityValue {
        if (contact::has_conical_tip(s.c) || touches_sharp_edge(s)) return {};
        return finite(s.history.scales.peak_pressure);
    },
    .exact = [](const Reference& r) { return finite(r.peak_pressure); },
    .part = Part::pressed,
    .is_refined = true};

constinit const Quantity unit_shift{
    .key = "unit_shift_m",
    .symbol = "U_max",
    .unit = "m",
    .name = "unit of shift",
    .meaning =
        "Tangential displacement of the contact's centre under the traction mu p, under another "
        "law of friction tau(p): the shift at which a half-space begins to slide; each model's "
        "own.",
    .source = "Cattaneo (1938), Mindlin (1949)",
    .of = [](const Subject& s) -> QuantityValue {
        // A section through the axis knows no friction along x.
        const auto cut = contact::model_kind(s.history.model).cut;
        if (cut == contact::ModelKind::Cut::of_revolution) return {};
        if (s.c.adhesion && !s.c.friction.is_strength_alone()) return {};
        return finite(s.history.scales.unit_shift);
    },
    .exact = [](const Reference& r) { return exact(r, r.hertz.unit_shift); },
    .part = Part::pressed,
    .is_refined = true};

constinit const Quantity tangential_ratio{
    .key = "tangential_ratio",
    .symbol = "f_T",
    .over = "mu F_N",
    .name = "tangential force",
    .meaning = "Tangential force after loading over what friction can carry, mu F_N or F_lim.",
    .of = [](const Subject& s) { return finite(comparisons::tangential_ratio(s.history)); },
    .exact = [](const Reference& r) { return finite(r.tangential_ratio); },
    .part = Part::pressed};

constinit const Quantity contact_half_angle{
    .key = "contact_half_angle_rad",
    .symbol = "eps",
    .unit = "rad",
    .name = "half angle of the contact",
    .meaning = "Of a pin in a hole, from its lowest point to the edge of the contact.",
    .defined = in_a_hole,
    .source = "Persson (1964), Ciavarella and Decuzzi (2001)",
    .of = [](const Subject& s) -> QuantityValue {
        if (!s.c.has_hole()) return {};
        return finite(s.history.scales.contact_radius / s.c.indenter.radius);
    },
    .part = Part::pressed,
    .is_column = false,
    .is_refined = true};

constinit const Quantity conforming_peak{
    .key = "conforming_peak_ratio",
    .symbol = "R p_0/Q",
    .name = "peak pressure of a conforming contact",
    .meaning = "Radius of the pin times largest pressure over the load per length, Q = F_N/L.",
    .defined = in_a_hole,
    .source = "Persson (1964), Ciavarella and Decuzzi (2001)",
    .of = [](const Subject& s) -> QuantityValue {
        if (!s.c.has_hole()) return {};
        const auto& [body, scales] = std::tie(s.c.indenter, s.history.scales);
        return finite(body.radius * body.length * scales.peak_pressure / scales.normal_force);
    },
    .part = Part::pressed,
    .is_column = false,
    .is_refined = true};

constinit const Quantity clearance_ratio{
    .key = "clearance_ratio",
    .symbol = "E*DR/Q",
    .name = "clearance over load",
    .meaning =
        "Clearance times modulus over the load per length: the radius of the hole less that of the "
        "pin, E = E/(1 - nu^2) of the pin, of the plate if the pin is rigid, and Q = F_N/L.",
    .defined = in_a_hole,
    .source = "Persson (1964), Ciavarella and Decuzzi (2001)",
    .of = [](const Subject& s) -> QuantityValue {
        if (!s.c.has_hole()) return {};
        const contact::Material& material = s.c.indenter.material.value_or(s.c.substrate);
        const double clearance = s.c.hole.radius - s.c.indenter.radius;
        return finite(clearance * s.c.indenter.length / material.plane_compliance() /
                      s.history.scales.normal_force);
    },
    .part = Part::pressed,
    .is_column = false,
    .is_refined = false};

constinit const Quantity upper_indentation{
    .key = "upper_indentation_m",
    .symbol = "d_2",
    .unit = "m",
    .name = "indentation of the upper plate",
    .meaning =
        "Approach of the upper plate to the mean of the body's middle plane, as the "
        "indentation is that of the lower one; their sum is the approach of both plates.",
    .defined = between_plates,
    .of = found_beside,
    .part = Part::pressed,
    .is_column = false};

constinit const Quantity upper_contact_radius{
    .key = "upper_contact_radius_m",
    .symbol = "a_2",
    .unit = "m",
    .name = "contact radius at the upper plate",
    .meaning = "Radius, of a cylinder half width, of the contact with the upper plate.",
    .defined = between_plates,
    .of = found_beside,
    .part = Part::pressed,
    .is_column = false};

constinit const Quantity upper_peak_pressure{
    .key = "upper_peak_pressure_Pa",
    .symbol = "p_2",
    .unit = "Pa",
    .name = "peak pressure at the upper plate",
    .meaning = "Largest pressure in the contact with the upper plate.",
    .defined = between_plates,
    .of = found_beside,
    .part = Part::pressed,
    .is_column = false};

constinit const Quantity border_force_share{
    .key = "border_force_share",
    .over = "F_N",
    .name = "force at the border of the height map",
    .meaning =
        "Largest share of the normal force on cells at the border of a height map, beside "
        "which the body ends; 0 where no contact reaches it.",
    .defined = "of height maps without a period",
    .of = [](const Subject& s) { return finite(comparisons::border_force_share(s.c, s.history)); },
    .part = Part::pressed};

constinit const Quantity amplitude{
    .key = "amplitude_m",
    .symbol = "W",
    .unit = "m",
    .name = "amplitude",
    .meaning = "Amplitude of the rolling back and forth.",
    .of = [](const Subject& s) { return finite(s.history.amplitude); }};

constinit const Quantity amplitude_ratio{
    .key = "amplitude_ratio",
    .symbol = "w",
    .over = "a",
    .name = "amplitude",
    .meaning = "Amplitude of the rolling over the model's own contact radius, W/a.",
    .of = [](const Subject& s) { return finite(comparisons::amplitude_ratio(s.history)); },
    .exact = [](const Reference& r) { return finite(r.amplitude_ratio); },
    .part = Part::rolled};

constinit const Quantity normal_stiffness{
    .key = "normal_stiffness_N_per_m",
    .symbol = "k_n",
    .unit = "N/m",
    .name = "normal stiffness",
    .meaning =
        "Slope dF_N/dd of the force over the indentation, without friction, at the load "
        "that the case presses with, the hardest of a path; of relaxed substrates.",
    .defined = "beside runs, unless they are asked to go without studies",
    .source = "Pharr, Oliver and Brotzen (1992)",
    .of = found_beside,  // by further presses
    .part = Part::pressed,
    .is_column = false,
    .is_refined = true};

constinit const Quantity tangential_stiffness{
    .key = "tangential_stiffness_N_per_m",
    .symbol = "k_t",
    .unit = "N/m",
    .name = "tangential stiffness, uncoupled",
    .meaning = "Slope dF_T/dU as F_T sets in, everything sticking.",
    .defined = "in deviations from the half-space, on bonded layers",
    .source = "Johnson (1985), 7.2"};

constinit const Quantity coupled_tangential_stiffness{
    .key = "coupled_tangential_stiffness_N_per_m",
    .symbol = "k_t,c",
    .unit = "N/m",
    .name = "tangential stiffness, coupled",
    .meaning = "The same with normal and tangential contact coupled.",
    .defined = "in deviations from the half-space, on bonded layers",
    .source = "Johnson (1985), 7.2"};

List of_contact() {
    return {&normal_force,        &indentation,        &contact_radius,    &peak_pressure,
            &normal_stiffness,    &unit_shift,         &tangential_ratio,  &contact_half_angle,
            &conforming_peak,     &clearance_ratio,    &upper_indentation, &upper_contact_radius,
            &upper_peak_pressure, &border_force_share, &amplitude,         &amplitude_ratio};
}

}  // namespace tricontact::comparisons::quantities
