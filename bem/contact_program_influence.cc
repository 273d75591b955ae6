#include "bem/contact_program_influence.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <string_view>

#include "contact/base/error.h"
#include "files/regular_file.h"

// From K(substrate minus indenter) to CONTACT's A = G K (body 1, the indenter, minus body 2): signs
// and order of columns in docs/reference/contact-program.md, "The file of coefficients". Tangential
// tractions and displacements both change their sign, so that only couplings do.

namespace tricontact::bem {

namespace {

using NineColumns = std::array<double, 9>;

constexpr double mm = 1e3;  // in 1 m

/// nn nx ny xn xx xy yn yx yy of the indenter's displacement less the substrate's, per traction on
/// the indenter, n into it: what couples n with x and y has the other sign than in the table, whose
/// tractions and displacements are the substrate's, z into it. `sign_y`: of the position.
NineColumns of_indenter(const InfluenceCoefficients& k, int sign_y, bool coupled) {
    const double s = sign_y, c = coupled ? 1 : 0;
    return {k.zz,     -c * k.zx(),   -s * c * k.zy(), -c * k.xz, k.xx,
            s * k.xy, -s * c * k.yz, s * k.yx(),      k.yy};
}

constexpr int most_places = 8193;  // along an axis, as in a table of our own
constexpr double unlike = 1e-6;    // of the largest coefficient: what symmetry may be off

/// Numbers of a file whose comments begin with %.
class ProgramNumbers {
  public:
    explicit ProgramNumbers(const std::string& path) try : path_(path), file_(path) {
    } catch (const files::Unreadable& why) {
        throw contact::InputError(
            fmt::format("{}: {}; name a file of influence coefficients", path, why.what()));
    }

    double next(std::string_view what) {
        std::string_view word;
        while ((word = next_word()).empty())
            if (!advance()) refuse(fmt::format("the file ends, but {} is due", what));
        double value = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value))
            refuse(fmt::format("\"{}\" is no number, but {} is due", word.substr(0, 40), what));
        return value;
    }

    int whole(std::string_view what, int least, int most) {
        const double value = next(what);
        if (!(value >= least && value <= most) || value != std::floor(value))
            refuse(fmt::format("{} = {} is not from {} to {}", what, value, least, most));
        return static_cast<int>(value);
    }

    void expect(std::string_view what, int value) {
        const int found = whole(what, 0, 1000);
        if (found != value)
            refuse(fmt::format("{} = {}: only {} is read, as tricontact contact export writes it",
                               what, found, value));
    }

    [[noreturn]] void refuse(const std::string& rule) const {
        throw contact::InputError(
            fmt::format("{}:{}: {}; write the file by tricontact contact export, or correct it",
                        path_, number_, rule));
    }

  private:
    bool advance() {
        try {
            if (!file_.next(line_)) return false;
        } catch (const files::Unreadable& why) {
            throw contact::InputError(fmt::format("{}: {}; name another file", path_, why.what()));
        }
        ++number_;
        rest_ = std::string_view(line_).substr(0, line_.find('%'));
        return true;
    }

    std::string_view next_word() {
        constexpr const char* blanks = " \t\r,";
        rest_.remove_prefix(std::min(rest_.find_first_not_of(blanks), rest_.size()));
        const std::string_view word = rest_.substr(0, rest_.find_first_of(blanks));
        rest_.remove_prefix(word.size());
        return word;
    }

    std::string path_;
    files::LineReader file_;
    std::string line_;
    std::string_view rest_;
    int number_ = 0;
};

/// Reads rows into places of `columns`, ix fastest, iy from 1 - n_y on.
std::vector<NineColumns> read_rows(ProgramNumbers& numbers, int n_x, int n_y) {
    std::vector<NineColumns> rows;
    for (int j = 1 - n_y; j < n_y; ++j)
        for (int i = 0; i < n_x; ++i) {
            if (numbers.whole("ix", 0, most_places) != i)
                numbers.refuse(fmt::format("ix = {} is due, row by row", i));
            numbers.next("x");
            for (double& value : rows.emplace_back()) value = numbers.next("a coefficient");
        }
    return rows;
}

}  // namespace

std::string contact_program_influence(const InfluenceTable& table, double shear_modulus,
                                      bool coupled) {
    std::string text = fmt::format(
        " 1 1   % nmatrix, iaconvex: one matrix, body 1 is convex\n"
        " 0 312 % lquasid, xyzordr: nine columns, n x y\n"
        " 1 0   % lsymmx, lsymmy: only ix >= 0, all iy\n"
        " {} {} {} {} % mx, my, dx, dy\n",
        table.n_x, table.n_y, mm * table.spacing, mm * table.spacing);
    for (int j = 1 - table.n_y; j < table.n_y; ++j) {
        text += fmt::format("% iy = {}\n% ix x nn nx ny xn xx xy yn yx yy\n", j);
        for (int i = 0; i < table.n_x; ++i) {
            NineColumns a = of_indenter(table.at(i, std::abs(j)), j < 0 ? -1 : 1, coupled);
            for (double& value : a) value = mm * shear_modulus * value + 0.0;  // no -0
            fmt::format_to(std::back_inserter(text), " {} {} {}\n", i, mm * table.spacing * i,
                           fmt::join(a, " "));
        }
    }
    return text;
}

InfluenceTable read_contact_program_influence(const std::string& path, double shear_modulus) {
    ProgramNumbers numbers(path);
    for (const auto& [what, value] : {std::pair("nmatrix", 1),
                                      {"iaconvex", 1},
                                      {"lquasid", 0},
                                      {"xyzordr", 312},
                                      {"lsymmx", 1},
                                      {"lsymmy", 0}})
        numbers.expect(what, value);
    InfluenceTable table;
    table.n_x = numbers.whole("mx", 1, most_places);
    table.n_y = numbers.whole("my", 1, most_places);
    const double dx = numbers.next("dx"), dy = numbers.next("dy");
    if (!(dx > 0) || std::abs(dy / dx - 1) > unlike)
        numbers.refuse(fmt::format("dx, dy = {}, {} are no edges of a square", dx, dy));
    table.spacing = dx / mm;
    const auto rows = read_rows(numbers, table.n_x, table.n_y);
    const auto at = [&](int i, int j) {
        return rows[static_cast<std::size_t>(j + table.n_y - 1) * table.n_x + i];
    };
    const double unit = mm * shear_modulus, largest = std::abs(at(0, 0)[0]);
    for (int j = 0; j < table.n_y; ++j)
        for (int i = 0; i < table.n_x; ++i) {
            const auto [nn, nx, ny, xn, xx, xy, yn, yx, yy] = at(i, j);
            // Zero minus: no sign of its own where there is no coupling.
            table.cells.push_back({.xx = xx / unit,
                                   .xy = xy / unit,
                                   .yy = yy / unit,
                                   .xz = 0 - xn / unit,
                                   .yz = 0 - yn / unit,
                                   .zz = nn / unit});
            const InfluenceCoefficients& k = table.cells.back();
            for (const int side : {-1, 1}) {
                const NineColumns mirrored = of_indenter(k, side, true), found = at(i, side * j);
                for (std::size_t n = 0; n < mirrored.size(); ++n)
                    if (j > 0 || side == 1)
                        if (!(std::abs(unit * mirrored[n] - found[n]) <= unlike * largest))
                            numbers.refuse(fmt::format(
                                "the coefficients at ix, iy = {}, {} lack the symmetry of bodies "
                                "whose surfaces are planes: A_xn = -A_nx, A_xy = A_yx, mirrored in "
                                "y",
                                i, side * j));
            }
        }
    return table;
}

}  // namespace tricontact::bem
