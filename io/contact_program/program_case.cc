#include "io/contact_program/program_case.h"

#include <fmt/format.h>

#include <cmath>

namespace tricontact::io {

namespace {

constexpr double millimetre = 1e-3;           // [m]
constexpr double newton_per_square_mm = 1e6;  // 1 N/mm^2 in Pa
constexpr int module_number = 3;
constexpr int most_cells_along = 100000;

/// A digit, what it may be, why not something else, and its place among those that are read.
struct Digit {
    char letter;
    std::string_view allowed, rule, remedy;
    int CaseDigits::*place = nullptr;
};

constexpr std::string_view any = "0123456789";

const std::vector<Digit> first_word = {
    {'P', "02", "a case goes on from the one before or begins again", "give 0 or 2",
     &CaseDigits::previous},
    {'B', "0", "only the full normal problem is solved", "give 0"},
    {'T', "01", "only shifts in world-fixed coordinates are cases here",
     "give 0 or 1; what rolls on is computed by tricontact roll", &CaseDigits::tangential},
    {'N', "01", "depth or normal force is prescribed", "give 0 or 1", &CaseDigits::normal},
    {'F', "012", "shifts or forces are prescribed", "give 0, 1 or 2", &CaseDigits::force},
    {'S', "0", "stresses inside are asked for by output.volume of the case", "give 0"},
};
const std::vector<Digit> second_word = {
    {'V', "0", "friction is the same everywhere", "give 0"},
    {'L', "01", "only Coulomb friction is a case here", "give 0, or 1 to keep it",
     &CaseDigits::friction},
    {'D', "02", "cells are new or kept", "give 0 or 2", &CaseDigits::cells},
    {'C', "02",
     "only half-spaces with constant tractions per cell are read; coefficients of a "
     "file do not tell the layer",
     "give 0 or 2", &CaseDigits::influence},
    {'M', "0", "only elastic bodies are cases here", "give 0"},
    {'Z', "02", "undeformed distances are new or kept", "give 0 or 2", &CaseDigits::distance},
    {'E', "0", "no further term of slip is a case here", "give 0"},
};
const std::vector<Digit> third_word = {
    {'X', "0", "debug output has lines of its own", "give 0"},
    {'H', "0", "no temperatures are computed", "give 0"},
    {'G', "01", "settings of other solvers have no counterpart", "give 0 or 1",
     &CaseDigits::solver},
    {'I', any, "", ""},
    {'A', any, "", ""},
    {'O', any, "", ""},
    {'W', any, "", ""},
    {'R', "01", "every case is computed", "give 0 or 1", &CaseDigits::after},
};

void read_word(InputLines& lines, const std::vector<Digit>& declared, CaseDigits& digits) {
    std::string letters;
    for (const Digit& digit : declared) letters += digit.letter;
    const std::vector<int> values = lines.digits(declared.size(), letters);
    for (std::size_t k = 0; k < values.size(); ++k) {
        const Digit& digit = declared[k];
        if (digit.allowed.find(static_cast<char>('0' + values[k])) == std::string_view::npos)
            lines.refuse(fmt::format("{} = {}", digit.letter, values[k]), digit.rule, digit.remedy);
        if (digit.place) digits.*digit.place = values[k];
    }
}

/// What no case file here says is refused with the digit's letter.
CaseDigits read_digits(InputLines& lines) {
    CaseDigits digits;
    read_word(lines, first_word, digits);
    digits.line = lines.line();
    read_word(lines, second_word, digits);
    read_word(lines, third_word, digits);
    return digits;
}

/// Reads one case after the other; what is not given again is that of the case before.
class CaseReading {
  public:
    CaseReading(std::string text, const std::string& name) : lines_(std::move(text), name) {}

    std::vector<ProgramCase> all() {
        while (enter_module()) {
            do read_case();
            while (cases_.back().digits.after == 0);
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
        current_.digits = read_digits(lines_);
        if (first) demand_all_new();
        const CaseDigits& digits = current_.digits;
        if (digits.solver == 0) read_solver();
        read_loads();
        if (digits.friction == 0) read_friction();
        if (digits.influence != 0) read_materials();
        if (digits.cells != 0) read_cells();
        if (digits.distance != 0) read_distance();
        cases_.push_back(current_);
    }

    void demand_all_new() {
        const CaseDigits& d = current_.digits;
        const auto demand = [&](bool is_new, const char* rule) {
            if (!is_new)
                lines_.refuse_line(d.line, rule, "the first case has nothing to go on from",
                                   "give all of its values");
        };
        demand(d.previous == 2, "P = 0");
        demand(d.friction == 0, "L = 1");
        demand(d.cells != 0, "D = 0");
        demand(d.influence != 0, "C = 0");
        demand(d.distance != 0, "Z = 0");
        demand(d.solver == 0, "G = 1");
    }

    void demand_positive(const InputNumber& number, const char* name) const {
        if (!(number > 0)) lines_.refuse(name, number, "must be positive", "correct it");
    }

    int cells_along(const InputNumber& number, const char* name) const {
        if (!(number >= 1 && number <= most_cells_along) || number != std::floor(number))
            lines_.refuse(name, number,
                          fmt::format("must be a whole number from 1 to {}", most_cells_along),
                          "correct it");
        return static_cast<int>(number);
    }

    void read_solver() {
        const auto v = lines_.numbers(5, "MAXGS, MAXIN, MAXNR, MAXOUT and EPS");
        demand_positive(v[4], "EPS");
        current_.tolerance = v[4];
    }

    void read_loads() {
        const bool force = current_.digits.normal == 1;
        const auto v = lines_.numbers(
            4, force ? "FN and three tangential values" : "PEN and three tangential values");
        demand_positive(v[0], force ? "FN" : "PEN");
        if (v[3] != 0) lines_.refuse("CPHI", v[3], "no case here is turned", "give 0");
        current_.loads_line = lines_.line();
        current_.normal = v[0] * (force ? 1 : millimetre);
        const int forces = current_.digits.force;
        current_.tangential = {v[1] * (forces >= 1 ? 1 : millimetre),
                               v[2] * (forces == 2 ? 1 : millimetre)};
    }

    void read_friction() {
        constexpr double same = 1e-3;  // as CONTACT asks for
        const auto v = lines_.numbers(2, "FSTAT and FKIN");
        demand_positive(v[0], "FSTAT");
        if (std::abs(v[1] - v[0]) > same * v[0])
            lines_.refuse("FKIN", v[1], "must be FSTAT in Coulomb friction", "correct it");
        current_.friction_coefficient = v[0];
    }

    void read_materials() {
        const auto v = lines_.numbers(4, "POISS 1,2 and GG 1,2");
        for (const std::size_t body : {0, 1}) {
            if (!(v[body] >= 0 && v[body] <= 0.5))
                lines_.refuse(body == 0 ? "POISS1" : "POISS2", v[body], "must be from 0 to 0.5",
                              "correct it");
            demand_positive(v[body + 2], body == 0 ? "GG1" : "GG2");
            current_.poisson[body] = v[body];
            current_.shear_modulus[body] = newton_per_square_mm * v[body + 2];
        }
    }

    void read_cells() {
        const int way = lines_.whole_number("IPOTCN");
        if (way < -5 || way == 0 || way > 4)
            lines_.refuse(fmt::format("IPOTCN = {}", way), "must be from -5 to -1 or from 1 to 4",
                          "give the cells by 1: first corner and size of a cell");
        current_.is_hertzian = way < 0;
        const auto v = lines_.numbers(way < 0 ? 5 : 6, "MX, MY and the place of the cells");
        current_.cells_line = lines_.line();
        current_.n_x = cells_along(v[0], "MX");
        current_.n_y = cells_along(v[1], "MY");
        if (way > 0) place_cells(way, v);
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

    void read_distance() {
        current_.curvature = current_.offset = {};
        if (current_.is_hertzian) return;  // nothing is given
        const auto kind = lines_.numbers(2, "IBASE and IPLAN");
        if (kind[0] != 1)
            lines_.refuse("IBASE", kind[0], "only quadratic undeformed distances tell the body",
                          "give 1, or describe the body in a case file");
        if (kind[1] != 1)
            lines_.refuse("IPLAN", kind[1], "no planform is cut out of the cells", "give 1");
        const auto b = lines_.numbers(6, "B(1) to B(6)");
        current_.distance_line = lines_.line();
        if (b[1] != 0)
            lines_.refuse("B(2)", b[1], "the body's axes must be those of x and y",
                          "turn the axes");
        const double curved[] = {b[0] / millimetre, b[2] / millimetre};
        const double inclined[] = {b[3], b[4]};
        for (const std::size_t axis : {0, 1}) {
            if (curved[axis] < 0 || (curved[axis] == 0 && (axis == 0 || inclined[axis] != 0)))
                lines_.refuse(axis == 0 ? "B(1)" : "B(3)", b[2 * axis], "a body must be convex",
                              "correct it");
            current_.curvature[axis] = curved[axis];
            current_.offset[axis] = curved[axis] == 0 ? 0 : -inclined[axis] / (2 * curved[axis]);
        }
        check_lowest_point(b[5]);
    }

    /// The offset's lowest point has the height zero: the depth d is counted from there.
    void check_lowest_point(const InputNumber& given) {
        constexpr double allowed = 1e-2;  // of the height over a cell: files are rounded
        double height = 0, over_cell = 0;
        for (const std::size_t axis : {0, 1}) {
            const double a = current_.curvature[axis];
            height += a * std::pow(current_.offset[axis], 2);
            over_cell += a * std::pow(current_.spacing[axis], 2);
        }
        if (!(std::abs(millimetre * given - height) <= allowed * over_cell))
            lines_.refuse("B(6)", given,
                          fmt::format("leaves the lowest point beside the height 0, where it would "
                                      "be with {:.6g}",
                                      height / millimetre),
                          "correct it");
    }

    InputLines lines_;
    ProgramCase current_;
    std::vector<ProgramCase> cases_;
};

}  // namespace

std::vector<ProgramCase> read_program_cases(std::string text, const std::string& name) {
    return CaseReading(std::move(text), name).all();
}

}  // namespace tricontact::io
