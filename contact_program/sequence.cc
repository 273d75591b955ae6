#include "contact_program/sequence.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "bem/settings.h"
#include "contact/heat.h"
#include "contact/solvers/contact_region.h"
#include "io/keys/messages.h"

namespace tricontact::contact_program {

namespace {

using contact::Case;
using contact::NormalControl;
using contact::Vector2;

constexpr double in_mm = 1e3;           // in 1 m
constexpr double per_square_mm = 1e-6;  // 1 Pa in N/mm^2
// What a body is high where it ends [mm]: farther than anything is pressed.
constexpr double out_of_reach = 1e6;

// Most iterations of CONTACT's loops: Gauss-Seidel, within NORM and TANG, Newton-Raphson for F_T.
constexpr const char* inner_iterations = "999 999 50";
constexpr int turns_if_coupled = 50;

constexpr std::size_t most_program_cells = 2'000'000;  // that CONTACT takes

/// Curvatures A, B [1/m] of a body h = A x^2 + B y^2; empty: another one.
std::optional<Vector2> quadratic_body(const Case& c) {
    const auto& body = c.indenter;
    if (body.roughness) return {};
    switch (body.shape) {
        case Case::Shape::paraboloid:
            return Vector2{1 / (2 * body.radius), 1 / (2 * body.radius)};
        case Case::Shape::ellipsoid:
            return Vector2{1 / (2 * body.radius), 1 / (2 * body.radius_y)};
        case Case::Shape::cylinder:
            return Vector2{1 / (2 * body.radius), 0};
        default:
            return {};
    }
}

std::string quadratic_distance(const Vector2& curvature, const Vector2& offset) {
    const auto [a, b] = curvature;
    const auto [x, y] = offset;
    const auto linear = [](double value) { return value == 0 ? 0 : -2 * value; };  // not -0
    return fmt::format(" 1 1   IBASE, IPLAN\n {} 0 {} {} {} {}   B(I), I = 1, 6\n", a / in_mm,
                       b / in_mm, linear(a * x), linear(b * y), in_mm * (a * x * x + b * y * y));
}

std::string distance_per_cell(const contact::ContactPoints& grid, const contact::Indenter& body,
                              const Vector2& offset) {
    std::string text = " 9 1   IBASE, IPLAN\n% row by row\n";
    const auto heights = heights_over(grid, body, offset);
    constexpr int per_line = 5;
    for (int row = 0; row < grid.n_y; ++row)
        for (int i = 0; i < grid.n_x; ++i) {
            const double h = heights[static_cast<std::size_t>(row) * grid.n_x + i];
            const bool last = i + 1 == grid.n_x || i % per_line == per_line - 1;
            text +=
                fmt::format(" {}{}", std::isfinite(h) ? in_mm * h : out_of_reach, last ? "\n" : "");
        }
    return text;
}

/// Writes the steps of one case.
struct SequenceWriter {
    const Case& case_;
    const contact::ContactPoints& grid_;
    bool is_coupled_;
    std::optional<std::string> influence_;
    std::optional<Vector2> curvature_ = quadratic_body(case_);
    std::unique_ptr<contact::Indenter> body_ = case_.make_indenter();
    std::string text_ = {};

    std::string write() {
        if (case_.interface.normal_stiffness)
            io::fail("interface.normal_stiffness", "",
                     "CONTACT's layer between the bodies is sheared alone", "leave it out");
        const auto steps = sequence_of(case_, is_coupled_);
        text_ = fmt::format(
            "% {}\n% Body 1 is the indenter, body 2 the substrate; mm, N, N/mm^2. {} cases.\n",
            io::one_line(case_.title), steps.size());
        for (std::size_t k = 0; k < steps.size(); ++k)
            append(k + 1, steps[k], k == 0 ? nullptr : &steps[k - 1]);
        return text_ + "\n 0 MODULE\n";
    }

    void append(std::size_t number, const SequenceStep& step, const SequenceStep* before) {
        const bool moved = !before || step.offset != before->offset;
        const bool starts_rolling = before && step.is_rolling() && !before->is_rolling();
        text_ += fmt::format("\n% {}\n 3 MODULE\n", number);
        append_digits(step, before == nullptr, moved, starts_rolling);
        if (!before)
            text_ += fmt::format(" {} {} {}   MAXGS, MAXIN, MAXNR, MAXOUT, EPS\n", inner_iterations,
                                 is_coupled_ ? turns_if_coupled : 1,
                                 case_.of<bem::Settings>().tolerance);
        append_loads(step);
        if (!before) {
            append_friction();
            append_materials(step);
            if (has_heat(step)) append_heat();
            text_ +=
                fmt::format(" 3   IPOTCN\n {} {} {} {} {} {}   MX, MY, XC1, YC1, DX, DY\n",
                            grid_.n_x, grid_.n_y, in_mm * grid_.first[0], in_mm * grid_.first[1],
                            in_mm * grid_.spacing[0], in_mm * grid_.spacing[1]);
        }
        if (starts_rolling) append_materials(step);
        if (before && has_heat(step)) append_heat();
        if (moved)
            text_ += curvature_ ? quadratic_distance(*curvature_, step.offset)
                                : distance_per_cell(grid_, *body_, step.offset);
    }

    void append_digits(const SequenceStep& step, bool first, bool moved, bool starts_rolling) {
        const bool force = step.normal.kind == NormalControl::Kind::force;
        text_ += fmt::format(" {}0{:d}{:d}{}0   P-B-T-N-F-S\n",
                             first || step.motion == SequenceStep::Motion::steady ? 2 : 0,
                             step.tangential ? static_cast<int>(step.motion) : 0, force,
                             step.tangential ? step.n_forced() : 0);
        const int influence = influence_ ? 9 : 2;
        const int layer = case_.interface.tangential_stiffness ? 4 : 0;  // M
        text_ +=
            first ? fmt::format(" 0{}2{}{}20   V-L-D-C-M-Z-E\n", friction_law(), influence, layer)
                  : fmt::format(" 010{}{}{}0   V-L-D-C-M-Z-E\n", starts_rolling ? influence : 0,
                                layer, moved ? 2 : 0);
        text_ +=
            fmt::format(" {1}{0:d}{0:d}0211   H-G-I-A-O-W-R\n", !first, has_heat(step) ? 3 : 0);
    }

    /// L.
    int friction_law() const {
        using Law = contact::FrictionRate::Law;
        if (case_.friction.temperature) return 6;
        if (!case_.friction.rate) return 0;
        const Law law = case_.friction.rate->law;
        return law == Law::linear ? 2 : law == Law::rational ? 3 : 4;
    }

    void append_friction() {
        const double mu = case_.friction_coefficient();
        if (const auto& law = case_.friction.temperature) {
            text_ +=
                fmt::format(" {} {} {} {}   FREF, TREF, DFHEAT, DTHEAT\n 0 0   MEMDST, MEM_S0\n",
                            mu, law->from, law->change, law->to - law->from);
            return;
        }
        if (!case_.friction.rate) {
            text_ += fmt::format(" {0} {0}   FSTAT, FKIN\n", mu);
            return;
        }
        const contact::FrictionRate& rate = *case_.friction.rate;
        text_ += fmt::format(" {}", rate.least(mu));
        for (const std::size_t k : {0, 1})
            text_ += k < rate.drops.size()
                         ? fmt::format(" {} {}", rate.drops[k], in_mm * rate.speeds[k])
                         : " 0 1";
        text_ += fmt::format("   FKIN, F1, SABSH1, F2, SABSH2\n {} {}   MEMDST, MEM_S0\n",
                             in_mm * rate.memory_length, in_mm * rate.memory_speed);
    }

    /// Temperatures are those of the steady state.
    bool has_heat(const SequenceStep& step) const {
        return step.is_steady() && case_.kept.find<contact::ContactHeat>();
    }

    void append_heat() {
        constexpr double per_mm = 1e-3, per_cubic_mm = 1e-9;  // 1/m, 1/m^3
        const auto& heat = case_.of<contact::ContactHeat>();
        for (const auto& body : {heat.indenter, heat.substrate})
            text_ += fmt::format(" {} {} {} {}   BKTEMP, HEATCP, LAMBDA, DENS\n", body.temperature,
                                 body.specific_heat, per_mm * body.conductivity,
                                 per_cubic_mm * body.density);
    }

    /// Forces FX, FY are on the indenter, against those on the substrate; shifts are the indenter's
    /// at SPINXO, SPINYO.
    void append_loads(const SequenceStep& step) {
        const bool force = step.normal.kind == NormalControl::Kind::force;
        const bool turns = step.tangential && step.rotation != 0;
        std::string values = fmt::format("{}", step.normal.value * (force ? 1 : in_mm));
        std::string names = force ? "FN" : "PEN";
        for (const int axis : {0, 1}) {
            const bool forced = step.tangential && step.is_forced(axis);
            const double value = step.tangential ? step.along[axis].value : 0;
            const double unit = forced ? -1 : step.is_rolling() ? 1 : in_mm;
            values += fmt::format(" {}", value == 0 ? 0 : value * unit);
            names += forced ? (axis == 0 ? ", FX" : ", FY") : (axis == 0 ? ", CKSI" : ", CETA");
        }
        values += fmt::format(" {}", turns ? step.rotation / (step.is_rolling() ? in_mm : 1) : 0);
        names += ", CPHI";
        if (turns && step.centre != Vector2{}) {
            values += fmt::format(" {} {}", in_mm * step.centre[0], in_mm * step.centre[1]);
            names += ", SPINXO, SPINYO";
        }
        text_ += fmt::format(" {}   {}\n", values, names);
    }

    void append_materials(const SequenceStep& step) {
        constexpr double speed_without_effect = 1000;  // [mm/s]: nothing relaxes
        if (step.is_rolling())
            text_ += fmt::format(" 0 {} {}   CHI, DQ, VELOC\n", in_mm * grid_.spacing[0],
                                 case_.tractive_rolling->speed > 0
                                     ? in_mm * case_.tractive_rolling->speed
                                     : speed_without_effect);
        if (influence_) text_ += fmt::format(" '{}'   CFNAME\n", *influence_);
        const auto [indenter, substrate] = shear_moduli(case_);
        const auto& material = case_.indenter.material;
        text_ += fmt::format(" {} {} {} {}   POISS 1,2, GG 1,2\n",
                             material ? material->poisson : case_.substrate.poisson,
                             case_.substrate.poisson, per_square_mm * indenter,
                             per_square_mm * substrate);
        constexpr double per_cubic_mm = 1e-9;  // 1 Pa/m in N/mm^3
        if (const auto& stiffness = case_.interface.tangential_stiffness)
            text_ +=
                fmt::format(" {} 1 0 0   GG3, LAYTHK, TAU_C0, K_TAU\n", per_cubic_mm * *stiffness);
    }
};

}  // namespace

ShearModuli shear_moduli(const Case& c) {
    const double substrate = c.substrate.shear_modulus();
    return {
        c.indenter.material ? c.indenter.material->shear_modulus() : rigid_shear_ratio * substrate,
        substrate};
}

std::string sequence_text(const Case& c, const contact::ContactPoints& grid, bool is_coupled,
                          const std::optional<std::string>& influence) {
    if (grid.size() > most_program_cells)
        io::fail("bem.spacing", "",
                 fmt::format("{} x {} cells are more than the {} that CONTACT takes", grid.n_x,
                             grid.n_y, most_program_cells),
                 "enlarge it");
    return SequenceWriter{c, grid, is_coupled, influence}.write();
}

}  // namespace tricontact::contact_program
