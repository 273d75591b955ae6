#include "io/contact_program/case_digits.h"

#include <fmt/format.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace tricontact::io {

namespace {

/// A digit, what it may be, and why not something else.
struct Digit {
    char letter;
    std::string_view allowed;
    std::string_view rule;
    std::string_view remedy;
};

constexpr std::string_view any = "0123456789";

constexpr std::array<Digit, 6> first_word = {{
    {'P', "02", "a case goes on from the one before or begins anew", "give 0 or 2"},
    {'B', "0", "only the full normal problem is solved", "give 0"},
    {'T', "01", "only shifts in world-fixed coordinates are cases here",
     "give 0 or 1; what rolls on is computed by tricontact roll"},
    {'N', "01", "depth or normal force is prescribed", "give 0 or 1"},
    {'F', "012", "shifts or forces are prescribed", "give 0, 1 or 2"},
    {'S', "0", "stresses inside are asked for by output.volume of the case", "give 0"},
}};
constexpr std::array<Digit, 7> second_word = {{
    {'V', "0", "friction is the same everywhere", "give 0"},
    {'L', "01", "only Coulomb friction is a case here", "give 0, or 1 to keep it"},
    {'D', "02", "cells are new or kept", "give 0 or 2"},
    {'C', "02",
     "only half-spaces with constant tractions per cell are read; coefficients of a "
     "file do not tell the layer",
     "give 0 or 2"},
    {'M', "0", "only elastic bodies are cases here", "give 0"},
    {'Z', "02", "undeformed distances are new or kept", "give 0 or 2"},
    {'E', "0", "no further term of slip is a case here", "give 0"},
}};
constexpr std::array<Digit, 8> third_word = {{
    {'X', "0", "debug output has lines of its own", "give 0"},
    {'H', "0", "no temperatures are computed", "give 0"},
    {'G', "01", "settings of other solvers have no counterpart", "give 0 or 1"},
    {'I', any, "", ""},
    {'A', any, "", ""},
    {'O', any, "", ""},
    {'W', any, "", ""},
    {'R', "01", "every case is computed", "give 0 or 1"},
}};

template <std::size_t n>
std::vector<int> read_word(InputLines& lines, const std::array<Digit, n>& declared) {
    std::string letters;
    for (const Digit& digit : declared) letters += digit.letter;
    const std::vector<int> values = lines.digits(n, letters);
    for (std::size_t k = 0; k < n; ++k)
        if (declared[k].allowed.find(static_cast<char>('0' + values[k])) == std::string_view::npos)
            lines.refuse(fmt::format("{} = {}", declared[k].letter, values[k]), declared[k].rule,
                         declared[k].remedy);
    return values;
}

}  // namespace

CaseDigits read_digits(InputLines& lines) {
    CaseDigits digits;
    const auto first = read_word(lines, first_word);
    digits.line = lines.line();
    const auto second = read_word(lines, second_word);
    const auto third = read_word(lines, third_word);
    digits.previous = first[0];
    digits.tangential = first[2];
    digits.normal = first[3];
    digits.force = first[4];
    digits.friction = second[1];
    digits.cells = second[2];
    digits.influence = second[3];
    digits.distance = second[5];
    digits.solver = third[2];
    digits.after = third[7];
    return digits;
}

}  // namespace tricontact::io
