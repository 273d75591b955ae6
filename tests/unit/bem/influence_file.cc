#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include "bem/grid_compliance.h"
#include "bem/model.h"
#include "bem/settings.h"
#include "contact/base/error.h"
#include "contact/cells.h"
#include "contact/run.h"

namespace tricontact::influence_file_test {
namespace {

using bem::Body;
using bem::InfluenceCoefficients;
using bem::InfluenceTable;
using contact::Case;

Case layer_case(double nu = .4) {
    Case c;
    c.indenter.radius = 40e-3;
    c.substrate = {5.2e6, nu};
    c.layer.thickness = 5e-3;
    c.friction.coefficient = .57;
    c.load.normal_force = 21.1;
    c.load.tangential_ratio = .5;
    c.load.press_steps = 2;
    c.of<contact::Cells>().per_radius = 6;
    return c;
}

class InfluenceFile : public testing::Test {
  protected:
    InfluenceFile() {
        path_ = testing::TempDir() + "influence_" +
                testing::UnitTest::GetInstance()->current_test_info()->name() + ".txt";
    }
    ~InfluenceFile() override { std::filesystem::remove(path_); }

    void write(const std::string& text) const { std::ofstream(path_, std::ios::binary) << text; }
    /// The message on reading the text, without the file's name.
    std::string message(const std::string& text) const {
        write(text);
        try {
            bem::read_influence(path_);
        } catch (const contact::InputError& error) {
            const std::string what = error.what();
            EXPECT_EQ(what.rfind(path_ + ':', 0), 0U) << what;
            return what.substr(path_.size() + 1);
        }
        return "no error";
    }

    std::string path_;
};

void expect_same_bits(double a, double b) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(a), std::bit_cast<std::uint64_t>(b)) << a << ' ' << b;
}

TEST_F(InfluenceFile, ReadsBackToTheSameBits) {
    for (const Body body : {Body::half_space, Body::layer}) {
        const InfluenceTable table = bem::case_influence(layer_case(), 1, body);
        write(bem::influence_text(table));
        const InfluenceTable back = bem::read_influence(path_);
        expect_same_bits(back.spacing, table.spacing);
        ASSERT_EQ(back.n_x, table.n_x);
        ASSERT_EQ(back.n_y, table.n_y);
        ASSERT_EQ(back.cells.size(), table.cells.size());
        using K = InfluenceCoefficients;
        for (std::size_t i = 0; i < table.cells.size(); ++i)
            for (double K::*k : {&K::xx, &K::xy, &K::yy, &K::xz, &K::yz, &K::zz})
                expect_same_bits(back.cells[i].*k, table.cells[i].*k);
        EXPECT_TRUE(bem::influence_text(back) == bem::influence_text(table));
    }
}

TEST_F(InfluenceFile, GivesTheSameRun) {
    for (const Body body : {Body::half_space, Body::layer})
        for (const double nu : {.4, .5}) {
            Case c = layer_case(nu);
            const auto own = contact::run(c, *bem::make_model(c, 1, body));
            write(bem::influence_text(bem::case_influence(c, 1, body)));
            c.of<bem::Settings>().influence = path_;
            const auto read = contact::run(c, *bem::make_model(c, 1, body));
            ASSERT_EQ(own.steps.size(), read.steps.size());
            for (std::size_t k = 0; k < own.steps.size(); ++k) {
                expect_same_bits(own.steps[k].shift[0], read.steps[k].shift[0]);
                expect_same_bits(own.steps[k].indentation, read.steps[k].indentation);
            }
            expect_same_bits(own.static_shift, read.static_shift);
        }
}

TEST_F(InfluenceFile, MustFitTheGrid) {
    Case c = layer_case();
    InfluenceTable table = bem::case_influence(c, 1, Body::layer);
    c.of<bem::Settings>().influence = path_;
    const auto refused = [&](const InfluenceTable& other) -> std::string {
        write(bem::influence_text(other));
        try {
            bem::make_model(c, 1, Body::layer);
        } catch (const contact::InputError& error) {
            return std::string(error.what()).substr(path_.size());
        }
        return "no error";
    };
    EXPECT_EQ(refused(table), "no error");
    InfluenceTable other = table;
    other.spacing *= 1 + 1e-6;
    EXPECT_NE(refused(other).find("coefficients of cells of"), std::string::npos);
    // The last position is one of the padding, farther than any two cells lie apart.
    const auto with_rows = [&](int n_y) {
        InfluenceTable cut = table;
        cut.n_y = n_y;
        cut.cells.resize(static_cast<std::size_t>(cut.n_x) * n_y);
        return cut;
    };
    EXPECT_EQ(refused(with_rows(table.n_y - 1)), "no error");
    other = with_rows(3);
    EXPECT_NE(refused(other).find("positions, but contact and rolling path need"),
              std::string::npos);
}

TEST_F(InfluenceFile, RefusesWhatIsNoneOrNotWhole) {
    InfluenceTable table{2e-4, 2, 2, {}};
    for (int k = 0; k < 4; ++k) table.cells.push_back({3, 0, 2, 0, 0, 4});
    table.cells[1].xz = -.5;
    table.cells[2].yz = -.25;
    table.cells[3].xy = .125;
    const std::string good = bem::influence_text(table);
    EXPECT_EQ(message(good), "no error");
    EXPECT_EQ(message("# a remark\n\n" + good.substr(good.find('\n') + 1)),
              "6: this is no file of influence coefficients; its first line has to be \"tricontact "
              "influence coefficients, version 1\"");
    EXPECT_EQ(message(""), "1: the file ends here, but is not complete; write it again");

    const auto with = [&](const std::string& old, const std::string& text) {
        std::string changed = good;
        const auto at = changed.find(old);
        EXPECT_NE(at, std::string::npos) << old;
        return message(changed.replace(at, old.size(), text));
    };
    EXPECT_EQ(with("version 1", "version 2"),
              "1: version 2 is not 1, the only one known; write the file again by tricontact "
              "influence");
    EXPECT_EQ(with("m/Pa\n", "mm/MPa\n"), "5: the unit is not m/Pa; convert the coefficients");
    EXPECT_EQ(with("spacing_m 0.0002", "spacing_m -0.0002"),
              "6: a spacing of -0.0002 m is not positive and finite; correct it");
    EXPECT_EQ(with("spacing_m 0.0002", "spacing_m 0.2 mm"),
              "6: \"mm\" is more than the line may hold; omit it");
    EXPECT_EQ(with("positions_x 2", "positions_x 0"),
              "7: positions_x = 0 is not between 1 and 8193; correct it");
    EXPECT_EQ(with("positions_y", "rows"),
              "8: \"rows\" where \"positions_y\" is due; keep the order of "
              "docs/reference/influence-format.md");
    EXPECT_EQ(with("xz yx", "yx xz"),
              "9: other components, or in another order; give components xx xy xz yx yy yz zx zy "
              "zz");
    EXPECT_EQ(with("\n1 0 3", "\n1 0 nan"), "11: nan is no finite number; correct it");
    EXPECT_EQ(with("\n1 0 3", "\n1 0 inf"), "11: inf is no finite number; correct it");
    EXPECT_EQ(with("\n1 0 3", "\n1 0 3D0"),
              "11: \"3D0\" is no number; numbers look like 1.5e-12, with blanks between them");
    EXPECT_EQ(with("\n1 0 3", "\n0 1 3"),
              "11: position 0 1 where 1 0 is due; give every position once, i running fastest");
    EXPECT_EQ(with("\n0 0 3", "\n0 0 -3"),
              "10: a cell must follow its own traction: K_xx, K_yy, K_zz > 0; correct the signs");
    EXPECT_EQ(with("end\n", ""), "14: the file ends here, but is not complete; write it again");
    EXPECT_EQ(message(good.substr(0, good.size() - 12)),
              "13: \"\" is no number; numbers look like 1.5e-12, with blanks between them");
    EXPECT_EQ(with("end\n", "0 2 3 0 0 0 2 0 0 0 4\n"),
              "14: more lines than positions; give every position once, then \"end\"");
    try {
        bem::read_influence("/no/such/file");
        FAIL();
    } catch (const contact::InputError& error) {
        EXPECT_NE(std::string(error.what()).find("there is no such file"), std::string::npos);
    }
}

TEST_F(InfluenceFile, RefusesSignsThatNoReciprocalBodiesHave) {
    const std::string head =
        "tricontact influence coefficients, version 1\nunit m/Pa\nspacing_m 1\n"
        "positions_x 2\npositions_y 2\ncomponents xx xy xz yx yy yz zx zy zz\n";
    const auto with = [&](const std::string& last) {
        return message(head + "0 0 3 0 0 0 2 0 0 0 4\n1 0 3 0 .5 0 2 0 -.5 0 4\n" +
                       "0 1 3 0 0 0 2 .5 0 -.5 4\n" + last + "\nend\n");
    };
    EXPECT_EQ(with("1 1 3 .1 .5 .1 2 .5 -.5 -.5 4"), "no error");
    const std::string remedy =
        "; correct the signs: tractions act on the substrate, z points into it";
    EXPECT_EQ(with("1 1 3 .1 .5 .1 2 .5 .5 -.5 4"),
              "10: K_xz = -K_zx at 1 1 is broken by 1 m/Pa" + remedy);
    EXPECT_EQ(with("1 1 3 .1 .5 .1 2 .5 -.5 .5 4"),
              "10: K_yz = -K_zy at 1 1 is broken by 1 m/Pa" + remedy);
    EXPECT_EQ(with("1 1 3 .1 .5 -.1 2 .5 -.5 -.5 4"),
              "10: K_xy = K_yx at 1 1 is broken by 0.2 m/Pa" + remedy);
    EXPECT_EQ(message(head + "0 0 3 0 .5 0 2 0 -.5 0 4\n"),
              "7: K_xz = 0 on x = 0 at 0 0 is broken by 0.5 m/Pa" + remedy);
    EXPECT_EQ(message(head + "0 0 3 0 0 0 2 .5 0 -.5 4\n"),
              "7: K_yz = 0 on y = 0 at 0 0 is broken by 0.5 m/Pa" + remedy);
    EXPECT_EQ(message(head + "0 0 3 .5 0 .5 2 0 0 0 4\n"),
              "7: K_xy = 0 on the axes at 0 0 is broken by 0.5 m/Pa" + remedy);
}

// Where a part of the stiffness relaxes, the body takes many states.
TEST_F(InfluenceFile, HoldsForOneStateOfTheMaterial) {
    Case c = layer_case();
    write(bem::influence_text(bem::case_influence(c, 1, Body::layer)));
    c.of<bem::Settings>().influence = path_;
    c.relaxation = contact::Relaxation{{{.5, 1}}, contact::Relaxation::Bulk::proportional};
    EXPECT_NO_THROW(bem::make_model(c, 1, Body::layer));
    c.relaxation->bulk = contact::Relaxation::Bulk::elastic;
    try {
        bem::make_model(c, 1, Body::layer);
        FAIL() << "no error";
    } catch (const contact::InputError& error) {
        EXPECT_STREQ(error.what(),
                     "bem.influence: the file's coefficients hold for one state of the material, "
                     "but here a part of the stiffness relaxes and a part does not; omit "
                     "bem.influence");
    }
}

}  // namespace
}  // namespace tricontact::influence_file_test
