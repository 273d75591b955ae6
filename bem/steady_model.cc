#include "bem/steady_model.h"

#include <algorithm>
#include <cmath>

#include "bem/grid_compliance.h"
#include "bem/plane_layer_influence.h"
#include "bem/settings.h"
#include "bem/steady_compliance.h"
#include "contact/creep_modes.h"
#include "contact/models/model_kind.h"
#include "contact/relaxing_case.h"
#include "theory/layer/layer_stack.h"

// Steady rolling on relaxing bodies (docs/explanation/rolling.md): each coefficient needs the
// elastic one all along the way that the material has come. Near the contact that is the body's
// own; beyond known_layers thicknesses the layers are no more than what lies on both sides of them
// (`bodies_beyond`).

namespace tricontact::bem {

namespace {

/// A rolled contact on a relaxing body lies ahead of its lowest point, by a part of its half
/// length.
constexpr double usual_lead = .25;

/// How far ahead layers are known [thicknesses]; where they glide they are held just there.
constexpr double known_layers = LayerKernel::frictionless_hold;

/// What is seen of layers from far away: the bodies on both sides of them.
CellInfluence bodies_beyond(const theory::LayerStack& layers,
                            const std::optional<contact::Material>& indenter,
                            const contact::Vector2& cell) {
    if (layers.half_space) {
        const RectangleInfluence both({indenter, *layers.half_space}, cell[0], cell[1]);
        return [both](double x, double y) { return both.at(x, y); };
    }
    if (!indenter) return [](double, double) { return InfluenceCoefficients{}; };
    const RectangleInfluence upper({{}, *indenter}, cell[0], cell[1]);
    return [upper](double x, double y) {
        InfluenceCoefficients k = upper.at(x, y);
        k.xz = -k.xz;  // its surface faces the other way
        k.yz = -k.yz;
        return k;
    };
}

CellInfluence layer_influence(const contact::Case& c, const contact::ContactPoints& grid) {
    const theory::LayerStack layers = theory::layers_of(contact::models::bem_layer, c);
    const auto& indenter = c.indenter.material;
    const auto [width_x, width_y] = grid.spacing;
    const double side_x = 2 * (grid.n_x + 1) * width_x, side_y = 2 * (grid.n_y + 1) * width_y;
    const double known = std::max(side_x, known_layers * layers.thickness());
    const CellInfluence seen_from_afar = bodies_beyond(layers, indenter, grid.spacing);
    if (c.is_line_contact()) {
        const auto strip =
            std::make_shared<const PlaneLayerInfluence>(layers, indenter, width_x, width_y, known);
        return [=](double x, double y) {
            if (y > 0) return InfluenceCoefficients{};  // beside the only row there is nothing
            return x > known ? seen_from_afar(x, y) : strip->at(x);
        };
    }
    const auto cell = std::make_shared<const LayerInfluence>(layers, indenter, width_x, width_y,
                                                             std::hypot(known, side_y));
    return [=](double x, double y) { return x > known ? seen_from_afar(x, y) : cell->at(x, y); };
}

CellInfluence influence_of(const contact::Case& elastic, Body body,
                           const contact::ContactPoints& grid) {
    if (body == Body::layer) return on_interface(layer_influence(elastic, grid), elastic.interface);
    const RectangleInfluence cell(elastic.materials(), grid.spacing[0], grid.spacing[1]);
    return on_interface([cell](double x, double y) { return cell.at(x, y); }, elastic.interface);
}

}  // namespace

std::unique_ptr<contact::SteadyCompliance> steady_compliance(const contact::Case& c, int n_threads,
                                                             Body body, double aside) {
    if (c.of<Settings>().influence || c.period) return nullptr;
    const contact::Case seen = body == Body::layer ? c : contact::without_layer(c);
    const contact::CreepModes modes = contact::creep_modes(seen);
    const auto relaxed = case_compliance(contact::with_relaxing_ratio(c, 1), n_threads, body,
                                         std::max(aside, usual_lead));
    std::vector<CellInfluence> bodies;
    for (const contact::Case& elastic : modes.bodies)
        bodies.push_back(influence_of(elastic, body, relaxed->points()));
    const bool coupled =
        body == Body::layer || std::ranges::any_of(modes.bodies, [](const contact::Case& elastic) {
            return is_coupled(elastic.materials());
        });
    return std::make_unique<SteadyGridCompliance>(bodies, modes, c.tractive_rolling->speed,
                                                  relaxed->points(), coupled);
}

}  // namespace tricontact::bem
