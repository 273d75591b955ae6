// Differences of surfaces as figures, table, file for ParaView.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "comparisons/differences/surface_difference.h"
#include "comparisons/quantities/quantities.h"
#include "io/keys/messages.h"
#include "io/results/vtk_xml.h"
#include "report/format.h"

namespace tricontact::comparisons {

namespace {

using contact::Surface;
using Field = std::vector<double> Surface::*;

constexpr int most_points_drawn = 61;  // of a map, in each direction
constexpr double reach_drawn = 1.2;    // of the contact of either
constexpr double least_drawn = 1e-9;   // of the largest value: rounding

/// Half width of the square about the indenter in which either surface carries something [m].
double contact_reach(const SurfaceDifference& d) {
    double reach = 0, largest = 0;
    for (const Surface* s : {&d.a, &d.b})
        for (const double p : s->normal_traction) largest = std::max(largest, std::abs(p));
    for (const Surface* s : {&d.a, &d.b})
        for (std::size_t k = 0; k < s->normal_traction.size(); ++k) {
            if (std::abs(s->normal_traction[k]) <= 1e-6 * largest) continue;
            const auto n_x = static_cast<std::size_t>(s->n_x);
            reach = std::max({reach, std::abs(s->x(static_cast<int>(k % n_x)) - s->offset[0]),
                              std::abs(s->y(static_cast<int>(k / n_x)) - s->offset[1])});
        }
    return reach_drawn * reach;
}

/// Indices of the points within that reach of the indenter, thinned.
std::vector<int> drawn_points(int n, double first, double spacing, double centre, double reach,
                              int most) {
    std::vector<int> indices;
    for (int i = 0; i < n; ++i)
        if (std::abs(first + i * spacing - centre) <= reach) indices.push_back(i);
    std::vector<int> thinned;
    for (const std::size_t i : report::thinned(indices.size(), static_cast<std::size_t>(most)))
        thinned.push_back(indices[i]);
    return thinned;
}

struct DrawnField {
    const char *id, *name, *symbol;
    Field field;
    const LargestDifference& largest;
};

std::string names_of_difference(const SurfaceDifference& d) {
    if (!d.title.empty()) return d.title;
    return report::display_name(d.name_a) + " minus " + report::display_name(d.name_b);
}

report::Figure figure_of(const SurfaceDifference& d, const DrawnField& drawn,
                         const std::string& id) {
    const std::vector<double> values = d.of(drawn.field);
    const double unit = drawn.largest.over, reach = contact_reach(d);
    const report::Unit length = report::fitting_unit(reach, "m");
    report::Figure figure{
        .id = fmt::format("difference_{}_{}", drawn.id, id),
        .title = fmt::format("{}: {}", names_of_difference(d), drawn.name),
        .caption = fmt::format("Difference in the last state that both have, over the largest {} "
                               "of {}, on the finer of the two grids.",
                               drawn.name, report::display_name(d.name_b)),
        .x = {fmt::format("x [{}]", length.symbol)}};
    const Surface& s = d.a;
    const std::string label = fmt::format("difference over largest {} [%]", drawn.symbol);
    const bool is_map = s.n_y > 1;
    const auto columns = drawn_points(s.n_x, s.first[0], s.spacing[0], s.offset[0], reach,
                                      is_map ? most_points_drawn : 400);
    if (!is_map) {
        figure.y = {label};
        report::Curve& curve = figure.curves.emplace_back(report::Curve{.name = label});
        for (const int i : columns)
            curve.add(s.x(i) / length.factor, 100 * values[static_cast<std::size_t>(i)] / unit);
        return figure;
    }
    figure.y = {fmt::format("y [{}]", length.symbol)};
    figure.equal_scales = true;
    report::ContourMap map{.label = label, .x = {}, .y = {}, .values = {}, .about_zero = true};
    for (const int i : columns) map.x.push_back(s.x(i) / length.factor);
    for (const int j :
         drawn_points(s.n_y, s.first[1], s.spacing[1], s.offset[1], reach, most_points_drawn)) {
        map.y.push_back(s.y(j) / length.factor);
        for (const int i : columns)
            map.values.push_back(100 * values[static_cast<std::size_t>(j) * s.n_x + i] / unit);
    }
    figure.map = std::move(map);
    return figure;
}

void add_differences(io::VtkXml& xml, const SurfaceDifference& d) {
    const std::size_t n = d.size();
    const auto add_scalar = [&](const std::string& name, const char* unit, Field field) {
        if (d.of(field).empty()) return;
        xml.add_scalar(fmt::format("{}_{}_{}", name, d.name_a, unit), d.a.*field, n);
        xml.add_scalar(fmt::format("{}_{}_{}", name, d.name_b, unit), d.b.*field, n);
        xml.add_scalar(fmt::format("{}_difference_{}", name, unit), d.of(field), n);
    };
    const auto add_vector = [&](const std::string& name, const char* unit,
                                const std::array<Field, 3>& fields) {
        std::array<std::vector<double>, 3> apart;
        for (std::size_t k = 0; k < fields.size(); ++k)
            if (fields[k]) apart[k] = d.of(fields[k]);
        if (apart[0].empty()) return;
        const auto add = [&](const std::string& of, const auto& component) {
            xml.add_vector(fmt::format("{}_{}_{}", name, of, unit),
                           {component(0), component(1), component(2)}, n, -1);
        };
        using Values = std::span<const double>;
        const auto of_surface = [&](const Surface& s) {
            return [&](std::size_t k) {
                return fields[k] && !apart[k].empty() ? Values(s.*fields[k]) : Values();
            };
        };
        add(d.name_a, of_surface(d.a));
        add(d.name_b, of_surface(d.b));
        add("difference", [&](std::size_t k) { return Values(apart[k]); });
    };
    add_scalar("normal_traction", "Pa", &Surface::normal_traction);
    add_vector("tangential_traction", "Pa",
               {&Surface::tangential_traction_x, &Surface::tangential_traction_y, nullptr});
    add_vector("displacement", "m",
               {&Surface::displacement_x, &Surface::displacement_y, &Surface::displacement_z});
    add_scalar("gap", "m", &Surface::gap);
}

/// What the pressure's half width is where it is largest.
std::string edge_sentence(const NumericalError& error, double peak) {
    for (const FieldBar& bar : error.fields)
        if (bar.field == std::string_view("normal_traction"))
            return fmt::format(
                "Over the whole contact they leave ± {} of the pressure's root mean square, at the "
                "worst point, on its edge, ± {} of p_0.",
                report::share(bar.l2), report::share(bar.largest / peak));
    return "At the edge of the contact, where pressures fall steeply, cells leave more.";
}

std::string place_text(const contact::Vector2& place) {
    return fmt::format("({}, {}) mm", report::significant(1e3 * place[0], 3),
                       report::significant(1e3 * place[1], 3));
}

}  // namespace

io::VtkFile difference_vtk(const SurfaceDifference& d, const io::Provenance& provenance) {
    const Surface& s = d.a;
    const double dy = s.n_y > 1 ? s.spacing[1] : s.spacing[0];
    const io::ImageGrid grid = io::image_grid({s.n_x, s.n_y}, s.first, {s.spacing[0], dy});
    io::VtkXml xml(
        "ImageData",
        {{"WholeExtent", grid.extent}, {"Origin", grid.origin}, {"Spacing", grid.spacing}});
    xml.begin("FieldData");
    xml.add_numbers(io::time_in_periods, {d.phase});
    xml.add_numbers("indenter_position_m", {s.offset[0], s.offset[1], 0.});
    xml.add_provenance(provenance);
    xml.end();
    xml.begin("Piece", {{"Extent", grid.extent}});
    xml.begin(grid.data);
    add_differences(xml, d);
    return xml.file();
}

std::string difference_file(const std::string& a, const std::string& b) {
    return fmt::format("difference_{}_{}.vti", a, b);
}

std::vector<std::string> difference_files(const std::vector<std::string>& models) {
    std::vector<std::string> names;
    for (std::size_t k = 0; k < models.size(); ++k)
        for (std::size_t i = k + 1; i < models.size(); ++i)
            names.push_back(difference_file(models[i], models[k]));
    return names;
}

std::vector<report::Figure> difference_figures(const SurfaceDifference& d, const std::string& id) {
    std::vector<report::Figure> figures;
    if (!(contact_reach(d) > 0)) return figures;  // a single point, as surfaces part
    const double p0 = d.pressure.over;
    for (const DrawnField& drawn :
         {DrawnField{"pressure", "pressure", "p", &Surface::normal_traction, d.pressure},
          DrawnField{"traction", "traction along x", "t", &Surface::tangential_traction_x,
                     d.traction}})
        if (drawn.largest.over > least_drawn * p0 &&
            std::abs(drawn.largest.value) > least_drawn * p0 && !d.of(drawn.field).empty())
            figures.push_back(figure_of(d, drawn, id));
    return figures;
}

report::DocumentTable difference_table(const std::vector<SurfaceDifference>& differences) {
    report::DocumentTable table{
        .id = "field_differences",
        .title = "Differences of fields",
        .note =
            "The largest difference and the root of its mean square over the contact, in the "
            "last state that both have, over the largest value and the root mean square of "
            "the second one.",
        .columns = report::columns("fields", "largest of p [%]:3", "at", "L2 of p [%]:3",
                                   "largest of t [%]:3", "at", "L2 of t [%]:3")};
    for (const SurfaceDifference& d : differences) {
        std::vector<report::Cell> row{names_of_difference(d)};
        for (const LargestDifference* one : {&d.pressure, &d.traction}) {
            const bool is_there = one->over > least_drawn * d.pressure.over && one->over > 0;
            row.push_back(report::number_cell(is_there ? std::optional(100 * one->value / one->over)
                                                       : std::nullopt));
            row.emplace_back(is_there ? place_text(one->place) : "");
            row.push_back(
                report::number_cell(is_there ? std::optional(100 * one->l2) : std::nullopt));
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

std::optional<report::DocumentSection> difference_section(
    const std::vector<SurfaceDifference>& differences,
    const std::vector<contact::History>& histories, const std::optional<NumericalError>& error) {
    if (differences.empty()) return {};
    report::DocumentSection section{.id = "differences",
                                    .heading = "Differences of fields",
                                    .tables = {difference_table(differences)}};
    const auto half_width = error ? error->of(quantities::peak_pressure) : std::nullopt;
    for (const contact::History& history : histories)
        if (half_width && history.model == error->model && history.scales.peak_pressure > 0)
            section.paragraphs.push_back(fmt::format(
                "Mesh and steps leave ± {} in p_0 of {}: less is no difference of models there. {}",
                report::share(*half_width / history.scales.peak_pressure),
                report::display_name(history.model),
                edge_sentence(*error, history.scales.peak_pressure)));
    if (section.paragraphs.empty())
        section.paragraphs.push_back(
            "The numerical error of these fields was not estimated: part of a difference may be "
            "of cells and steps, most of all at the edge of the contact.");
    for (const SurfaceDifference& d : differences)
        for (report::Figure& figure : difference_figures(
                 d, report::id_of_model(d.name_a) + '_' + report::id_of_model(d.name_b)))
            section.figures.push_back(std::move(figure));
    return section;
}

}  // namespace tricontact::comparisons
