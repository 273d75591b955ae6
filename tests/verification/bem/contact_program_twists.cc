// Histories of shifts and twists beside the program CONTACT (github.com/eve70a/CONTACT, rev. 2707
// of 23 July 2025), drawn at random: T = 1 with forces and shifts along x and y, a body that moves,
// twists about the origin of the file and about SPINXO, SPINYO. What CONTACT prints stands behind
// each history.

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "bem/grid_compliance.h"
#include "bem/model.h"
#include "contact/run.h"
#include "contact_program/import.h"
#include "io/case/case_reader.h"

namespace tricontact::contact_program_twists_test {
namespace {

/// FN, FX, FY [N], MZ [N mm] on body 1, ELAST.EN. [J].
struct Printed {
    double normal, x, y, moment, energy;
};

struct History {
    const char* name;
    const char* steps;  ///< digits PBTNFS; loads; B(1) to B(6)
    std::vector<Printed> printed;
};

/// Two steel bodies on cells of 0.1 mm.
std::string input(const std::string& steps) {
    const std::string words[2][2] = {
        {" 0022020\n 0000241\n 999 999 50 1 1e-8\n",
         " .3 .3\n .28 .28 82000 82000\n 1\n 31 31 -1.55 -1.55 .1 .1\n"},
        {" 0100020\n 0110241\n", ""}};
    std::string text;
    std::istringstream lines(steps);
    std::string digits, loads, body;
    for (int k = 0;
         std::getline(lines, digits) && std::getline(lines, loads) && std::getline(lines, body);
         ++k) {
        const auto& [first, second] = words[k == 0 ? 0 : 1];
        text += " 3 MODULE\n " + digits + "\n" + first + " " + loads + "\n" + second + " 1 1\n " +
                body + "\n";
    }
    return text + " 0 MODULE\n";
}

const std::vector<History> histories{
    {"history_1_elsewhere",
     R"(201110
794.21817 0.37606104 9.7143454e-05 -0.00011895501 -0.332974 0.200168
0.01 0 0.006 -0 -0 0
001110
840.47841 -0.43164537 0.00023800162 -5.4988447e-06 0.336371 -0.195336
0.01 0 0.006 0.00282126101955 -0.000364626952379 0.00020452754411
)",
     {{794.2, 89.6, -7.016, 6.306, 0.002411}, {840.5, -108.8, -36.01, 12.66, 0.002662}}},
    {"history_1_origin",
     R"(201110
976.88564 -0.25196116 0.00051636172 -3.377916e-06
0.01 0 0.006 -0.000894064676915 -8.82941783526e-05 2.03086187431e-05
001110
917.08656 0.48594197 0.00030555563 -0.00059941623
0.01 0 0.006 -0.000322607693195 0.000809548327858 2.99089137234e-05
)",
     {{976.9, -73.84, -68.19, -2.324, 0.003395}, {917.1, 133.7, -94.93, 35.72, 0.003135}}},
    {"history_2_elsewhere",
     R"(201120
1047.8265 -0.45942756 -0.43586098 0.00096072004 -0.309736 -0.022919
0.01 0 0.006 0.00292357811353 0.000716423326596 0.000235068657268
001120
791.27405 0.019975316 0.1721473 0.00043255317 0.099821 -0.143723
0.01 0 0.006 0.000369186898647 -0.000474802785429 1.28007110305e-05
001120
903.77727 0.17825471 -0.21892965 -0.00029157057 0.051231 0.112788
0.01 0 0.006 -0.0016031772453 0.000323951847474 6.86271319744e-05
)",
     {{1048, -144.4, -137, -35.75, 0.003945},
      {791.3, 4.742, 40.86, -51.2, 0.002399},
      {903.8, 48.33, -59.36, -31.75, 0.002989}}},
    {"history_0_elsewhere",
     R"(201100
1088.6793 4.4347921e-05 0.00034894456 -0.00035921055 0.284627 -0.121194
0.01 0 0.01 -0.0031998698944 -0.00384394521045 0.00062537705305
001100
875.15096 0.00032188019 -1.5063009e-05 -0.00094317928 -0.348755 0.239888
0.01 0 0.01 -0.000696505392675 -0.00348935236599 0.000316517492402
001100
993.95296 -0.00043139976 -0.00042158934 3.3049835e-05 0.271981 0.151497
0.01 0 0.01 0.00126611676407 -0.00249937833007 0.000196248592427
)",
     {{1089, -20.06, -50.48, 20.01, 0.004408},
      {875.2, -42.62, -6.032, 63.69, 0.003095},
      {994, 12.85, 42.33, 43.13, 0.003808}}},
    {"history_0_origin",
     R"(201100
857.41216 8.2490609e-05 -0.00042413421 -0.00063092741
0.01 0 0.006 0.00370051301944 -0.00024802321005 0.00034490806154
001100
1063.4462 -0.00048570429 -0.0005256659 0.00090298987
0.01 0 0.006 0.00165922727403 -0.0020131081787 0.000237684401137
001100
833.47993 1.8344552e-05 -8.39025e-05 0.0002018596
0.01 0 0.006 7.09044067232e-05 -0.00138968634434 8.0593524858e-05
)",
     {{857.4, -11.67, 37.39, 34.87, 0.002719},
      {1063, 66.51, 114.7, -55.55, 0.003941},
      {833.5, 54.28, 108.4, -42.03, 0.002651}}},
    {"history_2_origin",
     R"(201120
604.73789 -0.24048111 -0.47309618 -0.0009239096
0.01 0 0.01 -0 -0 0
001120
1056.4432 -0.33914277 -0.26524591 0.00096298023
0.01 0 0.01 0.00133026972089 -0.00153472906738 0.000103125271014
001120
847.20288 -0.3666375 0.36960834 0.00060450515
0.01 0 0.01 0.00220567406938 -0.000564261202372 0.000129584720121
)",
     {{604.7, -43.63, -85.83, 22.4, 0.001707},
      {1056, -107.5, -84.07, -27.05, 0.004284},
      {847.2, -93.18, 93.94, -40.85, 0.002988}}},
};

TEST(ContactProgramTwists, RandomHistories) {
    constexpr double printed = 6e-4;  // of mu F_N: half of the last of four digits
    for (const History& history : histories) {
        SCOPED_TRACE(history.name);
        const contact_program::Import found =
            contact_program::import_cases(input(history.steps), "history.inp", bem::is_coupled);
        ASSERT_EQ(found.cases.size(), 1U);
        const contact::Case c = io::parse_case(found.cases[0].text, "history.toml");
        const bool about_origin = std::string(history.name).ends_with("origin");
        const auto steps = contact::run(c, *bem::make_model(c, 1)).steps;
        ASSERT_EQ(steps.size(), history.printed.size());
        for (std::size_t k = 0; k < steps.size(); ++k) {
            SCOPED_TRACE(k);
            const Printed& there = history.printed[k];
            const double limit = c.friction_coefficient() * there.normal;
            EXPECT_NEAR(steps[k].normal_force / there.normal, 1, printed);
            EXPECT_NEAR((steps[k].tangential_force[0] + there.x) / limit, 0, printed);
            EXPECT_NEAR((steps[k].tangential_force[1] + there.y) / limit, 0, printed);
            EXPECT_NEAR(steps[k].stored_energy / there.energy, 1, printed);
            // Of other points the moment that is printed is about the origin, not ours.
            if (about_origin) {
                EXPECT_NEAR((1e3 * steps[k].torque + there.moment) / limit, 0, printed);
            }
        }
    }
}

}  // namespace
}  // namespace tricontact::contact_program_twists_test
