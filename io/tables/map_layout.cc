#include "io/tables/map_layout.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "io/keys/messages.h"
#include "io/keys/number_text.h"

namespace tricontact::io {

namespace {

constexpr double equal_steps = .02;        // of coordinates, which are printed with few digits [-]
constexpr std::size_t fewest_listed = 16;  // rows of a list of nodes that is told from a map

/// Coordinates of nodes at equal distances, ascending.
struct Axis {
    double first = 0, step = 0;
    std::size_t n = 0;

    std::size_t index(double x) const {
        return static_cast<std::size_t>(std::lround((x - first) / step));
    }
};

/// v_k = v_0 + k step, step not 0.
std::optional<double> even_step(const std::vector<double>& v) {
    if (v.size() < 3) return {};
    const double step = (v.back() - v.front()) / static_cast<double>(v.size() - 1);
    if (step == 0 || !std::isfinite(step)) return {};
    for (std::size_t k = 0; k < v.size(); ++k)
        if (!(std::abs(v[k] - v.front() - static_cast<double>(k) * step) <=
              equal_steps * std::abs(step)))
            return {};
    return step;
}

std::vector<double> values_of_row(const NumberMatrix& m, std::size_t row, std::size_t first) {
    std::vector<double> out;
    for (std::size_t i = first; i < m.n_columns; ++i) out.push_back(m.at(i, row));
    return out;
}

std::vector<double> values_of_column(const NumberMatrix& m, std::size_t column, std::size_t first) {
    std::vector<double> out;
    for (std::size_t j = first; j < m.n_rows; ++j) out.push_back(m.at(column, j));
    return out;
}

/// The distinct values of a column as an axis; empty where they are not evenly spaced.
std::optional<Axis> axis_of(std::vector<double> values) {
    std::ranges::sort(values);
    const double range = values.back() - values.front();
    if (!(range > 0)) return {};
    // Rounded to the digits of the file, but nearer than nodes are.
    const double same = 1e-3 * range / std::sqrt(static_cast<double>(values.size()));
    std::vector<double> nodes{values.front()};
    for (const double value : values)
        if (value - nodes.back() > same) nodes.push_back(value);
    if (nodes.size() == 2) return Axis{nodes[0], nodes[1] - nodes[0], 2};
    const auto step = even_step(nodes);
    if (!step) return {};
    return Axis{nodes.front(), *step, nodes.size()};
}

std::string number_text(double value) {
    return shortest(value);
}

/// The unit that coordinates of this step have, if the nodes are `spacing` apart [m].
void check_coordinates(double step, double spacing, const std::string& name) {
    const double unit = spacing / std::abs(step), decade = std::log10(unit);
    const bool counts = std::abs(std::abs(step) - 1) <= equal_steps;
    constexpr double tolerance = .01;  // of log10: coordinates are rounded
    if (counts || std::abs(decade - std::round(decade)) <= tolerance) return;
    fail(name, "",
         "its coordinates step by " + number_text(std::abs(step)) +
             " from node to node, which is no " + number_text(spacing) +
             " m in any unit that is a power of ten of the metre",
         "give indenter.spacing the step with its unit");
}

contact::HeightMap empty_map(std::size_t n_x, std::size_t n_y, const contact::Vector2& spacing,
                             const char* layout) {
    return {static_cast<int>(n_x), static_cast<int>(n_y), spacing, std::vector<double>(n_x * n_y),
            layout};
}

void check_nodes(double n_x, double n_y, const std::string& name) {
    if (n_x * n_y > most_height_nodes)
        fail(name, "", "more than 4096 x 4096 heights",
             "thin the surface out, or save a part of it");
    if (n_x < 2 || n_y < 2)
        fail(name, "", "holds " + number_text(n_y) + " x " + number_text(n_x) + " heights",
             "give 2 x 2 at least");
}

/// x, y, z: each node of a lattice once.
std::optional<contact::HeightMap> listed(const NumberMatrix& m, const std::string& name,
                                         const HeightMapScale& scale) {
    constexpr std::size_t most_channels = 8;
    if (m.n_columns < 3 || m.n_rows < 4 || m.n_columns > most_channels) return {};
    if (m.n_columns > 3 && m.n_rows < fewest_listed) return {};
    const auto x = axis_of(values_of_column(m, 0, 0)), y = axis_of(values_of_column(m, 1, 0));
    if (!x || !y || x->n * y->n != m.n_rows) return {};
    std::vector<bool> seen(m.n_rows);
    for (std::size_t k = 0; k < m.n_rows; ++k) {
        const std::size_t i = x->index(m.at(0, k)), j = y->index(m.at(1, k));
        if (i >= x->n || j >= y->n || seen[j * x->n + i]) return {};
        seen[j * x->n + i] = true;
    }
    if (m.n_columns > 3)
        fail(name, "",
             "holds x and y of each node and " + std::to_string(m.n_columns - 2) +
                 " further columns, of which one alone is the height",
             "keep three columns: x, y and height");
    check_coordinates(x->step, scale.spacing, name);
    auto map = empty_map(x->n, y->n, {scale.spacing, scale.spacing * y->step / x->step},
                         "x y z of each node");
    for (std::size_t k = 0; k < m.n_rows; ++k)
        map.at(static_cast<int>(x->index(m.at(0, k))), static_cast<int>(y->index(m.at(1, k)))) =
            scaled(m.at(2, k), scale.unit, name);
    return map;
}

/// h = a + b i + c j + d i j throughout, as of an inclined plane.
bool is_bilinear(const NumberMatrix& m) {
    const double corner = m.at(0, 0);
    const double twist = m.at(1, 1) - m.at(1, 0) - m.at(0, 1) + corner;
    const auto [low, high] = std::ranges::minmax(m.value);
    for (std::size_t j = 0; j < m.n_rows; ++j)
        for (std::size_t i = 0; i < m.n_columns; ++i) {
            const double plane = m.at(i, 0) + m.at(0, j) - corner +
                                 twist * static_cast<double>(i) * static_cast<double>(j);
            if (!(std::abs(m.at(i, j) - plane) <= 1e-3 * (high - low))) return false;
        }
    return true;
}

/// Heights with a row and a column of coordinates, whose corner means nothing.
std::optional<contact::HeightMap> framed(const NumberMatrix& m, const std::string& name,
                                         const HeightMapScale& scale, bool is_text) {
    if (m.n_columns < 4 || m.n_rows < 4) return {};
    const auto x_step = even_step(values_of_row(m, 0, 1)),
               y_step = even_step(values_of_column(m, 0, 1));
    const double corner = m.at(0, 0);
    const auto last_row = values_of_row(m, m.n_rows - 1, 1),
               last_column = values_of_column(m, m.n_columns - 1, 1);
    if (std::isfinite(corner)) {
        if (is_bilinear(m)) return {};
        const auto continues = [&](double next, std::optional<double> step) {
            return step && std::abs(next - corner - *step) <= equal_steps * std::abs(*step);
        };
        const bool row_goes_on = continues(m.at(1, 0), x_step) && !even_step(last_row),
                   column_goes_on = continues(m.at(0, 1), y_step) && !even_step(last_column);
        const std::string remedy =
            "leave coordinates out; save heights that are even there as .npy";
        if (!is_text && (!x_step || !y_step || (row_goes_on && column_goes_on))) return {};
        if (row_goes_on && column_goes_on)
            fail(name, "",
                 "its first row and column rise evenly, as coordinates do, and the others do not",
                 remedy);
        if (row_goes_on && !y_step)
            fail(name + ":1", "", "the row rises evenly, as coordinates do, and the last does not",
                 remedy);
        if (column_goes_on && !x_step)
            fail(name, "",
                 "its first column rises evenly, as coordinates do, and the last does not", remedy);
        if (continues(m.at(1, 0), x_step) && continues(m.at(0, 1), y_step)) return {};
    }
    if (!x_step || !y_step) return {};
    check_coordinates(*x_step, scale.spacing, name);
    const std::size_t n_x = m.n_columns - 1, n_y = m.n_rows - 1;
    auto map = empty_map(n_x, n_y, {scale.spacing, scale.spacing * std::abs(*y_step / *x_step)},
                         "heights below a row and beside a column of coordinates");
    for (std::size_t j = 0; j < n_y; ++j)
        for (std::size_t i = 0; i < n_x; ++i) {
            const std::size_t to_i = *x_step > 0 ? i : n_x - 1 - i,
                              to_j = *y_step > 0 ? j : n_y - 1 - j;
            map.at(static_cast<int>(to_i), static_cast<int>(to_j)) =
                scaled(m.at(i + 1, j + 1), scale.unit, name);
        }
    return map;
}

}  // namespace

contact::HeightMap laid_out(const NumberMatrix& m, const std::string& name,
                            const HeightMapScale& scale, bool is_text) {
    if (const auto map = listed(m, name, scale)) return *map;
    if (is_text && m.n_columns == 3 && m.n_rows >= fewest_listed)
        fail(name, "",
             std::to_string(m.n_rows) +
                 " rows of three numbers are not x, y and height of each node of a regular lattice",
             "interpolate them to one; save a map of three nodes along x as .npy");
    if (const auto map = framed(m, name, scale, is_text)) return *map;
    check_nodes(static_cast<double>(m.n_columns), static_cast<double>(m.n_rows), name);
    if (!std::isfinite(m.value.front()))
        fail(name + (is_text ? ":1" : ""), "", "the first height is missing",
             "interpolate missing values first");
    auto map = empty_map(m.n_columns, m.n_rows, {scale.spacing, scale.spacing},
                         is_text ? "rows of heights" : "an array of heights");
    for (std::size_t k = 0; k < m.value.size(); ++k)
        map.height[k] = scaled(m.value[k], scale.unit, name);
    return map;
}

}  // namespace tricontact::io
