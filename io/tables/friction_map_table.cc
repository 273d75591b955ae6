#include "io/tables/friction_map_table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "io/keys/input_file.h"
#include "io/tables/csv_table.h"

namespace tricontact::io {

namespace {

constexpr std::size_t most_places = 1'000'000;
const CsvForm map_form{"friction map", "x [mm], y [mm], factor", most_places, "take a coarser grid",
                       64};

std::vector<double> sorted(std::vector<double> values) {
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

std::size_t row_of(const std::vector<double>& positions, double value) {
    return std::ranges::lower_bound(positions, value) - positions.begin();
}

}  // namespace

std::shared_ptr<const contact::FrictionMap> read_friction_map(const std::string& file) {
    const CsvTable table(read_input_file(file), file, map_form);
    table.check_names({"x", "y", "factor"});
    const std::vector<double> x = table.values("x", Dimension::length),
                              factor = table.values("factor", Dimension::none);
    const std::vector<double> y =
        table.has("y") ? table.values("y", Dimension::length) : std::vector<double>{};
    for (std::size_t k = 0; k < factor.size(); ++k)
        if (factor[k] < 0)
            table.refuse_value(k, "factor", "friction carries nothing less than zero",
                               "give the bound over that of the other keys of [friction]");
    std::vector<double> all_x = sorted(x), all_y = sorted(y);
    if (all_x.size() < 2 || all_y.size() == 1)
        table.refuse_value(0, all_x.size() < 2 ? "x" : "y", "there is no other position",
                           "give two positions or more, or leave y out");
    const double unknown = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> grid(all_x.size() * std::max<std::size_t>(1, all_y.size()), unknown);
    for (std::size_t k = 0; k < factor.size(); ++k) {
        const std::size_t place =
            row_of(all_x, x[k]) + (y.empty() ? 0 : row_of(all_y, y[k]) * all_x.size());
        if (!std::isnan(grid[place]))
            table.refuse_value(k, "x", "the same place stands above", "give each place once");
        grid[place] = factor[k];
    }
    if (std::ranges::any_of(grid, [](double one) { return std::isnan(one); }))
        table.refuse_header("some x has no row for some y: the places form no grid");
    return std::make_shared<const contact::FrictionMap>(std::move(all_x), std::move(all_y),
                                                        std::move(grid));
}

}  // namespace tricontact::io
