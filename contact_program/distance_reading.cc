#include "contact_program/distance_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/bodies/ellipsoid.h"
#include "contact_program/case_parts.h"

namespace tricontact::contact_program {

namespace {

constexpr double mm = 1e-3;              // [m]
constexpr double most_slender = 1e3;     // a/b of an ellipse
constexpr int most_heights = 1'000'000;  // of IBASE = 2

/// R_y of the body of this R_x whose contact has a_y/a_x = ratio.
double radius_across(double radius_x, double ratio) {
    double low = 1e-8, high = 1e8;  // R_y over R_x; a_y/a_x grows with it
    for (int k = 0; k < 100; ++k) {
        const double middle = std::sqrt(low * high);
        (contact::ellipse_ratio(radius_x, radius_x * middle) < ratio ? low : high) = middle;
    }
    return radius_x * std::sqrt(low * high);
}

/// What the loads make of the contact of half axis 1 m, whose force grows by the third power of the
/// axis and whose depth by the second.
double semi_axis(const ProgramCase& one, double radius_x, double ratio) {
    const auto unit = contact::elliptic_contact(radius_x, ratio, 1);
    return one.digits.normal == 1
               ? std::cbrt(one.normal / materials_of(one).effective_modulus() / unit.normal_force)
               : std::sqrt(one.normal / unit.indentation);
}

HertzianCells elliptic_cells(const ProgramCase& one, const HertzInput& input,
                             const InputLines& lines) {
    const auto& v = input.values;
    double ratio = 0, radius_x = 0, a = 0;
    if (input.way == -3) {  // both half axes
        ratio = v[1] / v[0];
        a = mm * v[0];
    } else {
        radius_x = mm / (2 * v[0]);
        ratio = input.way == -2 ? 1 / v[1] : v[1] / v[0];
    }
    if (!(ratio <= most_slender && ratio >= 1 / most_slender))
        lines.refuse("the second value of IPOTCN < 0", v[1],
                     fmt::format("makes the contact more slender than 1 : {}", most_slender),
                     "give IPOTCN = -4 or -5 for a line contact");
    if (input.way == -1) ratio = contact::ellipse_ratio(radius_x, mm / (2 * v[1]));
    if (input.way == -3) {
        const auto unit = contact::elliptic_contact(1, ratio, a);  // loads are as 1/R_x
        radius_x = one.digits.normal == 1
                       ? unit.normal_force * materials_of(one).effective_modulus() / one.normal
                       : unit.indentation / one.normal;
    } else {
        a = semi_axis(one, radius_x, ratio);
    }
    const double radius_y = input.way == -1 ? mm / (2 * v[1]) : radius_across(radius_x, ratio);
    return {{1 / (2 * radius_x), 1 / (2 * radius_y)}, {v[2] * a, v[2] * a * ratio}};
}

/// A line contact of the length 2 BB: a^2 = 4 (F/L) R/(pi E*).
HertzianCells line_cells(const ProgramCase& one, const HertzInput& input, const InputLines& lines) {
    if (one.digits.normal != 1)
        lines.refuse_line(one.cells_line, fmt::format("IPOTCN = {}", input.way),
                          "a line contact has no depth of its own", "give N = 1 and FN");
    const auto& v = input.values;
    const double half_length = mm * v[1];
    const double grown = 4 * one.normal / (2 * half_length) /
                         (std::numbers::pi * materials_of(one).effective_modulus());
    const double a = input.way == -5 ? mm * v[0] : std::sqrt(grown * mm / (2 * v[0]));
    return {{grown / (2 * a * a), 0}, {v[2] * a, half_length}};
}

class DistanceReading {
  public:
    DistanceReading(InputLines& lines, ProgramCase& one) : lines_(lines), one_(one) {}

    void read() {
        const auto kind = lines_.numbers(2, "IBASE and IPLAN");
        UndeformedDistance& distance = one_.distance = {};
        distance.line = lines_.line();
        if (kind[0] == 1)
            read_quadratic();
        else if (kind[0] == 2)
            read_circular();
        else if (kind[0] == 3)
            read_sines();
        else if (kind[0] == 9)
            read_heights();
        else
            lines_.refuse("IBASE", kind[0], "must be 1, 2, 3 or 9", "correct it");
        const double planform = kind[1];
        if (planform == 2) lines_.skip_numbers(6, "the planform");
        if (planform == 3) lines_.skip_numbers(8, "the planform");
        if (planform == 4) skip_patches();
        if (planform != std::floor(planform) || !(planform >= 1 && planform <= 4))
            lines_.refuse("IPLAN", kind[1], "must be from 1 to 4", "correct it");
        distance.planform = static_cast<int>(planform);
    }

  private:
    void read_quadratic() {
        const auto b = lines_.numbers(6, "B(1) to B(6)");
        UndeformedDistance& distance = one_.distance;
        distance.data_line = lines_.line();
        distance.is_turned = b[1] != 0;
        const double curved[] = {b[0] / mm, b[2] / mm};
        double height = 0, over_cell = 0;
        for (const std::size_t axis : {0, 1}) {
            const double inclined = b[3 + axis];
            distance.curvature[axis] = curved[axis];
            distance.is_inclined |= curved[axis] == 0 && inclined != 0;
            if (curved[axis] == 0) continue;
            distance.offset[axis] = -inclined / (2 * curved[axis]);
            height += curved[axis] * std::pow(distance.offset[axis], 2);
            over_cell += std::abs(curved[axis]) * std::pow(one_.spacing[axis], 2);
        }
        constexpr double allowed = 1e-2;  // of the height over a cell: files are rounded
        distance.depth = height - mm * b[5];
        if (std::abs(distance.depth) <= allowed * over_cell) distance.depth = 0;
    }

    void read_circular() {
        const auto v = lines_.numbers(5, "NN, XM, RM, Y1 and DY1");
        if (!(v[0] >= 2 && v[0] <= most_heights) || v[0] != std::floor(v[0]))
            lines_.refuse("NN", v[0],
                          fmt::format("must be a whole number from 2 to {}", most_heights),
                          "correct it");
        for (const std::size_t k : {2, 4})
            if (!(v[k] > 0))
                lines_.refuse(k == 2 ? "RM" : "DY1", v[k], "must be positive", "correct it");
        const auto along_y = lines_.numbers(static_cast<std::size_t>(v[0]), "heights along y");
        one_.distance.data_line = lines_.line();
        const bool level = std::ranges::all_of(
            along_y, [&](const InputNumber& h) { return h.value == along_y[0].value; });
        if (level) {
            one_.distance.curvature = {1 / (2 * mm * v[2]), 0};
            one_.distance.offset = {mm * v[1], 0};
            one_.distance.depth = -mm * along_y[0];
            return;
        }
        set_heights(one_, [v, along_y](double x, double y) {
            const double place = (y / mm - v[3]) / v[4];
            const auto last = static_cast<double>(along_y.size() - 2);
            const auto k = static_cast<std::size_t>(std::clamp(std::floor(place), 0., last));
            const double share = place - static_cast<double>(k);
            return std::pow(x - mm * v[1], 2) / (2 * mm * v[2]) +
                   mm * (along_y[k] + share * (along_y[k + 1] - along_y[k]));
        });
    }

    /// Hertz' body with two waves along x.
    void read_sines() {
        const auto b = lines_.numbers(8, "B(1) to B(8)");
        one_.distance.data_line = lines_.line();
        for (const std::size_t k : {6, 7})
            if (!(b[k] > 0))
                lines_.refuse(fmt::format("B({})", k + 1), b[k], "must be positive", "correct it");
        set_heights(one_, [b](double x, double y) {
            x /= mm;
            y /= mm;
            return mm * (b[0] * std::sin(b[1] * (x - b[2])) - b[3] * std::sin(b[4] * (x - b[5])) +
                         x * x / b[6] + y * y / b[7]);
        });
    }

    void read_heights() {
        const auto v =
            lines_.numbers(static_cast<std::size_t>(one_.n_x) * one_.n_y, "heights of all cells");
        one_.distance.data_line = lines_.line();
        auto heights = std::make_shared<std::vector<double>>();
        for (const InputNumber& h : v) heights->push_back(mm * h);
        one_.distance.heights = std::move(heights);
    }

    /// Patches that act upon each other only in part.
    void skip_patches() {
        const int n = lines_.whole_number("NPATCH");
        constexpr int most = 100;
        if (n < 1 || n > most)
            lines_.refuse(fmt::format("NPATCH = {}", n), fmt::format("must be from 1 to {}", most),
                          "correct it");
        lines_.skip_numbers(n - 1, "YSEP");
        lines_.skip_numbers(static_cast<std::size_t>(n) * (n - 1) / 2, "factors of the patches");
    }

    InputLines& lines_;
    ProgramCase& one_;
};

}  // namespace

HertzianCells hertzian_cells(const ProgramCase& one, const HertzInput& input,
                             const InputLines& lines) {
    if (!(one.normal > 0))
        lines.refuse_line(one.loads_line, "PEN", "a Hertzian contact has a positive depth",
                          "correct it");
    const HertzianCells cells =
        input.way >= -3 ? elliptic_cells(one, input, lines) : line_cells(one, input, lines);
    const auto fits = [](double value) { return value > 0 && std::isfinite(value); };
    if (!fits(cells.curvature[0]) || !(cells.curvature[1] >= 0) || !fits(cells.half_side[0]) ||
        !fits(cells.half_side[1]) || !std::isfinite(cells.curvature[1]))
        lines.refuse_line(one.cells_line, "IPOTCN < 0", "leads to no contact of finite size",
                          "correct the loads and the values");
    return cells;
}

void set_heights(ProgramCase& one, std::function<double(double x, double y)> height) {
    auto heights = std::make_shared<std::vector<double>>();
    for (int j = 0; j < one.n_y; ++j)
        for (int i = 0; i < one.n_x; ++i)
            heights->push_back(
                height(one.first[0] + i * one.spacing[0], one.first[1] + j * one.spacing[1]));
    one.distance.heights = std::move(heights);
    one.distance.height_at = std::move(height);
}

void read_distance(InputLines& lines, ProgramCase& one) {
    DistanceReading(lines, one).read();
}

}  // namespace tricontact::contact_program
