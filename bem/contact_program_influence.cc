#include "bem/contact_program_influence.h"

#include <fmt/format.h>

#include <array>
#include <cstdlib>

namespace tricontact::bem {

namespace {

constexpr double mm = 1e3;  // in 1 m

using Nine = std::array<double, 9>;

/// nn nx ny xn xx xy yn yx yy of the indenter's displacement less the substrate's, per traction on
/// the indenter, n into it: what couples n with x and y has the other sign than in the table, whose
/// tractions and displacements are the substrate's, z into it. `sign_y`: of the position.
Nine of_indenter(const InfluenceCoefficients& k, int sign_y, bool coupled) {
    const double s = sign_y, c = coupled ? 1 : 0;
    return {k.zz,     -c * k.zx,     -s * c * k.zy, -c * k.xz, k.xx,
            s * k.xy, -s * c * k.yz, s * k.yx(),    k.yy};
}

}  // namespace

std::string contact_program_influence(const InfluenceTable& table, double shear_modulus,
                                      bool coupled) {
    std::string text = fmt::format(
        " 1 1   % nmatrix, iaconvex: one matrix, body 1 is convex\n"
        " 0 312 % lquasid, xyzordr: nine columns, n x y\n"
        " 1 0   % lsymmx, lsymmy: only ix >= 0, all iy\n"
        " {} {} {} {} % mx, my, dx, dy\n",
        table.n_x, table.n_y, mm * table.spacing, mm * table.spacing);
    for (int j = 1 - table.n_y; j < table.n_y; ++j) {
        text += fmt::format("% iy = {}\n% ix x nn nx ny xn xx xy yn yx yy\n", j);
        for (int i = 0; i < table.n_x; ++i) {
            Nine a = of_indenter(table.at(i, std::abs(j)), j < 0 ? -1 : 1, coupled);
            for (double& value : a) value = mm * shear_modulus * value + 0.0;  // no -0
            fmt::format_to(std::back_inserter(text), " {} {} {}\n", i, mm * table.spacing * i,
                           fmt::join(a, " "));
        }
    }
    return text;
}

}  // namespace tricontact::bem
