#include "tests/random/drawn_bars.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/cells.h"
#include "fem/settings.h"
#include "io/case/case_input.h"
#include "io/case/case_reader.h"
#include "io/results/output.h"
#include "mdr/settings.h"
#include "tests/random/random_rig.h"

namespace tricontact::random_cases {

namespace {

using contact::Case;
using contact::NormalControl;
using contact::PrescribedPath;
using contact::TangentialControl;
using Row = PrescribedPath::Row;

class Drawing {
  public:
    explicit Drawing(std::uint64_t seed) : random_(seed) {}

    DrawnRun run() {
        constexpr std::array models{"mdr", "mdr", "bem", "bem", "bem", "bem-layer", "mdr-layer"};
        return run(models[whole(0, models.size() - 1)]);
    }

    DrawnRun run(const std::string& model) {
        model_ = model;
        const bool springs = model_.starts_with("mdr"),
                   layer = model_.ends_with("layer") || model_ == "fem";
        c_ = drawn_sphere_on_layer(random_, {.3, 1}, {.4, 3});
        if (!layer) c_.layer = {};
        c_.models = {model_};
        draw_body(springs, layer);
        if (!springs && chance(.4)) c_.substrate.poisson = between(random_, {.2, .49});
        c_.contact.coupling = !springs && chance(.7);
        c_.load.press_steps = whole(2, 6);
        c_.load.tangential_force = {};
        c_.of<mdr::Settings>().springs = 4 * whole(20, 100);
        c_.of<contact::Cells>().per_radius = between(random_, {3.5, 5.5});
        c_.of<io::Output>().vtk = io::Output::Vtk::none;
        if (model_ == "fem") mesh_coarsely();
        radius_ = contact::half_space_scales(c_).contact_radius;
        const double kind = between(random_, {0, 1});
        if (kind < .45)
            follow_path(springs);
        else
            load(kind);
        return {io::parse_case(io::write_case(c_), "case.toml"), body_, loading_, closed_form_,
                exact_shift_};
    }

  private:
    int whole(int low, int high) {  // both included
        return low + static_cast<int>(between(random_, {0, 1}) * (high - low + 1));
    }
    bool chance(double probability) { return between(random_, {0, 1}) < probability; }

    void draw_body(bool springs, bool layer) {
        const double radius = contact::half_space_scales(c_).contact_radius;
        const int shape = whole(0, springs ? 5 : 7);
        body_ = "paraboloid";
        if (shape == 2) {
            c_.indenter.shape = Case::Shape::sphere;
            body_ = "sphere";
        } else if (shape == 3) {
            c_.indenter.shape = Case::Shape::cone;
            c_.indenter.radius = 0;
            c_.indenter.angle = between(random_, {.05, .2});
            body_ = "cone";
        } else if (shape == 4) {
            c_.indenter.shape = Case::Shape::power_law;
            c_.indenter.exponent = between(random_, {1.7, 4});
            body_ = "power law";
        } else if (shape == 5) {
            c_.indenter.shape = Case::Shape::rounded_punch;
            c_.indenter.flat_radius = between(random_, {.2, .8}) * radius;
            body_ = "rounded punch";
        } else if (shape == 6) {
            c_.indenter.shape = Case::Shape::ellipsoid;
            c_.indenter.radius_y = c_.indenter.radius * between(random_, {.4, 2.5});
            body_ = "ellipsoid";
        } else if (shape == 7 && layer) {
            c_.indenter.shape = Case::Shape::cylinder;
            c_.indenter.length = 30 * radius;
            body_ = "cylinder";
        }
        closed_form_ = shape < 2;
    }

    /// Some on a frictionless base, some with elements of the model's own choice.
    void mesh_coarsely() {
        c_.of<fem::Settings>().cache = "none";
        if (chance(.3)) {
            c_.layer.base = Case::Base::frictionless;
            c_.of<fem::Settings>().sides = fem::Sides::fixed;
            body_ += " on a gliding layer";
        }
        if (chance(.1)) return;
        const auto half = contact::half_space_scales(c_).half_widths;
        c_.of<fem::Settings>().size = (c_.is_cylindrical() ? half[0] : std::min(half[0], half[1])) /
                                      between(random_, {3.5, 5.5});
    }

    void load(double kind) {
        c_.load.tangential_ratio = between(random_, {.1, .8});
        if (chance(.25)) {
            c_.load.indentation = contact::half_space_scales(c_).indentation;
            c_.load.normal_force.reset();
        }
        loading_ = "at rest";
        if (kind < .55) return;
        auto& rolling = c_.rolling.emplace();
        rolling.amplitude = between(random_, {.05, .4}) * radius_;
        rolling.periods = 3;
        rolling.run_all = true;
        if (kind < .65) {
            rolling.steps = Case::Steps::turning_points;
            loading_ = "turning points";
            return;
        }
        if (chance(.12)) relax(*rolling.amplitude);
        rolling.steps_per_quarter = whole(1, 5);
        loading_ = fmt::format("{} steps per quarter", rolling.steps_per_quarter);
    }

    /// A standard solid, rolled over at a speed that it feels.
    void relax(double amplitude) {
        const double time = between(random_, {.1, 1});
        c_.of<io::RelaxationInput>().moduli = {c_.substrate.shear_modulus() *
                                               between(random_, {.2, 2})};
        c_.of<io::RelaxationInput>().times = {time};
        c_.rolling->speed = amplitude / time * between(random_, {.1, 10});
        body_ += " on rubber";
        closed_form_ = false;
    }

    /// Forces in turn, or motions; oblique loading without slip on the half-space is known exactly.
    void follow_path(bool springs) {
        const double force = *c_.load.normal_force, limit = c_.friction_coefficient() * force;
        PrescribedPath path;
        const bool oblique = chance(.3), moves = !oblique && chance(.3);
        const int n_rows = oblique ? 2 : whole(2, 4);
        const bool cylinder = c_.is_cylindrical();
        const double depth = contact::half_space_scales(c_).indentation;
        for (int r = 0; r < n_rows; ++r) {
            Row row;
            const double share = r == 0 ? 0 : between(random_, {.5, 1});
            row.normal = {NormalControl::Kind::force, share * force};
            row.tangential[0].value = r == 0 ? 0 : between(random_, {-.7, .7}) * share * limit;
            row.steps = whole(1, 8);
            if (moves)
                row.tangential[0] = {TangentialControl::Kind::shift,
                                     r == 0 ? 0 : between(random_, {-.4, .4}) * depth};
            if (r > 0 && !oblique && chance(.4))
                row.offset[0] = between(random_, {-.3, .3}) * radius_;
            if (r > 0 && !springs && !cylinder && !oblique && chance(.3))
                row.rotation = between(random_, {-.02, .02});
            path.rows.push_back(row);
        }
        loading_ = oblique ? "oblique path" : moves ? "path of shifts" : "path of forces";
        c_.load.normal_force = path.hardest_normal().value;
        if (oblique && closed_form_ && !model_.ends_with("layer") && !c_.contact.coupling) {
            const auto pair = c_.materials();
            exact_shift_ = path.rows[1].tangential[0].value / path.rows[1].normal.value *
                           pair.effective_modulus() / pair.effective_shear_modulus() *
                           contact::half_space_scales(c_).indentation;
        }
        c_.prescribed_path = path;
        c_.of<io::PathInput>() = {.table = table_of(path)};
        c_.load.normal_force.reset();
    }

    static std::string table_of(const PrescribedPath& path) {
        const bool shifts = path.rows.back().tangential[0].kind == TangentialControl::Kind::shift;
        std::string text =
            fmt::format("normal_force [N], {}, offset_x [m], rotation [rad], steps\n",
                        shifts ? "shift_x [m]" : "tangential_force_x [N]");
        for (const Row& row : path.rows)
            text += fmt::format("{}, {}, {}, {}, {}\n", row.normal.value, row.tangential[0].value,
                                row.offset[0], row.rotation, row.steps);
        return text;
    }

    Random random_;
    Case c_;
    std::string model_, body_, loading_;
    bool closed_form_ = false;
    std::optional<double> exact_shift_;
    double radius_ = 0;  // of the contact on the half-space [m]
};

}  // namespace

DrawnRun drawn_run(std::uint64_t seed) {
    return Drawing(seed).run();
}

DrawnRun drawn_fem_run(std::uint64_t seed) {
    return Drawing(seed).run("fem");
}

void quarter_steps(Case& f) {
    if (f.rolling) {
        if (f.rolling->steps == Case::Steps::turning_points) {
            f.rolling->steps = Case::Steps::per_quarter;
            f.rolling->steps_per_quarter = 4;
        }
        f.rolling->steps_per_quarter *= 4;
    }
    if (f.prescribed_path)
        for (auto& row : f.prescribed_path->rows) row.steps *= 4;
    f.load.press_steps *= 4;
}

}  // namespace tricontact::random_cases
