#include "comparisons/quantities/left_out.h"

#include <cmath>

#include "comparisons/quantities/model_traits.h"
#include "comparisons/quantities/reference.h"
#include "contact/bodies/upper_plate.h"
#include "contact/load_path.h"
#include "contact/models/model_kind.h"

namespace tricontact::comparisons {

namespace {

using contact::Case;
using contact::ModelKind;

// Below it an indenter counts as rigid: its part of all that gives way.
constexpr double rigid_indenter = 1e-4;

/// An amplitude of 0 has no direction.
bool rolls_askew(const Case& c) {
    const bool rolls = c.rolling || c.prescribed_path;
    return rolls && std::abs(std::sin(contact::path_direction(c))) > 1e-12;
}

bool has_elastic_indenter(const Case& c) {
    const auto& indenter = c.indenter.material;
    return indenter &&
           indenter->plane_compliance() > rigid_indenter * c.substrate.plane_compliance();
}

void add_layer(const Case& c, const std::string& model, std::vector<std::string>& all) {
    if (!c.layer.thickness || is_tabulated(c, model)) return;
    if (traits_of(c, model) & half_space) {
        all.emplace_back("substrate.thickness: the substrate is a half-space");
        return;
    }
    const ModelKind& kind = contact::model_kind(model);
    if (kind.cut == ModelKind::Cut::of_revolution && c.layer.depth)
        all.emplace_back("substrate.depth: the layer is round, of the diameter substrate.width");
    const bool sees_width = kind.sees_sides || kind.is_section();
    if (!sees_width && c.layer.width)
        all.emplace_back("substrate.width: the layer is infinitely wide");
    if (!sees_width && c.layer.depth)
        all.emplace_back("substrate.depth: the layer is infinitely deep along y");
    if (!kind.couples && c.contact.coupling)
        all.emplace_back("contact.coupling: normal and tangential contact are uncoupled");
}

}  // namespace

std::vector<std::string> left_out(const Case& c, const std::string& model) {
    std::vector<std::string> all;
    const ModelKind& kind = contact::model_kind(model);
    if (kind.is_read()) return all;  // it refuses what it does not know
    const unsigned traits = traits_of(c, model);
    add_layer(c, model, all);
    if ((traits & springs) && rolls_askew(c))
        all.emplace_back("rolling direction: springs on a line are the same in every direction");
    if (traits & small_strains) all.emplace_back("substrate.material: linear, at small strains");
    const bool has_meshed_body = kind.sees_indenter_body && c.indenter.body;
    if (!kind.sees_elastic_indenter && !has_meshed_body && has_elastic_indenter(c))
        all.emplace_back("indenter.young: the indenter is rigid");
    if (traits & half_space_indenter)
        all.emplace_back(std::string(c.indenter.body->key()) + ": the indenter is a half-space");
    if ((traits & half_space_indenter) && c.kept.find<contact::UpperPlate>())
        all.emplace_back("upper_plate: the contact with the substrate alone");
    if (!kind.sees_period && c.period) all.emplace_back("bem.period: one contact alone");
    return all;
}

std::string left_out_lines(const Case& c, const std::vector<std::string>& models) {
    std::string lines;
    for (const std::string& model : models)
        for (const std::string& one : left_out(c, model))
            lines += model + " leaves out " + one + '\n';
    return lines;
}

}  // namespace tricontact::comparisons
