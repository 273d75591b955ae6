#include "io/tables/body_tables.h"

#include <algorithm>
#include <array>
#include <numbers>

#include "io/keys/messages.h"
#include "io/tables/csv_table.h"

namespace tricontact::io {

namespace {

using Point = contact::ProfileCurve::Point;

// The transform of a profile costs the square of its points; an analysis has dozens of rows.
constexpr std::size_t most_body_rows = 1000;
const CsvForm profile_form{"profile", "r [mm], h [um]", most_body_rows, "thin it out"};
const CsvForm test_form{"relaxation test", "time [s], E [MPa]", most_body_rows, "thin it out"};
const CsvForm dma_form{"DMA table", "frequency [Hz], G' [MPa], G'' [MPa]", most_body_rows,
                       "thin it out"};

void check_points(const CsvTable& table, const std::vector<Point>& points) {
    if (points[0].radius != 0)
        table.refuse_value(0, "r", "the profile must begin on its axis",
                           "let the first row be 0, 0");
    if (points[0].height != 0)
        table.refuse_value(0, "h", "heights count from the point on the axis",
                           "subtract its height from all");
    table.check_increasing("r", "radii must increase from row to row", "sort the table");
    for (std::size_t i = 1; i < points.size(); ++i)
        if (points[i].height < points[i - 1].height)
            table.refuse_value(i, "h", "the profile falls: its contact would be no disc",
                               "smooth it, or give a height map");
    if (!(points.back().height > 0))
        table.refuse_value(points.size() - 1, "h", "the profile is flat: it has no finite contact",
                           "give points beyond its edge");
}

constexpr std::array<std::string_view, 3> dma_columns{"frequency", "G'", "G''"};

/// Sets at several temperatures, one below the other or beside each other, are several materials.
void check_one_temperature(const CsvTable& table) {
    const std::string remedy =
        "keep the rows of one temperature, or shift all to a master curve at one";
    for (const CsvTable::Column& column : table.columns()) {
        const bool temperature =
            column.name == "T" || column.name == "temperature" || column.name == "Temperature";
        if (!temperature) continue;
        const auto [low, high] = std::ranges::minmax(column.values);
        const std::size_t other =
            std::ranges::find_if(column.values,
                                 [&](double t) { return t != column.values.front(); }) -
            column.values.begin();
        constexpr double steady = 2;  // degrees: about what a chamber holds
        if (high - low > steady)
            table.refuse_value(other, column.name,
                               "the rows are of several temperatures, and a Prony series of one",
                               remedy);
    }
    // Without such a column, frequencies that begin again tell.
    const auto& frequency = table.columns().front().values;
    std::size_t falls = 0, rises = 0, first = 0;
    for (std::size_t row = 1; row < frequency.size(); ++row) {
        rises += frequency[row] > frequency[row - 1];
        if (frequency[row] > frequency[row - 1]) continue;
        if (falls++ == 0) first = row;
    }
    if (falls > 0 && rises >= 2 * falls && frequency[first] < frequency[first - 1])
        table.refuse_value(first, dma_columns[0],
                           "the frequencies begin again, as in sets at several temperatures",
                           remedy);
}

void check_dma_columns(const CsvTable& table) {
    const auto& columns = table.columns();
    for (std::size_t j = 0; j < columns.size() && j < dma_columns.size(); ++j)
        if (columns[j].name != dma_columns[j])
            table.refuse_header("the column " + toml_string(shortened(columns[j].heading, 40)) +
                                " should be " + std::string(dma_columns[j]));
    const bool with_temperature =
        columns.size() == 4 && (columns[3].name == "temperature" ||
                                columns[3].name == "Temperature" || columns[3].name == "T");
    if (columns.size() != dma_columns.size() && !with_temperature)
        table.refuse_header("has " + std::to_string(columns.size()) + " columns instead of 3");
}

// From the table's unit to rad/s. "1/s" is used for both and says neither.
std::vector<double> angular_frequencies(const CsvTable& table) {
    const std::string unit = table.columns()[0].unit.value_or("Hz");
    if (unit.find("Hz") != std::string::npos || unit.find("hertz") != std::string::npos) {
        auto omega = table.values(dma_columns[0], Dimension::frequency);
        for (double& value : omega) value *= 2 * std::numbers::pi;
        return omega;
    }
    try {
        parse_quantity("1 " + unit, Dimension::angular_frequency);
    } catch (const QuantityError&) {
        table.refuse_header(toml_string(shortened(unit, 40)) +
                            " is neither a frequency in Hz nor one in rad/s");
    }
    return table.values(dma_columns[0], Dimension::angular_frequency);
}

}  // namespace

std::vector<Point> read_profile_table(const std::string& path) {
    const CsvTable table = read_csv_table(path, profile_form);
    table.check_names({"r", "h", "kink"});
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

contact::DmaTable read_dma_table(const std::string& path) {
    const CsvTable table = read_csv_table(path, dma_form);
    check_dma_columns(table);
    for (const std::string_view column : dma_columns) table.check_positive(column);
    check_one_temperature(table);
    table.check_increasing(dma_columns[0], "frequencies must increase from row to row",
                           "sort the table");
    return {.name = table.name(),
            .omega = angular_frequencies(table),
            .storage = table.values(dma_columns[1], Dimension::pressure),
            .loss = table.values(dma_columns[2], Dimension::pressure)};
}

contact::RelaxationTest read_relaxation_test(const std::string& path) {
    const CsvTable table = read_csv_table(path, test_form);
    table.check_names({"time", "E", "G"});
    if (table.has("E") == table.has("G"))
        table.refuse_header(table.has("E") ? "the columns E and G both give it"
                                           : "has neither a column E nor G");
    const std::string_view modulus = table.has("E") ? "E" : "G";
    table.check_positive(modulus);
    table.check_increasing("time", "times must increase from row to row", "sort the table");
    contact::RelaxationTest test{.name = table.name(),
                                 .is_young = table.has("E"),
                                 .time = table.values("time", Dimension::time),
                                 .modulus = table.values(modulus, Dimension::pressure)};
    if (test.time.front() < 0)
        table.refuse_value(0, "time", "must not be negative",
                           "count times from when the strain was applied");
    return test;
}

}  // namespace tricontact::io
