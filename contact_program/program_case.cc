#include "contact_program/program_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact_program/distance_reading.h"
#include "contact_program/friction_reading.h"
#include "contact_program/material_reading.h"

namespace tricontact::contact_program {

namespace {

constexpr double millimetre = 1e-3;           // [m]
constexpr double newton_per_square_mm = 1e6;  // 1 N/mm^2 in Pa
constexpr int module_number = 3;
constexpr int most_cells_along = 100000, most_cells = 2'000'000;
constexpr int most_points = 1'000'000;  // inside, along one axis

/// Reads one case after the other; what is not given again is that of the case before.
class CaseReading {
  public:
    CaseReading(std::string text, const std::string& name) : lines_(std::move(text), name) {}

    std::vector<ProgramCase> all() {
        while (enter_module()) {
            do read_case();
            while (cases_.back().digits.after % 2 == 0);
        }
        if (cases_.empty())
            lines_.refuse_line(lines_.line(), "", "the file holds no case of CONTACT's module 3",
                               "name an input file of CONTACT");
        return std::move(cases_);
    }

  private:
    /// False at the end, be it said or not.
    bool enter_module() {
        if (lines_.at_end()) return false;
        const int number = lines_.whole_number("the number of a module");
        if (number != 0 && number != module_number)
            lines_.refuse(fmt::format("module {}", number),
                          "only cases of module 3, the basic one, are read",
                          "describe the contact by its undeformed distance");
        return number != 0;
    }

    void read_case() {
        const bool first = cases_.empty();
        current_ = first ? ProgramCase{} : cases_.back();
        current_.digits = read_case_digits(lines_);
        const CaseDigits& digits = current_.digits;
        if (first) demand_all_new();
        if (digits.debug != 0) lines_.digits(7, "PSFLRIN");
        if (digits.solver != 1) read_solver();
        read_loads();
        if (digits.friction != 1 && digits.variable == 0) read_friction(lines_, current_, 1);
        if (digits.influence >= 2) read_materials();
        if (digits.heat == 3) read_heat(lines_, current_);
        if (digits.heat == 1 && !current_.heat)
            lines_.refuse_line(digits.lines[2], "H = 1", "no case before has data of heat",
                               "give H = 3 and them, or H = 0");
        if (digits.material == 4 && !current_.third_body)
            lines_.refuse_line(digits.lines[1], "M = 4", "no case before has such a layer",
                               "give C = 2 and its data");
        if (digits.cells == 2 && digits.distance == 0)
            lines_.refuse_line(digits.lines[1], "D, Z", "new cells need a new undeformed distance",
                               "give Z = 1 or 2");
        if (digits.cells == 2) read_cells();
        if (digits.distance != 0) place_body();
        if (digits.friction != 1 && digits.variable != 0)
            read_friction(lines_, current_, current_.n_y);
        if (digits.extra == 9)
            lines_.skip_numbers(2 * static_cast<std::size_t>(current_.n_x) * current_.n_y,
                                "the extra slip of all cells");
        current_.has_extra_slip =
            digits.extra == 9 || (digits.extra == 1 && current_.has_extra_slip);
        if (digits.stress >= 2) read_points();
        if (digits.stress == 0) current_.deepest = 0;
        complete_step();
        cases_.push_back(current_);
    }

    void demand_all_new() {
        CaseDigits& d = current_.digits;
        const auto demand = [&](bool is_new, const char* rule) {
            if (!is_new)
                lines_.refuse_line(d.line, rule, "the first case has nothing to go on from",
                                   "give all of its values");
        };
        demand(d.previous == 2, "P = 0");
        demand(d.friction != 1, "L = 1");
        demand(d.cells == 2, "D = 0");
        demand(d.influence >= 2, "C = 0");
        demand(d.distance == 2, "Z = 0");
        demand(d.solver != 1, "G = 1");
        demand(d.stress == 0 || d.stress == 3, "S = 1");
    }

    void demand_positive(const InputNumber& number, const char* name) const {
        if (!(number > 0)) lines_.refuse(name, number, "must be positive", "correct it");
    }

    int count(const InputNumber& number, const char* name, int most) const {
        if (!(number >= 1 && number <= most) || number != std::floor(number))
            lines_.refuse(name, number, fmt::format("must be a whole number from 1 to {}", most),
                          "correct it");
        return static_cast<int>(number);
    }

    void read_solver() {
        const auto v = lines_.numbers(5, "MAXGS, MAXIN, MAXNR, MAXOUT and EPS");
        demand_positive(v[4], "EPS");
        current_.tolerance = v[4];
        constexpr std::size_t further[] = {0, 0, 4, 4, 2, 8};  // by G
        lines_.skip_numbers(further[current_.digits.solver], "the settings of the solver");
    }

    void read_loads() {
        const bool force = current_.digits.normal == 1;
        const auto v = lines_.numbers(
            4, force ? "FN and three tangential values" : "PEN and three tangential values", 2);
        if (force) demand_positive(v[0], "FN");
        current_.loads_line = lines_.line();
        current_.normal = v[0] * (force ? 1 : millimetre);
        SequenceStep& step = current_.step;
        step = {.tangential = current_.digits.tangential != 0};
        if (step.tangential)
            step.motion = static_cast<SequenceStep::Motion>(current_.digits.tangential);
        using Kind = contact::TangentialControl::Kind;
        const bool rolling = step.is_rolling();
        for (const int axis : {0, 1}) {
            const double value = v[1 + axis];  // a force is that on body 1
            if (current_.digits.force > axis)
                step.along[axis].value = value == 0 ? 0 : -value;
            else
                step.along[axis] = {Kind::shift, value * (rolling ? 1 : millimetre)};
        }
        step.rotation = v[3] / (rolling ? millimetre : 1);
        if (v.size() == 6) step.centre = {millimetre * v[4], millimetre * v[5]};
    }

    /// Where the body is and how deep it is pressed, once its distance is known.
    void complete_step() {
        using Kind = contact::NormalControl::Kind;
        const UndeformedDistance& body = current_.distance;
        current_.step.offset = body.offset;
        if (current_.digits.normal == 1) {
            current_.step.normal = {Kind::force, current_.normal};
        } else {
            const double lowest =
                body.heights ? -*std::ranges::min_element(*body.heights) : body.depth;
            current_.step.normal = {Kind::indentation, current_.normal + lowest};
        }
    }

    void read_materials() {
        const int material = current_.digits.material;
        current_.influence = current_.digits.influence;
        if (current_.step.is_rolling()) read_rolling();
        if (current_.influence == 4) {
            const auto v = lines_.numbers(3, "IF_METH, VARIANT and NN");
            lines_.skip_numbers(2 * count(v[2], "NN", 9999), "surface inclinations");
        }
        current_.influence_file =
            current_.influence == 9 ? lines_.text("the file of coefficients") : "";
        const auto v = lines_.numbers(4, "POISS 1,2 and GG 1,2");
        current_.materials_line = lines_.line();
        for (const std::size_t body : {0, 1}) {
            if (!(v[body] >= 0 && v[body] <= 0.5))
                lines_.refuse(body == 0 ? "POISS1" : "POISS2", v[body], "must be from 0 to 0.5",
                              "correct it");
            demand_positive(v[body + 2], body == 0 ? "GG1" : "GG2");
            current_.poisson[body] = v[body];
            current_.shear_modulus[body] = newton_per_square_mm * v[body + 2];
        }
        if (current_.digits.bound == 1) lines_.skip_numbers(1, "FLXZ");
        if (material == 1) read_creep(lines_, current_);
        if (material == 4) read_third_body(lines_, current_);
        constexpr std::size_t further[] = {0, 0, 4, 3, 0, 3, 0, 0};  // by M
        lines_.skip_numbers(further[material], "constants of the material");
    }

    void read_rolling() {
        const auto v = lines_.angle_and_numbers(3, "CHI, DQ and VELOC", 1);
        demand_positive(v[1], "DQ");
        demand_positive(v[2], "VELOC");
        current_.rolling_line = lines_.line();
        current_.direction = v[0];
        current_.step_length = millimetre * v[1];
        current_.speed = millimetre * v[2];
        current_.spin_ahead = v.size() == 4 ? v[3].value : usual_spin_ahead;
    }

    void read_cells() {
        const int way = lines_.whole_number("IPOTCN");
        if (way < -6 || way == 0 || way > 4)
            lines_.refuse(fmt::format("IPOTCN = {}", way), "must be from -6 to -1 or from 1 to 4",
                          "give the cells by 1: first corner and size of a cell");
        current_.is_hertzian = way < 0;
        const bool by_hertz = way < 0 && way > -6;
        const auto v = lines_.numbers(by_hertz ? 5 : 6, "MX, MY and the place of the cells");
        current_.cells_line = lines_.line();
        current_.n_x = count(v[0], "MX", most_cells_along);
        current_.n_y = count(v[1], "MY", most_cells_along);
        if (static_cast<long long>(current_.n_x) * current_.n_y > most_cells)
            lines_.refuse(fmt::format("MX, MY = {}, {}", current_.n_x, current_.n_y),
                          fmt::format("are more than {} cells", most_cells), "take fewer");
        hertz_ = {way, {}};
        if (way > 0)
            place_cells(way, v);
        else
            for (std::size_t k = 2; k < v.size(); ++k) {
                demand_positive(v[k], "a value of IPOTCN < 0");
                hertz_.values.push_back(v[k]);
            }
    }

    /// By corner or centre of the first cell (odd, even pairs), and by size of a cell or the last
    /// corner or centre.
    void place_cells(int way, const std::vector<InputNumber>& v) {
        const bool by_corner = way <= 2, by_size = way % 2 == 1;
        const std::array<int, 2> n{current_.n_x, current_.n_y};
        for (const std::size_t axis : {0, 1}) {
            const double from = millimetre * v[2 + axis];
            InputNumber size = v[4 + axis];
            size.value *= millimetre;
            const int parts = by_corner ? n[axis] : std::max(1, n[axis] - 1);
            if (!by_size) size.value = (size - from) / parts;
            demand_positive(size, axis == 0 ? "DX" : "DY");
            current_.spacing[axis] = size;
            current_.first[axis] = by_corner ? from + size / 2 : from;
        }
    }

    /// The bodies' distance over these cells: a new one, or that which is known (Z = 1).
    void place_body() {
        if (current_.is_hertzian) return place_hertzian();
        if (current_.digits.distance == 2) return read_distance(lines_, current_);
        const UndeformedDistance& known = current_.distance;
        if (!known.heights) return;
        if (known.height_at)
            set_heights(current_, known.height_at);
        else if (known.heights->size() != static_cast<std::size_t>(current_.n_x) * current_.n_y)
            lines_.refuse_line(current_.digits.lines[1], "Z = 1",
                               "the heights that are known are those of other cells",
                               "give Z = 2 and the heights of these");
    }

    void place_hertzian() {
        if (hertz_.way == -6) {  // no ellipse
            current_.distance = {};
            return;
        }
        const HertzianCells cells = hertzian_cells(current_, hertz_, lines_);
        current_.distance = {};
        current_.distance.line = current_.distance.data_line = current_.cells_line;
        current_.distance.curvature = cells.curvature;
        const std::array<int, 2> n{current_.n_x, current_.n_y};
        for (const std::size_t axis : {0, 1}) {
            current_.spacing[axis] = 2 * cells.half_side[axis] / n[axis];
            current_.first[axis] = -cells.half_side[axis] + current_.spacing[axis] / 2;
        }
        // Of the body a single cell sees one point.
        if (current_.n_x == 1 && current_.n_y == 1)
            set_heights(current_, [](double, double) { return 0.; });
    }

    /// Points inside, block by block: only how deep they lie matters.
    void read_points() {
        lines_.numbers(2, "MATFIL and OUTPUT");
        if (current_.digits.stress == 2) return;  // where they are is kept
        current_.deepest = 0;
        while (const int kind = lines_.whole_number("ISUBS")) {
            const bool listed = kind == 3 || kind == 7 || kind == 9;
            if (!listed && kind != 1 && kind != 2 && kind != 5 && kind != 6)
                lines_.refuse(fmt::format("ISUBS = {}", kind),
                              "must be 0, which ends the blocks, 1 to 3, 5 to 7 or 9",
                              "correct it");
            read_block(kind);
        }
    }

    void read_block(int kind) {
        const auto deepen = [&](double z) {
            current_.deepest = std::max(current_.deepest, std::abs(z) * millimetre);
        };
        const auto list = [&](int n, const char* what) {
            for (const InputNumber& z : lines_.numbers(n, what)) deepen(z);
        };
        if (kind == 2 || kind == 6) {
            lines_.skip_numbers(3, "IXL, IXINC and IXH");
            lines_.skip_numbers(3, "IYL, IYINC and IYH");
        }
        const bool rows = kind <= 3;  // of points, equally far from each other
        if (kind == 3 || kind == 7 || kind == 9) {
            const auto n = lines_.numbers(rows ? 2 : 3, rows ? "NX and NY" : "NX, NY and NZ");
            for (const int axis : {0, 1})
                lines_.skip_numbers(count(n[axis], axis == 0 ? "NX" : "NY", most_points),
                                    "places of the points");
            if (!rows) return list(count(n[2], "NZ", most_points), "depths of the points");
        }
        if (!rows) return list(count(lines_.numbers(1, "NZ")[0], "NZ", most_points), "depths");
        const auto z = lines_.numbers(3, "NZ, ZL and DZ");
        deepen(z[1] + (count(z[0], "NZ", most_points) - 1) * z[2]);
    }

    InputLines lines_;
    ProgramCase current_;
    HertzInput hertz_;
    std::vector<ProgramCase> cases_;
};

}  // namespace

std::vector<ProgramCase> read_program_cases(std::string text, const std::string& name) {
    return CaseReading(std::move(text), name).all();
}

}  // namespace tricontact::contact_program
