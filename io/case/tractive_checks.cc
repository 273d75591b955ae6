#include <array>
#include <utility>

#include "io/case/case_checks.h"
#include "io/keys/messages.h"
#include "io/keys/refusal.h"

namespace tricontact::io {

namespace {

using contact::Case;

void check_rolls_one_way(const Case& c, const Document& document) {
    if (c.rolling)
        fail(document.find_section("tractive_rolling")->place, "[tractive_rolling]",
             "contradicts [rolling]: the indenter rolls to and fro, or on", "give one of the two");
    for (const auto& [key, ratio] :
         {std::pair("load.normal_amplitude_ratio", c.load.normal_amplitude_ratio),
          std::pair("load.tangential_amplitude_ratio", c.load.tangential_amplitude_ratio)})
        if (ratio != 0)
            refuse(document, key, "who rolls on has no period in which loads could oscillate",
                   "omit it");
    for (const auto& [key, time] : {std::pair("load.press_time", c.load.press_time.value_or(0)),
                                    std::pair("load.hold", c.load.hold)})
        if (time != 0)
            refuse(document, key, "who rolls on begins where all has relaxed under F_N and F_T",
                   "omit it");
}

/// What moves or turns across the rolling.
std::array<std::pair<const char*, double>, 2> across(const Case::TractiveRolling& rolling) {
    return {{{"tractive_rolling.lateral_creepage", rolling.lateral_creepage.value_or(0)},
             {"tractive_rolling.spin", rolling.spin}}};
}

void check_cylinder(const Case& c, const Document& document) {
    if (!c.is_line_contact()) return;
    for (const auto& [key, value] : across(*c.tractive_rolling))
        if (value != 0)
            refuse(document, key, "a line contact rolls and slides along x alone",
                   "omit it, or take a body that touches in an area");
}

/// Others would bring new hills into contact at every step.
void check_smooth(const Case& c, const Document& document) {
    const Case::Shape shape = c.indenter.shape;
    if (c.indenter.roughness || shape == Case::Shape::flat || shape == Case::Shape::height_map)
        refuse(document, "indenter.shape", "a rough body is not the same after it has rolled on",
               "take a smooth one, or omit [tractive_rolling]");
}

void check_model(const std::string& model, const Case& c, const Document& document) {
    if (model != "mdr" && model != "bem" && model != "bem-layer")
        refuse(document, "models",
               model + " has no grid along which the contact could move by whole cells",
               "take mdr, bem or bem-layer for [tractive_rolling]");
    if (model != "mdr") return;
    for (const auto& [key, value] : across(*c.tractive_rolling))
        if (value != 0)
            refuse(document, key, "mdr is a line of springs along x: it has nothing across",
                   "omit it, or leave mdr out");
}

}  // namespace

void check_tractive_rolling(const Case& c, const Document& document) {
    if (!c.tractive_rolling) return;
    check_rolls_one_way(c, document);
    check_smooth(c, document);
    check_cylinder(c, document);
    for (const std::string& model : c.models) check_model(model, c, document);
}

double steps_of_tractive_rolling(const Case& c, const contact::HalfSpaceScales& scales) {
    const double cells =
        c.bem.spacing ? scales.contact_radius / *c.bem.spacing : *c.bem.cells_per_radius;
    return 2 + c.tractive_rolling->distance * cells;
}

}  // namespace tricontact::io
