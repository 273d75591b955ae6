#include "io/contact_program/sequence.h"

#include <fmt/format.h>

#include <cmath>

#include "contact/solvers/contact_region.h"
#include "io/keys/messages.h"

namespace tricontact::io {

namespace {

using contact::Case;
using contact::LoadStep;
using contact::NormalControl;
using contact::Vector2;

/// What the half-space and layer of CONTACT do not do.
void check_bodies(const Case& c, bool is_coupled) {
    if (c.relaxation)
        fail("substrate.relaxation", "", "CONTACT takes relaxing bodies in steady rolling alone",
             "such a case cannot be written for it");
    if (c.bem.period) fail("bem.period", "", "CONTACT has no periodic contacts", "omit it");
    if (is_coupled && !c.contact.coupling)
        fail("contact.coupling", "", "CONTACT always couples such bodies", "omit it");
    const auto out_of_range = [](const contact::Material& m) { return m.poisson < 0; };
    if (out_of_range(c.substrate) || (c.indenter.material && out_of_range(*c.indenter.material)))
        fail("poisson", "", "CONTACT takes Poisson's ratios from 0 to 1/2",
             "such a material cannot be written for it");
}

/// F_T is over mu F_N there; what F_N will be under a prescribed depth only a run knows.
void check_loads(const Case& c) {
    if (c.tractive_rolling)
        fail("tractive_rolling", "", "rolling on is not written as shifts in fixed coordinates",
             "give [rolling], or none");
    if (c.rolling && c.rolling->amplitude_reference == Case::AmplitudeReference::model)
        fail("rolling.amplitude_reference", "", "the model's radius is known by a run alone",
             "take \"hertz\", or give rolling.amplitude");
    if (c.load.is_by_limit())
        fail(c.load.limit_key(), "", "the model's limit is known by a run alone",
             "give load.tangential_ratio");
    if (!c.load.indentation) return;
    if (c.rolling)
        fail("load.indentation", "", "CONTACT takes F_T over the F_N of each step",
             "give load.normal_force where the indenter rolls");
    if (c.load.tangential_force)
        fail("load.tangential_force", "", "CONTACT takes F_T over F_N, which d does not give",
             "give load.tangential_ratio");
}

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
        const auto steps = sequence_of(case_, is_coupled_);
        text_ = fmt::format(
            "% {}\n% Body 1 is the indenter, body 2 the substrate; mm, N, N/mm^2. {} cases.\n",
            one_line(case_.title), steps.size());
        for (std::size_t k = 0; k < steps.size(); ++k)
            append(k + 1, steps[k], k == 0 ? nullptr : &steps[k - 1]);
        return text_ + "\n 0 MODULE\n";
    }

    void append(std::size_t number, const SequenceStep& step, const SequenceStep* before) {
        const bool moved = !before || step.offset != before->offset;
        text_ += fmt::format("\n% {}\n 3 MODULE\n", number);
        append_digits(step, before == nullptr, moved);
        if (!before)
            text_ += fmt::format(" {} {} {}   MAXGS, MAXIN, MAXNR, MAXOUT, EPS\n", inner_iterations,
                                 is_coupled_ ? turns_if_coupled : 1, case_.bem.tolerance);
        append_loads(step);
        if (!before) {
            text_ += fmt::format(" {0} {0}   FSTAT, FKIN\n", case_.friction_coefficient);
            append_materials();
            text_ +=
                fmt::format(" 3   IPOTCN\n {} {} {} {} {} {}   MX, MY, XC1, YC1, DX, DY\n",
                            grid_.n_x, grid_.n_y, in_mm * grid_.first[0], in_mm * grid_.first[1],
                            in_mm * grid_.spacing[0], in_mm * grid_.spacing[1]);
        }
        if (moved)
            text_ += curvature_ ? quadratic_distance(*curvature_, step.offset)
                                : distance_per_cell(grid_, *body_, step.offset);
    }

    void append_digits(const SequenceStep& step, bool first, bool moved) {
        const bool force = step.normal.kind == NormalControl::Kind::force;
        text_ += fmt::format(" {}0{:d}{:d}{}0   P-B-T-N-F-S\n", first ? 2 : 0, step.tangential,
                             force, step.tangential ? 2 : 0);
        const int influence = influence_ ? 9 : 2;
        text_ += first ? fmt::format(" 002{}020   V-L-D-C-M-Z-E\n", influence)
                       : fmt::format(" 01000{}0   V-L-D-C-M-Z-E\n", moved ? 2 : 0);
        text_ += fmt::format(" 0{0:d}{0:d}0211   H-G-I-A-O-W-R\n", !first);
    }

    /// FX is on the indenter, against F_T on the substrate.
    void append_loads(const SequenceStep& step) {
        const bool force = step.normal.kind == NormalControl::Kind::force;
        text_ += fmt::format(" {} {} 0 0   {}, {}, CPHI\n", step.normal.value * (force ? 1 : in_mm),
                             step.force_ratio == 0 ? 0 : -step.force_ratio, force ? "FN" : "PEN",
                             step.tangential ? "FX, FY" : "CKSI, CETA");
    }

    void append_materials() {
        if (influence_) text_ += fmt::format(" '{}'   CFNAME\n", *influence_);
        const auto [indenter, substrate] = shear_moduli(case_);
        const auto& material = case_.indenter.material;
        text_ += fmt::format(" {} {} {} {}   POISS 1,2, GG 1,2\n",
                             material ? material->poisson : case_.substrate.poisson,
                             case_.substrate.poisson, per_square_mm * indenter,
                             per_square_mm * substrate);
    }
};

}  // namespace

std::vector<SequenceStep> sequence_of(const Case& c, bool is_coupled) {
    check_bodies(c, is_coupled);
    check_loads(c);
    const double radius = c.rolling ? half_space_scales(c).contact_radius : 0;
    const auto path = make_load_path(c, c.load.normal_force.value_or(1), radius);

    std::vector<SequenceStep> steps;
    const auto append = [&](const std::vector<LoadStep>& part) {
        for (const LoadStep& step : part) {
            // Under a prescribed depth the path was made for F_N = 1 N.
            const bool force = step.normal.kind == NormalControl::Kind::force;
            const double limit = c.friction_coefficient * (force ? step.normal.value : 1);
            steps.push_back(
                {step.friction, step.normal, step.tangential[0].value / limit, step.offset});
        }
    };
    if (is_coupled)
        append(path.pressing);
    else
        steps.push_back({.tangential = false, .normal = press_step(c).normal});
    append(path.loading);
    for (int n = 0; n < path.max_periods; ++n) append(path.period);
    return steps;
}

ShearModuli shear_moduli(const Case& c) {
    const double substrate = c.substrate.shear_modulus();
    return {
        c.indenter.material ? c.indenter.material->shear_modulus() : rigid_shear_ratio * substrate,
        substrate};
}

std::string sequence_text(const Case& c, const contact::ContactPoints& grid, bool is_coupled,
                          const std::optional<std::string>& influence) {
    if (grid.size() > most_program_cells)
        fail("bem.spacing", "",
             fmt::format("{} x {} cells are more than the {} that CONTACT takes", grid.n_x,
                         grid.n_y, most_program_cells),
             "enlarge it");
    return SequenceWriter{c, grid, is_coupled, influence}.write();
}

}  // namespace tricontact::io
