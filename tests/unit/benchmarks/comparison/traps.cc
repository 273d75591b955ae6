// Conventions of other codes, set as traps into GetFEM's results: each is read rightly, or refused
// with a hint.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "benchmarks/comparison/tributary_areas.h"
#include "contact/base/error.h"
#include "tests/unit/benchmarks/foreign.h"

namespace tricontact::benchmarks {
namespace traps {

using std::numbers::pi;
using Trap = std::function<void(MeshField&)>;

FieldColumn& column(MeshField& field, Meaning meaning) {
    return *std::ranges::find(field.columns, meaning, &FieldColumn::meaning);
}

void scale(MeshField& field, Meaning meaning, double factor) {
    for (double& v : column(field, meaning).values) v *= factor;
}

/// As numbers without a unit: `unit` in SI.
void strip(MeshField& field, Meaning meaning, double unit) {
    scale(field, meaning, 1 / unit);
    column(field, meaning).unit.reset();
}

void strip_force(MeshField& field, double unit) {
    field.totals.at("normal_force").value /= unit;
    field.totals.at("normal_force").unit.reset();
}

/// Ring areas of the points [m^2].
std::vector<double> rings(MeshField& field) {
    const auto& r = column(field, Meaning::r).values;
    const LineCells cells = line_cells(r, true);
    std::vector<double> areas;
    for (std::size_t i = 0; i < r.size(); ++i)
        areas.push_back(pi * (cells.high[i] * cells.high[i] - cells.low[i] * cells.low[i]));
    return areas;
}

void to_forces(MeshField& field, double share) {
    const auto areas = rings(field);
    FieldColumn& p = column(field, Meaning::pressure);
    for (std::size_t i = 0; i < areas.size(); ++i) p.values[i] *= areas[i] * share;
    p.unit = "N";
    p.meaning = Meaning::force_normal;
}

Comparison trapped(const Trap& trap) {
    Submission s =
        foreign::submission({"getfem_q2_1.csv", "getfem_q2_0.5.csv", "getfem_q2_0.25.csv"});
    for (MeshField& field : s.meshes) trap(field);
    return foreign::compared(s);
}

/// As without the trap; `by`: what its nodal values, rounded or shared, may move.
void expect_same(const Comparison& c, double by = 1e-6) {
    static const Comparison plain = trapped([](MeshField&) {});
    for (const char* key : {"normal_force", "peak_pressure", "contact_radius", "pressure_l2"}) {
        const ComparedNumber &own = foreign::number(c, key), &other = foreign::number(plain, key);
        EXPECT_NEAR(own.finest, other.finest, by) << key;
    }
    EXPECT_EQ(c.standing, plain.standing);
}

void expect_refused(const Trap& trap, const std::string& hint) {
    try {
        trapped(trap);
        FAIL() << "not refused";
    } catch (const contact::InputError& error) {
        EXPECT_NE(std::string(error.what()).find(hint), std::string::npos) << error.what();
    }
}

TEST(Traps, UnitsOfPressure) {
    for (const double unit : {1., 1e3, 1e6, 6894.757293168}) {
        const Comparison c = trapped([unit](MeshField& f) { strip(f, Meaning::pressure, unit); });
        expect_same(c);
        EXPECT_TRUE(foreign::has(c, "units"));
    }
}

TEST(Traps, UnknownUnitOfPressureIsRefusedWithTheNearest) {
    expect_refused([](MeshField& f) { strip(f, Meaning::pressure, 101325); }, "nearest are");
}

TEST(Traps, UnitsOfLength) {
    for (const double unit : {1., 1e-3, 1e-6, 1e-2, .0254})
        expect_same(trapped([unit](MeshField& f) {
            strip(f, Meaning::r, unit);
            f.totals.at("size").value /= unit;
            f.totals.at("size").unit.reset();
        }));
}

TEST(Traps, UnitsAllMissing) {
    expect_same(trapped([](MeshField& f) {
        strip(f, Meaning::r, 1e-3);
        strip(f, Meaning::pressure, 1e6);
        strip_force(f, 1e3);
        f.totals.erase("size");
    }));
}

TEST(Traps, TensionPositive) {
    const Comparison c = trapped([](MeshField& f) { scale(f, Meaning::pressure, -1); });
    expect_same(c);
    EXPECT_TRUE(foreign::has(c, "sign_or_axes"));
}

TEST(Traps, NodalForces) {
    const Comparison c = trapped([](MeshField& f) { to_forces(f, 1); });
    expect_same(c, 1e-9);
    EXPECT_TRUE(foreign::has(c, "nodal_forces"));
}

TEST(Traps, NodalForcesOfASector) {
    expect_same(trapped([](MeshField& f) { to_forces(f, 1. / 180); }), 1e-9);
    expect_same(trapped([](MeshField& f) { to_forces(f, 1 / (2 * pi)); }), 1e-9);
}

TEST(Traps, ForceOfASector) {
    for (const double part : {180., 2 * pi}) {
        const Comparison c =
            trapped([part](MeshField& f) { f.totals.at("normal_force").value /= part; });
        expect_same(c);
        EXPECT_TRUE(foreign::has(c, "share"));
    }
}

TEST(Traps, UnitsOfForce) {
    for (const double unit : {1., 1e3, 1e-3, 4.4482216152605})
        expect_same(trapped([unit](MeshField& f) { strip_force(f, unit); }));
}

TEST(Traps, NegativeForce) {
    expect_same(trapped([](MeshField& f) { f.totals.at("normal_force").value *= -1; }));
}

TEST(Traps, HalfOfTheForceIsRefused) {
    expect_refused([](MeshField& f) { f.totals.at("normal_force").value /= 2; },
                   "of the integral of the pressures");
}

TEST(Traps, HalfOfTheLoadFails) {
    const Comparison c = trapped([](MeshField& f) {
        f.totals.at("normal_force").value /= 2;
        scale(f, Meaning::pressure, .5);
    });
    EXPECT_EQ(c.standing, Standing::fail);
    EXPECT_TRUE(foreign::has(c, "half_load"));
}

TEST(Traps, WrongUnitOfLengthIsRefused) {
    expect_refused([](MeshField& f) { scale(f, Meaning::r, 1e3); },
                   "check the unit of the positions");
}

TEST(Traps, OrderOfPoints) {
    expect_same(trapped([](MeshField& f) {
        for (FieldColumn& c : f.columns) std::ranges::reverse(c.values);
    }));
}

TEST(Traps, PointsTwice) {  // both faces of a thin sector
    expect_same(trapped([](MeshField& f) {
        for (FieldColumn& c : f.columns) {
            const std::vector<double> once(c.values);
            c.values.insert(c.values.end(), once.begin(), once.end());
        }
    }));
}

TEST(Traps, ProfileOverTheDiameter) {
    expect_same(trapped([](MeshField& f) {
                    FieldColumn& r = column(f, Meaning::r);
                    FieldColumn& p = column(f, Meaning::pressure);
                    r.meaning = Meaning::x;
                    const std::size_t n = r.values.size();
                    for (std::size_t i = 1; i < n; ++i) {
                        r.values.push_back(-r.values[i]);
                        p.values.push_back(p.values[i]);
                    }
                }),
                5e-5);  // the fit of the peak counts the axis once, all else twice
}

TEST(Traps, HeightBesidePositions) {
    expect_same(trapped([](MeshField& f) {
        column(f, Meaning::r).meaning = Meaning::x;
        f.columns.push_back({"y", Meaning::y, "mm", std::vector<double>(f.size(), 8e-3)});
    }));
}

TEST(Traps, DeformedPositions) {
    // Points follow the paraboloid, and stand where the reference's u_r has moved them.
    const Comparison c = trapped([](MeshField& f) {
        FieldColumn& x = column(f, Meaning::r);
        x.meaning = Meaning::x;
        std::vector<double> height;
        for (double& r : x.values) {
            const SurfaceValues u = foreign::layer_pressed().fields->at(r, 0);
            height.push_back(-u.displacement_z);
            r += u.displacement_x;
        }
        f.columns.push_back({"y", Meaning::y, "mm", height});
    });
    expect_same(c, 2e-3);
    EXPECT_TRUE(foreign::has(c, "deformed_positions"));
}

TEST(Traps, NothingPressesIsRefused) {
    expect_refused([](MeshField& f) { scale(f, Meaning::pressure, 0); }, "");
}

TEST(Traps, ForceAsPressureIsAmbiguousOrRead) {
    // Nodal forces under a heading of pressures and without a unit: the sum decides.
    expect_same(trapped([](MeshField& f) {
                    to_forces(f, 1);
                    FieldColumn& p = column(f, Meaning::force_normal);
                    p.meaning = Meaning::pressure;
                    p.unit.reset();
                }),
                1e-9);
}

}  // namespace traps
}  // namespace tricontact::benchmarks
