#include "contact_program/import.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "contact/base/error.h"
#include "contact/half_space_scales.h"
#include "contact_program/case_parts.h"
#include "contact_program/sequence.h"
#include "contact_program/sequence_case.h"
#include "io/case/case_reader.h"
#include "io/keys/messages.h"

namespace tricontact::contact_program {

namespace {

/// The next cases that go on from each other: until one begins anew, or is steady.
ProgramSequence next_sequence(ProgramSequence cases) {
    std::size_t n = 1;
    if (!cases.front().step.is_steady())
        while (n < cases.size() && cases[n].digits.previous == 0 && !cases[n].step.is_steady()) ++n;
    return cases.first(n);
}

/// Imports one sequence.
class SequenceImport {
  public:
    SequenceImport(ProgramSequence steps, const std::string& name, const CouplesBodies& is_coupled,
                   const PressedDepth& pressed_depth)
        : steps_(steps),
          name_(name),
          coupled_(couples(is_coupled)),
          pressed_depth_(pressed_depth) {}

    void write(ImportedCase& out) const {
        for (const ProgramCase& one : steps_) check_known(one, name_);
        check_beginning();
        check_alike(steps_, name_);
        const std::string cases = out.n_steps() == 1
                                      ? fmt::format("case {}", out.first)
                                      : fmt::format("cases {} to {}", out.first, out.last);
        const std::string heading = fmt::format(
            "title = {}\nmodels = [\"bem\"]\n",
            io::toml_string(fmt::format("Sequence of CONTACT, {}, {}",
                                        std::filesystem::path(name_).filename().string(), cases)));
        out.rolls_on = steps_.back().step.is_rolling();
        out.text = text(heading);
        if (!out.rolls_on) out.text += inside_text();
        if (head().distance.heights) out.heights = heights_table();
        out.influence_file = head().influence_file;
        out.shear_modulus =
            ShearModuli{head().shear_modulus[0], head().shear_modulus[1]}.combined();
        out.remarks = remarks(out.text);
    }

  private:
    const ProgramCase& head() const { return steps_.front(); }

    bool couples(const CouplesBodies& is_coupled) const {
        // Numerical coefficients may couple any bodies: how they are pressed matters.
        return head().influence == 9 || is_coupled(materials_of(head()));
    }

    void check_beginning() const {
        if (head().digits.previous == 2 || head().step.is_steady()) return;
        refuse_at(name_, head().digits.line, fmt::format("P = {}", head().digits.previous),
                  "goes on from steady rolling, from which no case here begins",
                  "begin from rest, T = 1 with P = 2");
    }

    std::string text(const std::string& heading) const {
        if (steps_.back().step.is_rolling()) return rolling_case(steps_, name_, heading);
        if (std::ranges::any_of(steps_, &SequenceStep::is_rolling, &ProgramCase::step))
            refuse_at(name_, steps_.back().digits.line, "T = 1", "goes on from rolling",
                      "begin again by P = 2");
        const auto path = [&] { return path_case(steps_, name_, heading, pressed_depth_); };
        if (is_beside_origin(head())) return path();
        if (steps_.size() == 1 && !head().step.tangential)
            return pressing_case(steps_, name_, coupled_, heading);
        try {
            if (auto found = sequence_case(steps_, name_, coupled_, heading)) return *found;
        } catch (const contact::InputError&) {  // [path] takes what [load] and [rolling] do not
        }
        return path();
    }

    /// Stresses inside, as far down as the deepest point of the last case, in front of [bem].
    std::string inside_text() const {
        const double depth = steps_.back().deepest;
        if (depth < steps_.back().spacing[0] || head().influence == 9) return {};
        return fmt::format("[output]\nvolume = \"last\"\nvolume_depth = \"{} mm\"\n", 1e3 * depth);
    }

    /// Matrix of the heights in mm, a row of cells along x per line. Around a single cell there
    /// are some that touch nothing.
    std::string heights_table() const {
        if (head().n_x == 1 && head().n_y == 1)
            return "1000, 1000, 1000\n1000, 0, 1000\n1000, 1000, 1000\n";
        const auto& heights = *head().distance.heights;
        std::string table;
        for (std::size_t k = 0; k < heights.size(); ++k)
            table += fmt::format("{}{}", 1e3 * heights[k], (k + 1) % head().n_x == 0 ? "\n" : ", ");
        return table;
    }

    /// What is otherwise in the case of this text.
    std::vector<std::string> remarks(const std::string& text) const {
        const ProgramCase& last = steps_.back();
        std::vector<std::string> found;
        constexpr double same_step = 1e-3;  // of DX
        if (last.step.is_steady() && std::abs(last.step_length / last.spacing[0] - 1) > same_step)
            found.push_back(fmt::format("the step DQ = {:.6g} mm became one cell, DX = {:.6g} mm",
                                        1e3 * last.step_length, 1e3 * last.spacing[0]));
        if (last.step.is_rolling() && last.step.rotation != 0 && creepage_moves(last))
            found.emplace_back(
                "creepages are those at the body's lowest point, about which it "
                "spins here (SPINXO, SPINYO, FACPHI)");
        if (!last.distance.heights && is_cut_off(text))
            found.emplace_back(
                "the contact does not fit into the potential contact, whose edge "
                "cuts it off in CONTACT and not here");
        if (last.friction_coefficient == 0)
            found.emplace_back(
                "FSTAT = 0 became another coefficient of friction, which has no "
                "effect without a tangential problem (T = 0)");
        if (last.digits.heat != 0 && !has_heat(last))
            found.emplace_back("temperatures are not computed (H)");
        if (last.deepest > 0 && last.step.is_rolling())
            found.emplace_back("stresses inside are not computed while the contact rolls on (S)");
        const bool mixed = std::ranges::any_of(steps_, [&](const ProgramCase& one) {
            return one.step.by_force() != head().step.by_force();
        });
        if (mixed)
            found.emplace_back("the depths PEN were taken for the force FN of the first case");
        return found;
    }

    static bool creepage_moves(const ProgramCase& one) {
        return one.distance.offset != one.step.centre || one.spin_ahead != usual_spin_ahead;
    }

    /// Hertz' contact of some case reaches beyond the cells.
    bool is_cut_off(const std::string& text) const {
        const auto half =
            half_space_scales(io::parse_case(text, name_ + ", as a case")).half_widths;
        return std::ranges::any_of(steps_, [&](const ProgramCase& one) {
            const std::array<int, 2> n{one.n_x, one.n_y};
            for (std::size_t axis = 0; axis < (is_line_contact(one) ? 1 : 2); ++axis) {
                const double first = one.first[axis] - one.spacing[axis] / 2,
                             last = first + n[axis] * one.spacing[axis],
                             at = one.distance.offset[axis];
                if (at - half[axis] < first || at + half[axis] > last) return true;
            }
            return false;
        });
    }

    ProgramSequence steps_;
    const std::string& name_;
    bool coupled_;
    const PressedDepth& pressed_depth_;
};

}  // namespace

std::string ImportedCase::text_beside(const std::string& stem) const {
    std::string out = text;
    const auto add = [&](std::string_view section, const std::string& line) {
        out.insert(out.find(section) + section.size(), line);
    };
    if (!heights.empty())
        add("[indenter]\n", fmt::format("file = {}\n", io::toml_string(stem + heights_ending)));
    if (!influence_file.empty())
        add("[bem]\n", fmt::format("influence = {}\n", io::toml_string(stem + influence_ending)));
    return out;
}

Import import_cases(std::string text, const std::string& name, const CouplesBodies& is_coupled,
                    const PressedDepth& pressed_depth) {
    const std::vector<ProgramCase> cases = read_program_cases(std::move(text), name);
    Import found;
    for (std::size_t begin = 0; begin < cases.size();) {
        const auto steps = next_sequence(ProgramSequence(cases).subspan(begin));
        ImportedCase one{.first = begin + 1, .last = begin + steps.size()};
        begin += steps.size();
        try {
            SequenceImport(steps, name, is_coupled, pressed_depth).write(one);
            found.cases.push_back(std::move(one));
        } catch (const contact::InputError& why) {
            found.left_out.push_back({one.first, one.last, why.what()});
        }
    }
    if (found.cases.empty()) throw contact::InputError(found.left_out.front().reason);
    return found;
}

}  // namespace tricontact::contact_program
