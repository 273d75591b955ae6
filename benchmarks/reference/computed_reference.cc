#include <algorithm>
#include <cmath>
#include <future>

#include "benchmarks/reference/model_levels.h"
#include "benchmarks/reference/neighbour_effects.h"
#include "benchmarks/reference/reference_kinds.h"
#include "contact/models/model_kind.h"

namespace tricontact::benchmarks {

namespace {

using contact::Case;
namespace keys = quantity_keys;

/// Without friction coupling changes no force, but tells how the surface moves along itself.
Case with_displacements(Case c) {
    if (c.contact.coupling || !is_frictionless(c) || c.prescribed_path) return c;
    c.contact.coupling = true;
    c.load.press = Case::Press::frictionless;
    return c;
}

bool has_tractions(const Reference& reference, const EndState& finest) {
    const auto largest = [](const std::vector<double>& values) {
        double most = 0;
        for (const double value : values) most = std::max(most, std::abs(value));
        return most;
    };
    return std::max(largest(finest.surface.tangential_traction_x),
                    largest(finest.surface.tangential_traction_y)) >
           1e-6 * largest(finest.surface.normal_traction) *
               std::max(1., reference.c.friction.law()->ratio_at(1));
}

}  // namespace

// Levels and neighbours are computed at the same time.
void refer_computed(Reference& reference, const contact::ModelRunner& runner) {
    const Case c = with_displacements(reference.c);
    const bool is_pressed_alike = is_uncoupled(reference.c);
    const bool has_radial = is_pressed_alike && has_exact_radial_contact(c);
    const bool has_line = is_pressed_alike && has_exact_line_contact(c);
    const std::string model = c.layer.thickness ? contact::models::bem_layer : contact::models::bem;
    std::future<NeighbourEffects> effects;
    if (!c.rolling)
        effects = std::async(std::launch::async, [&] {
            return NeighbourEffects(c, runner, model, !has_radial && !has_line);
        });
    const std::vector<EndState> levels = end_states(runner, model, c);
    reference.models = {model};
    reference.values = values_of_levels(reference.c, levels, model);
    reference.contact_radius = reference.values.at(keys::contact_radius).value;
    const auto fields = fields_of_levels(levels);
    reference.fields = fields;
    reference.has_tractions = has_tractions(reference, levels.back());
    if (has_radial) take_radial_pressing(reference, fields);
    if (has_line) take_line_pressing(reference, fields);
    take_closed_shearing(reference);
    take_closed_twist(reference);
    if (effects.valid()) effects.get().add_to(reference);
}

}  // namespace tricontact::benchmarks
