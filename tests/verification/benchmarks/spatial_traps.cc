// Conventions of codes in three dimensions: the reference's own fields of a pressed and sheared
// layer, written as others write them. Only the conventions are tried: the fields are right.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "contact/base/error.h"
#include "tests/unit/benchmarks/foreign.h"

namespace tricontact::benchmarks {
namespace spatial_traps {

const Reference& sheared() {
    static const Reference one =
        foreign::reference_of("layer_shifted.toml", {"bem.cells_per_radius=20"});
    return one;
}

/// Cells of the side `h` [m] over x, and over y from `low` [m] on.
MeshField written(double h, double low) {
    MeshField f;
    f.file = "cells";
    f.columns = {{"x", Meaning::x, "mm", {}},
                 {"y", Meaning::y, "mm", {}},
                 {"p", Meaning::pressure, "MPa", {}},
                 {"tx", Meaning::traction_x, "MPa", {}},
                 {"ty", Meaning::traction_y, "MPa", {}}};
    const double reach = 1.3 * sheared().contact_radius;
    for (double y = low + h / 2; y < reach; y += h)
        for (double x = -reach + h / 2; x < reach; x += h) {
            const SurfaceValues v = sheared().fields->at(x, y);
            const double values[] = {x, y, v.pressure, v.traction_x, v.traction_y};
            for (std::size_t k = 0; k < f.columns.size(); ++k)
                f.columns[k].values.push_back(values[k]);
        }
    const auto force = [](const char* key) {
        return Total{sheared().find(key)->value, "N", "cells"};
    };
    f.totals["normal_force"] = force("normal_force");
    f.totals["tangential_force"] = force("tangential_force");
    f.totals["size"] = {h, "m", "cells"};
    return f;
}

Submission three(double low = -1.3 * 4.334e-3) {
    Submission s;
    for (const double h : {.6e-3, .3e-3, .15e-3}) s.meshes.push_back(written(h, low));
    s.contact.kinematics = ContactMethod::Kinematics::undeformed;
    return s;
}

std::vector<double>& values(MeshField& f, Meaning meaning) {
    return std::ranges::find(f.columns, meaning, &FieldColumn::meaning)->values;
}

Comparison compared(Submission s, const std::function<void(MeshField&)>& trap = {}) {
    if (trap)
        for (MeshField& f : s.meshes) trap(f);
    return compare(s, sheared());
}

/// The fields are those of the reference: what is left are cells at the contact's edge.
void expect_right(const Comparison& c) {
    EXPECT_LT(foreign::number(c, "pressure_l2").finest, .02);
    EXPECT_LT(foreign::number(c, "traction_l2").finest, .04);
    EXPECT_LT(std::abs(foreign::number(c, "tangential_force").finest), 1e-9);
    EXPECT_EQ(c.standing, Standing::pass);
}

TEST(SpatialTraps, Plain) {
    const Comparison c = compared(three());
    expect_right(c);
    for (const char* id : {"uncoupled", "one_step", "tangential_springs", "bound", "sign_or_axes"})
        EXPECT_FALSE(foreign::has(c, id)) << id;
}

TEST(SpatialTraps, HalfModel) {
    expect_right(compared(three(0), [](MeshField& f) {
        for (const char* key : {"normal_force", "tangential_force"}) f.totals.at(key).value /= 2;
    }));
}

TEST(SpatialTraps, TractionsOfTheOtherBody) {
    const Comparison c = compared(three(), [](MeshField& f) {
        for (const Meaning m : {Meaning::traction_x, Meaning::traction_y})
            for (double& t : values(f, m)) t = -t;
    });
    EXPECT_LT(foreign::number(c, "traction_l2").finest, .04);
    EXPECT_TRUE(foreign::has(c, "sign_or_axes"));
}

TEST(SpatialTraps, AxesExchanged) {
    const Comparison c = compared(three(), [](MeshField& f) {
        std::swap(values(f, Meaning::traction_x), values(f, Meaning::traction_y));
    });
    EXPECT_LT(foreign::number(c, "traction_l2").finest, .04);
    EXPECT_TRUE(foreign::has(c, "sign_or_axes"));
}

TEST(SpatialTraps, AnotherOrigin) {
    expect_right(compared(three(), [](MeshField& f) {
        for (double& x : values(f, Meaning::x)) x += 7e-3;
        for (double& y : values(f, Meaning::y)) y -= 3e-3;
    }));
}

TEST(SpatialTraps, NodalForcesInNewtons) {
    expect_right(compared(three(), [](MeshField& f) {
        const double h = f.totals.at("size").value;
        for (const Meaning m : {Meaning::pressure, Meaning::traction_x, Meaning::traction_y})
            for (double& v : values(f, m)) v *= h * h;
        for (FieldColumn& c : f.columns)
            if (c.meaning == Meaning::pressure)
                c.meaning = Meaning::force_normal, c.unit = "N";
            else if (c.meaning == Meaning::traction_x)
                c.meaning = Meaning::force_x, c.unit = "N";
            else if (c.meaning == Meaning::traction_y)
                c.meaning = Meaning::force_y, c.unit = "N";
        f.columns.push_back({"area", Meaning::area, "mm2", std::vector<double>(f.size(), h * h)});
    }));
}

TEST(SpatialTraps, ScatteredPoints) {
    // Points moved at random by a fifth of a cell: Delaunay's triangles instead of cells.
    std::mt19937 random(7);
    const Comparison c = compared(three(), [&](MeshField& f) {
        const double h = f.totals.at("size").value;
        std::uniform_real_distribution<double> move(-.2 * h, .2 * h);
        for (std::size_t i = 0; i < f.size(); ++i) {
            double& x = values(f, Meaning::x)[i];
            double& y = values(f, Meaning::y)[i];
            x += move(random);
            y += move(random);
            const SurfaceValues v = sheared().fields->at(x, y);
            values(f, Meaning::pressure)[i] = v.pressure;
            values(f, Meaning::traction_x)[i] = v.traction_x;
            values(f, Meaning::traction_y)[i] = v.traction_y;
        }
    });
    EXPECT_LT(foreign::number(c, "pressure_l2").finest, .03);
    EXPECT_LT(foreign::number(c, "load_within").finest, .01);
}

TEST(SpatialTraps, ProfileIsRefused) {
    Submission s = foreign::submission({"getfem_q2_1.csv"});
    EXPECT_THROW(compare(s, sheared()), contact::InputError);
}

TEST(SpatialTraps, FrictionThatDidNotAct) {
    const Comparison c = compared(three(), [](MeshField& f) {
        for (const Meaning m : {Meaning::traction_x, Meaning::traction_y})
            std::ranges::fill(values(f, m), 0.);
    });
    EXPECT_TRUE(foreign::has(c, "uncoupled"));
}

TEST(SpatialTraps, BoundExceeded) {
    const Comparison c = compared(three(), [](MeshField& f) {
        for (double& t : values(f, Meaning::traction_x)) t *= 1.1;
    });
    EXPECT_TRUE(foreign::has(c, "bound"));
}

TEST(SpatialTraps, ElasticSlipAndOneStep) {
    Submission s = three();
    s.contact.stick_slope = 26e9;
    s.contact.press_steps = 1;
    const Comparison c = compared(s);
    EXPECT_TRUE(foreign::has(c, "tangential_springs"));
    // CalculiX at 26 and 260 MPa/mm: -2.46 % between them, of which nine tenths are predicted.
    for (const Explained& e : foreign::number(c, "tangential_force").explained)
        if (e.id == "stick_slope") {
            EXPECT_NEAR(e.change, -.0246 / .9, .1 * .0246);
        }
}

}  // namespace spatial_traps
}  // namespace tricontact::benchmarks
