#include "bem/influence_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <iterator>

#include "contact/base/error.h"
#include "contact/base/special_values.h"
#include "files/regular_file.h"

// The format is docs/reference/influence-format.md: text, so that other programs can write it.

namespace tricontact::bem {

namespace {

constexpr std::string_view title = influence_file_title;
constexpr int version = 1;
constexpr std::string_view components = "xx xy xz yx yy yz zx zy zz";
constexpr int most_positions = 8193;  // of the largest grid, zero-padded
// Of the coefficient of a cell under itself: what other programs' tables may be off.
constexpr double asymmetry = 1e-6;
constexpr double same_spacing = 1e-9;  // spacings that differ by rounding

using Nine = std::array<double, 9>;

/// The difference to zero has no sign of its own where the coefficient is zero.
Nine nine(const InfluenceCoefficients& k) {
    return {k.xx, k.xy, k.xz, k.yx(), k.yy, k.yz, 0 - k.xz, 0 - k.yz, k.zz};
}

/// The lines of a file that say something, one after the other.
class Lines {
  public:
    explicit Lines(const std::string& path) try : path_(path), file_(path) {
    } catch (const files::Unreadable& why) {
        const bool missing = why.error() == ENOENT;
        throw contact::InputError(fmt::format(
            "{}: {}; {}", path,
            missing ? "there is no such file of influence coefficients" : why.what(), write_one));
    }

    std::string_view next() {
        while (read()) {
            ++number_;
            if (!line_.empty() && line_.back() == '\r') line_.pop_back();
            if (!line_.empty() && line_[0] != '#') return line_;
        }
        ++number_;
        refuse("the file ends here, but is not complete", "write it again");
    }

    [[noreturn]] void refuse(const std::string& rule, const std::string& remedy) const {
        throw contact::InputError(fmt::format("{}:{}: {}; {}", path_, number_, rule, remedy));
    }

  private:
    bool read() {
        try {
            return file_.next(line_);
        } catch (const files::Unreadable& why) {
            throw contact::InputError(fmt::format("{}: {}; {}", path_, why.what(), write_one));
        }
    }

    static constexpr const char* write_one = "write one by tricontact influence";
    std::string path_;
    files::LineReader file_;
    std::string line_;
    int number_ = 0;
};

std::string_view first_word(std::string_view& rest) {
    rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
    const auto end = std::min(rest.find_first_of(" \t"), rest.size());
    const std::string_view word = rest.substr(0, end);
    rest.remove_prefix(end);
    return word;
}

template <class Number>
Number number(std::string_view& rest, const Lines& lines) {
    const std::string_view word = first_word(rest);
    Number value{};
    const bool plus = word.size() > 1 && word[0] == '+' && word[1] != '-';  // not for from_chars
    const auto [end, error] =
        std::from_chars(word.data() + (plus ? 1 : 0), word.data() + word.size(), value);
    if (word.empty() || error != std::errc() || end != word.data() + word.size())
        lines.refuse(fmt::format("\"{}\" is no number", word.substr(0, 40)),
                     "numbers look like 1.5e-12, with blanks between them");
    return value;
}

void expect_end(std::string_view rest, const Lines& lines) {
    const std::string_view more = first_word(rest);
    if (!more.empty())
        lines.refuse(fmt::format("\"{}\" is more than the line may hold", more.substr(0, 40)),
                     "omit it");
}

/// The rest of a line that has to begin with `key`.
std::string_view after(std::string_view key, Lines& lines) {
    std::string_view line = lines.next();
    const std::string_view word = first_word(line);
    if (word != key)
        lines.refuse(fmt::format("\"{}\" where \"{}\" is due", word.substr(0, 40), key),
                     "keep the order of docs/reference/influence-format.md");
    return line;
}

template <class Number>
Number value_of(std::string_view key, Lines& lines) {
    std::string_view rest = after(key, lines);
    const auto value = number<Number>(rest, lines);
    expect_end(rest, lines);
    return value;
}

int positions_of(std::string_view key, Lines& lines) {
    const int n = value_of<int>(key, lines);
    if (n < 1 || n > most_positions)
        lines.refuse(fmt::format("{} = {} is not between 1 and {}", key, n, most_positions),
                     "correct it");
    return n;
}

void check_title(Lines& lines) {
    std::string_view line = lines.next();
    if (!line.starts_with(title))
        lines.refuse("this is no file of influence coefficients",
                     fmt::format("its first line has to be \"{}{}\"", title, version));
    line.remove_prefix(title.size());
    const int found = number<int>(line, lines);
    if (found != version)
        lines.refuse(fmt::format("version {} is not {}, the only one known", found, version),
                     "write the file again by tricontact influence");
}

Nine values_at(int i, int j, Lines& lines) {
    std::string_view rest = lines.next();
    const int i_found = number<int>(rest, lines), j_found = number<int>(rest, lines);
    if (i_found != i || j_found != j)
        lines.refuse(fmt::format("position {} {} where {} {} is due", i_found, j_found, i, j),
                     "give every position once, i running fastest");
    Nine values{};
    for (double& value : values) {
        value = number<double>(rest, lines);
        if (!std::isfinite(value))
            lines.refuse(fmt::format("{} is no finite number", value), "correct it");
    }
    expect_end(rest, lines);
    return values;
}

void check_symmetry(const Nine& k, int i, int j, double own, const Lines& lines) {
    const auto [xx, xy, xz, yx, yy, yz, zx, zy, zz] = k;
    const auto demand = [&](double zero, const char* rule) {
        if (!(std::abs(zero) <= asymmetry * own))
            lines.refuse(fmt::format("K_{} at {} {} is broken by {:.3g} m/Pa", rule, i, j, zero),
                         "correct the signs: tractions act on the substrate, z points into it");
    };
    demand(xy - yx, "xy = K_yx");
    demand(xz + zx, "xz = -K_zx");
    demand(yz + zy, "yz = -K_zy");
    if (i == 0) demand(xz, "xz = 0 on x = 0");
    if (j == 0) demand(yz, "yz = 0 on y = 0");
    if (i == 0 || j == 0) demand(xy, "xy = 0 on the axes");
}

}  // namespace

bool couples(const InfluenceTable& table) {
    constexpr double negligible = 2e-3;  // more than half-spaces have that bem takes as uncoupled
    return std::ranges::any_of(table.cells, [](const InfluenceCoefficients& k) {
        return std::hypot(k.xz, k.yz) > negligible * std::max(std::abs(k.zz), std::abs(k.xx));
    });
}

std::string influence_text(const InfluenceTable& table) {
    std::string text = fmt::format("{}{}\n", title, version);
    text +=
        "# Line i j and nine K: displacement (substrate minus indenter) at the centre of the cell\n"
        "# i, j spacings away along x and y from a square cell under uniform traction 1 Pa. K_xz:\n"
        "# u_x by a pressure. Tractions act on the substrate, z points into it.\n";
    text += fmt::format("unit m/Pa\nspacing_m {}\npositions_x {}\npositions_y {}\ncomponents {}\n",
                        table.spacing, table.n_x, table.n_y, components);
    for (int j = 0; j < table.n_y; ++j)
        for (int i = 0; i < table.n_x; ++i)
            fmt::format_to(std::back_inserter(text), "{} {} {}\n", i, j,
                           fmt::join(nine(table.at(i, j)), " "));
    return text + "end\n";
}

InfluenceTable read_influence(const std::string& path) {
    Lines lines(path);
    check_title(lines);
    if (after("unit", lines) != " m/Pa")
        lines.refuse("the unit is not m/Pa", "convert the coefficients");
    InfluenceTable table;
    table.spacing = value_of<double>("spacing_m", lines);
    if (!contact::is_positive_and_finite(table.spacing))
        lines.refuse(fmt::format("a spacing of {} m is not positive and finite", table.spacing),
                     "correct it");
    table.n_x = positions_of("positions_x", lines);
    table.n_y = positions_of("positions_y", lines);
    if (after("components", lines) != fmt::format(" {}", components))
        lines.refuse("other components, or in another order",
                     fmt::format("give components {}", components));
    double own = 0;
    for (int j = 0; j < table.n_y; ++j)
        for (int i = 0; i < table.n_x; ++i) {
            const Nine k = values_at(i, j, lines);
            const auto [xx, xy, xz, yx, yy, yz, zx, zy, zz] = k;
            if (i == 0 && j == 0) {
                own = std::min({xx, yy, zz});
                if (!(own > 0))
                    lines.refuse("a cell must follow its own traction: K_xx, K_yy, K_zz > 0",
                                 "correct the signs");
            }
            check_symmetry(k, i, j, own, lines);
            table.cells.push_back({.xx = xx, .xy = xy, .yy = yy, .xz = xz, .yz = yz, .zz = zz});
        }
    if (lines.next() != "end")
        lines.refuse("more lines than positions", "give every position once, then \"end\"");
    return table;
}

void check_spacing(const InfluenceTable& table, const std::string& path, double spacing) {
    if (std::abs(table.spacing / spacing - 1) > same_spacing)
        throw contact::InputError(fmt::format(
            "{}: coefficients of cells of {:.10g} m, but those of the case have {:.10g} m; set "
            "bem.spacing to that of the file, or write the file again",
            path, table.spacing, spacing));
}

}  // namespace tricontact::bem
