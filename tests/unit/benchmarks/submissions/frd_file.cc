#include "benchmarks/submissions/frd_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>

#include "benchmarks/submissions/dat_totals.h"
#include "benchmarks/submissions/fixed_columns.h"
#include "benchmarks/submissions/read_field.h"
#include "contact/base/error.h"
#include "tests/paths.h"

namespace tricontact::benchmarks::frd_file_test {
namespace {

const std::string folder = paths::source("tests/benchmarks/");

MeshField field_of(const std::string& name) {
    return read_field({folder + name, "", ""});
}

const std::vector<double>& column(const MeshField& field, Meaning meaning) {
    const FieldColumn* found = field.find(meaning);
    if (!found) throw std::runtime_error("no such column");
    return found->values;
}

std::string text_of(const std::string& name) {
    std::ifstream in(folder + name, std::ios::binary);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

template <class F>
std::string message_of(F refused) {
    try {
        refused();
    } catch (const contact::InputError& error) {
        return error.what();
    }
    return "accepted";
}

/// ∫ f r dr over faces of three nodes (two corners, middle), by Simpson's rule.
double integral(const MeshField& field, const std::vector<double>& values) {
    const auto& r = column(field, Meaning::r);
    double sum = 0;
    for (int f = 0; f < field.faces.size(); ++f) {
        const auto* const p = &field.faces.points[static_cast<std::size_t>(
            field.faces.offsets[static_cast<std::size_t>(f)])];
        const auto a = static_cast<std::size_t>(p[0]), b = static_cast<std::size_t>(p[1]),
                   m = static_cast<std::size_t>(p[2]);
        sum += std::abs(r[b] - r[a]) / 6 *
               (values[a] * r[a] + 4 * values[m] * r[m] + values[b] * r[b]);
    }
    return sum;
}

TEST(FrdFile, StressAtTheSurfaceIntegratesToTheReactionOfTheDat) {
    for (const char* name : {"foreign/calculix_cax8r_1.frd", "foreign/calculix_cax8r_0.5.frd"}) {
        const MeshField field = field_of(name);
        EXPECT_EQ(field.format, "CalculiX frd");
        // A sector of two degrees: the reaction is 1/180 of that of the ring.
        const double whole =
            2 * std::numbers::pi * integral(field, column(field, Meaning::stress_zz));
        const double reaction = field.totals.at("normal_force").value;
        // 0.26 and 0.09 % were measured with the same runs.
        EXPECT_NEAR(whole / 180 / reaction, 1, .003);
        EXPECT_NEAR(field.totals.at(balancing_force).value / -reaction, 1, 1e-5);
        EXPECT_FALSE(field.totals.contains("tangential_force"));
        // Faces that touch: at h = 1 the edge is off by an eighth of an element.
        EXPECT_NEAR(
            field.totals.at("contact_area").value * 180 / (std::numbers::pi * 4.334 * 4.334), 1,
            .1);
    }
}

TEST(FrdFile, PointsBesideTheContactBelongToTheSurface) {
    const MeshField field = field_of("foreign/calculix_cax8r_1.frd");
    const auto& r = column(field, Meaning::r);
    EXPECT_EQ(field.size(), 33U);
    EXPECT_EQ(field.faces.size(), 16);
    EXPECT_TRUE(std::ranges::is_sorted(r));
    EXPECT_NEAR(r.back(), 48, 1e-9) << "radius of the block";
    for (const double z : column(field, Meaning::z)) EXPECT_EQ(z, 0);
    // d less the penetration p/K at r = 1, where p is that of the file.
    EXPECT_NEAR(column(field, Meaning::gap)[2], -1.05357 / 260, 2e-5);
}

TEST(FrdFile, WedgeOfTwoDegreesIsTheSameFieldAsItsPlaneOutput) {
    const MeshField plane = field_of("formats/calculix_CAX4_2d.frd"),
                    wedge = field_of("formats/calculix_CAX4_3d.frd");
    ASSERT_EQ(plane.size(), wedge.size());
    for (const Meaning meaning : {Meaning::r, Meaning::pressure, Meaning::displacement_x,
                                  Meaning::displacement_z, Meaning::stress_zz})
        for (std::size_t i = 0; i < plane.size(); ++i) {
            // The wedge's radial displacement stands at half a degree less: cos(1 degree).
            const double a = column(plane, meaning)[i], b = column(wedge, meaning)[i];
            EXPECT_NEAR(a, b, 2e-4 * std::abs(a) + 1e-6);
        }
}

TEST(FrdFile, SliceOfPlaneStrainIsAPlaneMesh) {
    const MeshField field = field_of("formats/calculix_CPE4_3d.frd");
    EXPECT_FALSE(field.find(Meaning::r));
    EXPECT_FALSE(field.find(Meaning::y));
    EXPECT_TRUE(std::ranges::is_sorted(column(field, Meaning::x)));
    EXPECT_GT(*std::ranges::max_element(column(field, Meaning::pressure)), .2);
}

TEST(FrdFile, AxesFollowTheNormalOfTheSurface) {
    const MeshField field = field_of("formats/calculix_C3D8_y.frd");
    // A half model whose indenter moves along y; its other half is at positive z.
    for (const double y : column(field, Meaning::y)) EXPECT_LE(y, 0);
    for (const double z : column(field, Meaning::z)) EXPECT_EQ(z, 0);
    const auto& down = column(field, Meaning::displacement_z);
    EXPECT_LT(*std::ranges::min_element(down), -.15);
    EXPECT_LT(field.totals.at("normal_force").value, 0);
    EXPECT_GT(field.totals.at("tangential_force").value, 0);
    for (int f = 0; f < field.faces.size(); ++f)
        EXPECT_EQ(field.faces.offsets[static_cast<std::size_t>(f) + 1] -
                      field.faces.offsets[static_cast<std::size_t>(f)],
                  4);
}

TEST(FrdFile, PrintOfTheLastTimeIsRead) {
    std::vector<std::string> notes;
    const auto totals = parse_dat(text_of("formats/calculix_CAX4_3d.dat"), "a.dat", "xzy", notes);
    EXPECT_NEAR(totals.at("normal_force").value, -totals.at(balancing_force).value, 1e-7);
    EXPECT_EQ(totals.at("normal_force").place, "a.dat:134, set NIND");
    EXPECT_GT(totals.at("stored_energy").value, 0);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_NE(notes[0].find("contact stress"), std::string::npos);
    // Without a field the largest force is along the normal.
    EXPECT_EQ(read_totals(folder + "formats/calculix_CAX4_3d.dat", notes).at("normal_force").value,
              totals.at("normal_force").value);
    EXPECT_TRUE(is_calculix_print(text_of("formats/calculix_CAX4_3d.dat")));
}

TEST(FrdFile, APrintBesideItThatHoldsNothingIsNoted) {
    namespace fs = std::filesystem;
    const fs::path work = fs::temp_directory_path() / ("frd_file_test_" + std::to_string(getpid()));
    fs::create_directories(work);
    std::ofstream(work / "a.frd") << text_of("formats/calculix_CAX4_2d.frd");
    std::ofstream(work / "a.dat") << "\n";
    const MeshField field = read_field({(work / "a.frd").string(), "", ""});
    EXPECT_TRUE(field.totals.empty());
    EXPECT_NE(field.notes.back().find("no resultants: "), std::string::npos);
    EXPECT_THROW(read_field({(work / "a.frd").string(), "", (work / "a.dat").string()}),
                 contact::InputError);
    fs::remove_all(work);
}

TEST(FrdFile, NumbersThatOverflowTheirFieldsAreRead) {
    EXPECT_EQ(fortran_number("-1.00000-100"), -1e-100);
    EXPECT_EQ(fortran_number(" 1.5D+02 "), 150);
    EXPECT_EQ(fortran_number("0."), 0);
    EXPECT_FALSE(fortran_number("1.0E+00-2"));
    EXPECT_EQ(numbers_of_twelve(" -1         1 1.00000E+00-2.00000E+00 3.00000E+00", 13, 3),
              (std::vector<double>{1, -2, 3}));
    EXPECT_EQ(numbers_of_twelve("-1.00000E-100 2.00000E+00-3.00000E+00", 0, 3),
              (std::vector<double>{-1e-100, 2, -3}));
    EXPECT_EQ(numbers_of_twelve(" 1.00000E+00", 0, 3).size(), 1U);
}

TEST(FrdFile, BrokenFilesAreRefused) {
    const std::string good = text_of("formats/calculix_CAX4_2d.frd");
    const auto refused = [&](std::string text) {
        return message_of([&] { parse_frd(text, "a.frd"); });
    };
    EXPECT_EQ(refused(good), "accepted");
    EXPECT_EQ(refused("").substr(0, 40), "a.frd: is no result file of CalculiX: it");
    EXPECT_NE(refused(good.substr(0, good.rfind(" -3"))).find("the file ends within a block"),
              std::string::npos);
    std::string binary = good;
    const auto heading = binary.find("    2C");
    binary[binary.find('\n', heading) - 1] = '3';
    EXPECT_NE(refused(binary).find("the results are binary"), std::string::npos);
    std::string lost = good;
    lost.replace(lost.find(" -1         2"), 13, " -1     70002");
    EXPECT_NE(refused(lost).find("whose coordinates are missing"), std::string::npos)
        << refused(lost);
    std::string no_number = good;
    no_number.replace(no_number.find(" -1         2") + 14, 7, "nan    ");
    EXPECT_NE(refused(no_number).find("three finite coordinates"), std::string::npos);
    // Cut anywhere, or with a byte changed, it is read or refused, and nothing else.
    for (std::size_t n = 0; n < good.size(); n += 997) refused(good.substr(0, n));
    for (std::size_t n = 0; n < good.size(); n += 61) {
        std::string changed = good;
        changed[n] = changed[n] == '9' ? '-' : '9';
        refused(changed);
    }
}

}  // namespace
}  // namespace tricontact::benchmarks::frd_file_test
