#include "benchmarks/submissions/column_names.h"

#include <gtest/gtest.h>

namespace tricontact::benchmarks::column_names_test {
namespace {

TEST(ColumnNames, AreReadAsPeopleAndProgramsWriteThem) {
    using enum Meaning;
    const std::vector<std::pair<Meaning, std::vector<const char*>>> all{
        {pressure,
         {"p", "P", "pressure", "CPRESS", "contact_pressure", "Contact Pressure", "sigma_n",
          "\u03c3_n", "normal traction", "pn", "CONTACT_PRESSURE", "lambda_n", "CONTPRES",
          "NORMAL_CONTACT_STRESS", "frictional_normal_lm", "press"}},
        {traction_x,
         {"tx", "tau_x", "CSHEAR1", "qx", "\u03c4_x", "traction_x", "traction:0", "px"}},
        {traction_y, {"ty", "tau_y", "CSHEAR2", "contact_traction_y", "shear_y"}},
        {traction_z, {"tz", "contact_traction_z", "traction:2"}},
        {x, {"x", "X", "coord1", "X-Coord", "COORD.COOR1", "Points:0", "x1", "x_coordinate"}},
        {y, {"y", "Y", "coor2", "Points:1", "x2"}},
        {z, {"z", "Z", "Points:2", "x3"}},
        {r, {"r", "R", "radius", "radial coordinate"}},
        {area, {"area", "Area", "weight", "CNAREA", "JxW", "nodal_area"}},
        {force_normal, {"fn", "F_n", "normal_force", "CNORMF", "contact_force"}},
        {force_x, {"fx", "F1", "nodal_force_x", "force:0"}},
        {displacement_x, {"ux", "U1", "u_x", "u:0", "disp_x", "D1", "displacement_r", "ur"}},
        {displacement_z, {"uz", "U3", "disp_z", "D3", "displacement:2"}},
        {stress_zz, {"szz", "S33", "sigma_zz", "stress_zz", "SZZ"}},
        {gap, {"gap", "COPEN", "contact_gap", "g"}},
        {status, {"status", "contact state", "CSTATUS"}},
        {other, {"Node", "Node Label", "element", "temperature", "1", "", "tr", "fr", "RF1", "t"}}};
    for (const auto& [meaning, names] : all)
        for (const char* name : names) EXPECT_EQ(recognised(name).meaning, meaning) << name;
}

TEST(ColumnNames, OfTheContactAreSpecific) {
    EXPECT_TRUE(recognised("CPRESS").is_specific);
    EXPECT_FALSE(recognised("pressure").is_specific);
}

TEST(ColumnNames, OfComponentsFollowTheAxes) {
    EXPECT_EQ(component_names("u", 3), (std::vector<std::string>{"u_x", "u_y", "u_z"}));
    EXPECT_EQ(component_names("u", 3, "xzy"), (std::vector<std::string>{"u_x", "u_z", "u_y"}));
    // VTK's order of a symmetric tensor: xx yy zz xy yz xz.
    const auto stresses = component_names("stress", 6, "xzy");
    EXPECT_EQ(recognised(stresses[1]).meaning, Meaning::stress_zz);
    EXPECT_EQ(recognised(stresses[3]).meaning, Meaning::stress_xz);
    EXPECT_EQ(recognised(stresses[4]).meaning, Meaning::stress_yz);
    EXPECT_EQ(recognised(component_names("stress", 9)[8]).meaning, Meaning::stress_zz);
}

}  // namespace
}  // namespace tricontact::benchmarks::column_names_test
