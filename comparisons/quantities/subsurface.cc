#include "comparisons/quantities/quantities.h"

namespace tricontact::comparisons::quantities {

namespace {

using Inside = const contact::Subsurface&;
using Scales = const contact::Scales&;

/// What `get` makes of the inside, where it was written.
template <auto get>
QuantityValue of_inside(const Subject& s) {
    const auto& inside = s.history.subsurface;
    return inside ? finite(get(*inside, s.history.scales)) : QuantityValue();
}

constexpr const char* written = "where the inside of the substrate was written (output.volume)";

constinit const Quantity phase{.key = "subsurface_phase",
                               .name = "phase of the inside that was written last",
                               .meaning = "Rolling periods since the start.",
                               .defined = written,
                               .of = of_inside<[](Inside i, Scales) { return i.phase; }>,
                               .place = "/subsurface/phase"};

constinit const Quantity peak_von_mises{
    .key = "peak_von_mises_Pa",
    .unit = "Pa",
    .name = "largest von Mises stress",
    .meaning = "Largest von Mises stress inside the substrate.",
    .defined = written,
    .of = of_inside<[](Inside i, Scales) { return i.peak_von_mises; }>,
    .place = "/subsurface/peak_von_mises_Pa",
    .part = Part::inside};

constinit const Quantity peak_von_mises_ratio{
    .key = "peak_von_mises_ratio",
    .over = "p_0",
    .name = "largest von Mises stress",
    .meaning = "Largest von Mises stress inside the substrate over the peak pressure.",
    .defined =
        "where the inside of the substrate was written (output.volume) and the peak pressure is "
        "finite",
    .of = [](const Subject& s) -> QuantityValue {
        const auto p0 = number_of(peak_pressure.of(s));
        if (!s.history.subsurface || !p0) return {};
        return finite(s.history.subsurface->peak_von_mises / *p0);
    },
    .place = "/subsurface/peak_von_mises_ratio",
    .part = Part::inside};

constinit const Quantity peak_position{
    .key = "peak_position_m",
    .unit = "m",
    .name = "place of the largest von Mises stress",
    .meaning = "Coordinates x, y, z of the largest von Mises stress, z into the substrate.",
    .defined = written,
    .of = [](const Subject& s) -> QuantityValue {
        if (!s.history.subsurface) return {};
        const auto& [x, y, height] = s.history.subsurface->peak_position;
        return Numbers{x, y, -height};
    },
    .place = "/subsurface/peak_position_m",
    .is_column = false};

constinit const Quantity peak_x_ratio{
    .key = "peak_x_ratio",
    .symbol = "x/a",
    .over = "a",
    .name = "its place",
    .meaning = "Position of the largest von Mises stress along F_T, over a.",
    .defined = written,
    .of = of_inside<[](Inside i, Scales s) { return i.peak_position[0] / s.contact_radius; }>,
    .place = "/subsurface/peak_x_ratio",
    .part = Part::inside,
    .is_place = true};

constinit const Quantity peak_z_ratio{
    .key = "peak_z_ratio",
    .symbol = "z/a",
    .over = "a",
    .name = "its place",
    .meaning = "Depth of the largest von Mises stress, over a.",
    .defined = written,
    .of = of_inside<[](Inside i, Scales s) { return -i.peak_position[2] / s.contact_radius; }>,
    .place = "/subsurface/peak_z_ratio",
    .part = Part::inside,
    .is_place = true};

}  // namespace

List of_subsurface() {
    return {&phase,         &peak_von_mises, &peak_von_mises_ratio,
            &peak_position, &peak_x_ratio,   &peak_z_ratio};
}

}  // namespace tricontact::comparisons::quantities
