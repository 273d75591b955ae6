#include <cmath>

#include "benchmarks/reference/reference_kinds.h"
#include "comparisons/half_space/layer.h"
#include "contact/base/stopped.h"
#include "theory/layer/free_sides.h"

namespace tricontact::benchmarks {

namespace {

using contact::Case;
using contact::NormalControl;
namespace keys = quantity_keys;

/// What sides add to the indentation at most, over it, and dF/dd d/F; empty where no theory covers
/// the case.
struct SideEffect {
    double largest, exponent;
};
std::optional<SideEffect> side_effect_of(const Case& c, const theory::BlockSides& sides) {
    if (!c.layer.thickness || c.layer.base != Case::Base::bonded) return {};
    const Case pressed = pressed_alone(c, final_normal(c));
    std::optional<SideEffect> effect;
    const theory::ElasticLayer layer = comparisons::elastic_layer(c);
    contact::why_it_stopped([&] {
        if (has_exact_radial_contact(c)) {
            const auto contact = comparisons::exact_layer_contact(pressed);
            if (!contact) return;
            effect = {theory::side_effect(layer, *contact, sides),
                      contact->normal_stiffness * contact->indentation / contact->normal_force};
        } else if (has_exact_line_contact(c)) {
            const auto contact = comparisons::exact_line_contact(pressed);
            if (!contact) return;
            effect = {theory::side_effect(layer, *contact, sides.right, sides.left),
                      contact->stiffness * contact->indentation / contact->load};
        }
    });
    return effect;
}

/// Changes of what follows from the control, [0, largest] of the compliance.
std::map<std::string, ReferenceValue> changes(const Reference& reference,
                                              const theory::BlockSides& sides) {
    const auto effect = side_effect_of(reference.c, sides);
    if (!effect) return {};
    std::map<std::string, ReferenceValue> result;
    const auto add = [&](const char* key, double relative) {
        const ReferenceValue* value = reference.find(key);
        if (!value) return;
        const double half = relative * value->value / 2;
        result[key] = {.value = half, .domain = std::abs(half), .source = "free sides"};
    };
    if (final_normal(reference.c).kind == NormalControl::Kind::force)
        add(keys::indentation, effect->largest);
    else
        add(keys::normal_force, -effect->exponent * effect->largest);
    return result;
}

}  // namespace

std::map<std::string, ReferenceValue> finite_block_effect(const Reference& reference,
                                                          double half_width) {
    return changes(reference, {half_width, half_width, half_width, half_width});
}

void add_sides_of_case(Reference& reference) {
    const Case::Layer& layer = reference.c.layer;
    if (!layer.width && !layer.depth) return;
    constexpr double far = 1e3;  // thicknesses: no side
    const double none = far * layer.thickness.value_or(1);
    const double x = layer.width ? *layer.width / 2 : none;
    const double y = layer.depth ? *layer.depth / 2 : none;
    for (const auto& [key, change] : changes(reference, {x, x, y, y}))
        reference.values[key].domain = std::abs(change.value) + change.domain;
    reference.remarks.emplace_back(
        "the reference is that of the unbounded layer; what the sides of the case change is its "
        "bar of the domain");
}

}  // namespace tricontact::benchmarks
