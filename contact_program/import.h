#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "contact/case.h"

namespace tricontact::contact_program {

/// Whether the model couples normal and tangential contact of these bodies.
using CouplesBodies = std::function<bool(const contact::MaterialPair&)>;

/// d [m] of a case under its normal force.
using PressedDepth = std::function<double(const contact::Case&)>;
double hertzian_depth(const contact::Case& c);

inline constexpr const char* heights_ending = "_heights.csv";
inline constexpr const char* influence_ending = "_influence.txt";

/// A case file (TOML) of cases of CONTACT that belong together.
struct ImportedCase {
    std::size_t first = 0, last = 0;   ///< of them, counted from 1
    bool rolls_on = false;             ///< the case has [tractive_rolling]
    std::string text;                  ///< see text_beside
    std::string influence_file;        ///< that it names for its coefficients (C = 9), or empty
    double shear_modulus = 0;          ///< the combined G by which these are multiplied [Pa]
    std::string heights;               ///< table of a height map in mm, or empty
    std::vector<std::string> remarks;  ///< what the case has otherwise than the file

    std::size_t n_steps() const { return last - first + 1; }
    /// The text of the case file that names the files of heights and coefficients beside it, `stem`
    /// followed by heights_ending and influence_ending.
    std::string text_beside(const std::string& stem) const;
};

/// Cases of the file that no case here says, and why.
struct LeftOutCases {
    std::size_t first = 0, last = 0;
    std::string reason;  ///< with file and line
};

struct Import {
    std::vector<ImportedCase> cases;
    std::vector<LeftOutCases> left_out;
};

/// What an input file of CONTACT's module 3 becomes (docs/reference/contact-program.md): a case for
/// each sequence that begins anew, P = 2, and each steady state. `name` stands for the file in
/// messages. `pressed_depth` tells a depth PEN from that of a force on the case's own cells. Throws
/// contact::InputError with line and column for what is no such file, and with the first reason
/// where nothing of it is a case.
Import import_cases(std::string text, const std::string& name, const CouplesBodies& is_coupled,
                    const PressedDepth& pressed_depth = hertzian_depth);

}  // namespace tricontact::contact_program
