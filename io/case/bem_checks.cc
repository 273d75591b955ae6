#include <algorithm>
#include <cmath>
#include <tuple>

#include "bem/settings.h"
#include "contact/cells.h"
#include "contact/load_path.h"
#include "io/case/case_checks.h"
#include "io/results/output.h"

namespace tricontact::io {

namespace {

using contact::Case;
using contact::ModelKind;
using Base = Case::Base;

constexpr double whole_cells = 1e-6;  // how far the period may be from them, in cells
constexpr int samples = 200;          // of the indenter's height, along a side

bool has_cells_on(const Case& c, ModelKind::Body body) {
    return computes(c, [&](const ModelKind& model) { return model.is_on_cells_of(body); });
}

void check_influence(const Case& c, const Document& document) {
    if (c.period)
        refuse(document, "bem.influence",
               "coefficients of single cells do not describe periodic contacts",
               "omit it or bem.period");
    if (has_cells_on(c, ModelKind::Body::half_space) && has_cells_on(c, ModelKind::Body::layer))
        refuse(document, "bem.influence",
               "the same coefficients cannot be those of bem and bem-layer",
               "name one of the two in models");
    check_file_there(document, "bem.influence", *c.of<bem::Settings>().influence,
                     "write one by tricontact influence");
}

// Why the mean displacement under a periodic load, the compliance at k = 0, has to be finite.
void check_mean(const Case& c, const Document& document) {
    const bool layer = has_cells_on(c, ModelKind::Body::layer);
    const bool single =
        has_cells_on(c, ModelKind::Body::half_space) && !contact::is_nominally_flat(c);
    if (single || (layer && c.layer.base == Base::half_space))
        refuse(
            document, "bem.period",
            "under a periodic load a half-space gives way without bound: its compliance at k = 0 "
            "is infinite",
            "omit it, or take bem-layer alone on a bonded base");
    if (!layer) return;
    if (c.layer.base == Base::frictionless)
        refuse(document, "bem.period",
               "nothing holds a periodic layer that glides on its ground: its tangential "
               "compliance at k = 0 is infinite",
               "omit it, or take base = \"bonded\"");
    if (!c.indenter.material) return;
    const double ratio = c.indenter.material->plane_compliance() / c.substrate.plane_compliance();
    if (ratio > largest_compliance_ratio)
        refuse(document, "bem.period",
               "periodic indenters are taken as rigid, but the compliance (1 - poisson^2)/young of "
               "this one is " +
                   rounded(ratio) + " of the substrate's, more than " +
                   rounded(largest_compliance_ratio),
               "omit it, or young and poisson of the indenter");
}

void check_cells(const Case& c, const Document& document) {
    const std::optional<double>& spacing = c.of<contact::Cells>().spacing;
    if (!spacing) return;
    const double cells = *c.period / *spacing;
    if (std::abs(cells - std::round(cells)) <= whole_cells) return;
    refuse(document, "bem.period", "is no whole number of cells, but " + rounded(cells),
           "use a spacing of " + shortest(*c.period / std::ceil(cells)) +
               " m, or bem.cells_per_radius");
}

void check_path(const Case& c, const Document& document) {
    if (contact::is_nominally_flat(c)) return;
    const double path =
        contact::norm(contact::path_reach(c, contact::half_space_scales(c).contact_radius));
    if (2 * path < *c.period) return;
    refuse(document, "bem.period",
           "is not longer than the rolling path of " + rounded(2 * path) +
               " m: the contact would meet its neighbour's track",
           "enlarge it or reduce the rolling amplitude");
}

/// Over a period: of a nominally flat body at the cells, of a symmetric one over a quarter.
double mean_height(const Case& c) {
    const bool flat = contact::is_nominally_flat(c);
    const double side = flat ? *c.period : *c.period / 2, first = flat ? 0 : .5;
    const int n =
        flat ? static_cast<int>(std::lround(side / *c.of<contact::Cells>().spacing)) : samples;
    const auto indenter = c.make_indenter();
    double sum = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            sum += indenter->height(side * (i + first) / n, side * (j + first) / n);
    return sum / n / n;
}

// What cannot be compressed keeps its mean height: as deep as the indenter's own mean height the
// layer would fill the whole period, and resist any further indentation with infinite stiffness.
void check_room(const Case& c, const Document& document) {
    if (!c.load.indentation) return;
    const bool half_space = has_cells_on(c, ModelKind::Body::half_space);
    const bool compressible =
        c.substrate.poisson < 0.5 ||
        std::any_of(c.layer.lower.begin(), c.layer.lower.end(),
                    [](const auto& lower) { return lower.material.poisson < 0.5; });
    if (compressible && !half_space) return;
    const double room = mean_height(c);
    if (*c.load.indentation * (1 + c.load.normal_amplitude_ratio) < room) return;
    if (half_space)
        refuse(document, "load.indentation",
               "the indenter's mean height over the mean plane of the half-space is " +
                   rounded(room) + " m: there all of it touches, whatever the force",
               "reduce it, or give load.normal_force");
    refuse(document, "load.indentation",
           "at poisson = 0.5 the mean compliance of a period (k = 0) is zero: at " + rounded(room) +
               " m the layer would fill it, and be infinitely stiff",
           "reduce it, or enlarge bem.period");
}

/// Cells that are no squares about the lowest point, or lie otherwise, under smooth round bodies.
void check_shape_of_cells(const Case& c, const Document& document) {
    const auto demand = [&](bool holds, const std::string& key, const char* rule,
                            const char* remedy) {
        if (!holds) refuse(document, key, rule, remedy);
    };
    const auto& cells = c.of<contact::Cells>();
    for (const auto& [given, key, along_y] :
         {std::tuple{cells.ratio, "bem.cell_ratio", true},
          std::tuple{cells.shift_x, "bem.cell_shift_x", false},
          std::tuple{cells.shift_y, "bem.cell_shift_y", true}}) {
        if (!given) continue;
        demand(!contact::is_nominally_flat(c) && !c.indenter.roughness, key,
               "the cells of rough bodies and height maps are squares, one about the origin",
               "omit it");
        demand(!c.period, key, "a period is divided into squares", "omit it");
        demand(!along_y || !c.is_cylindrical(), key,
               "the cells of a cylinder or roller divide its length", "omit it");
        demand(!along_y || !c.of<bem::Settings>().influence || key != std::string("bem.cell_ratio"),
               key, "files of influence coefficients hold those of square cells",
               "omit it, or bem.influence");
    }
}

void check_inside(const Case& c, const Document& document) {
    if (c.of<Output>().volume == Output::Volume::none) return;
    const char* why =
        c.of<bem::Settings>().influence ? "coefficients of the surface do not describe the interior"
        : c.has_rigid_substrate         ? "the interior is that of the substrate, which is rigid"
        : c.period                      ? "the interior below periodic contacts is not computed"
                                        : nullptr;
    if (why) refuse(document, "output.volume", why, "leave output.volume out");
}

}  // namespace

void check_bem_options(const Case& c, const Document& document) {
    if (!computes(c, &ModelKind::is_on_cells)) return;
    check_inside(c, document);
    check_shape_of_cells(c, document);
    if (c.of<bem::Settings>().influence) check_influence(c, document);
    if (!c.period) return;
    check_mean(c, document);
    check_cells(c, document);
    check_path(c, document);
    check_room(c, document);
}

}  // namespace tricontact::io
