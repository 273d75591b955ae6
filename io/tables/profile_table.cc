#include "io/tables/profile_table.h"

#include "io/tables/csv_table.h"

namespace tricontact::io {

namespace {

using Point = contact::ProfileCurve::Point;

const CsvForm& profile_form() {
    // The transform of a profile costs the square of its points.
    static const CsvForm form{"profile", "r [mm], h [um]", 1000, "thin it out"};
    return form;
}

void check_profile_columns(const CsvTable& table) {
    for (const auto& column : table.columns())
        if (column.name != "r" && column.name != "h" && column.name != "kink")
            table.refuse_header("\"" + column.name + "\" is none of r, h and kink");
}

void check_points(const CsvTable& table, const std::vector<Point>& points) {
    if (points[0].radius != 0)
        table.refuse_value(0, "r", "the profile must begin on its axis",
                           "let the first row be 0, 0");
    if (points[0].height != 0)
        table.refuse_value(0, "h", "heights count from the point on the axis",
                           "subtract its height from all");
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (!(points[i].radius > points[i - 1].radius))
            table.refuse_value(i, "r", "radii must increase from row to row", "sort the table");
        if (points[i].height < points[i - 1].height)
            table.refuse_value(i, "h", "the profile falls: its contact would be no disc",
                               "smooth it, or give a height map");
    }
    if (!(points.back().height > 0))
        table.refuse_value(points.size() - 1, "h", "the profile is flat: it has no finite contact",
                           "give points beyond its edge");
}

std::vector<Point> points_in(const CsvTable& table) {
    check_profile_columns(table);
    const auto radii = table.values("r", Dimension::length);
    const auto heights = table.values("h", Dimension::length);
    if (radii.size() < 2) table.refuse_header("fewer than two rows are no profile");
    std::vector<double> kinks(radii.size(), 0.);
    if (table.has("kink")) kinks = table.values("kink", Dimension::none);
    std::vector<Point> points;
    for (std::size_t i = 0; i < radii.size(); ++i) {
        if (kinks[i] != 0 && kinks[i] != 1)
            table.refuse_value(i, "kink", "must be 0 or 1", "write 1 where the slope jumps");
        points.push_back({radii[i], heights[i], kinks[i] == 1});
    }
    check_points(table, points);
    return points;
}

}  // namespace

std::vector<Point> parse_profile_table(std::string_view text, const std::string& name) {
    return points_in(CsvTable(text, name, profile_form()));
}

std::vector<Point> read_profile_table(const std::string& path) {
    return points_in(read_csv_table(path, profile_form()));
}

}  // namespace tricontact::io
