#include <fmt/format.h>

#include "contact_program/case_parts.h"
#include "contact_program/program_case.h"
#include "io/keys/messages.h"

namespace tricontact::contact_program {

namespace {

/// Refuses what the lines of a case say, digit by digit where they were kept.
class KnownCase {
  public:
    KnownCase(const ProgramCase& one, const std::string& name) : one_(one), name_(name) {}

    void check() const {
        check_known_digits(one_.digits, name_);
        check_kept();
        check_body();
        check_motion();
    }

  private:
    void check_kept() const {
        if (one_.friction_temperature && one_.step.tangential && !has_heat(one_))
            refuse_at(name_, one_.friction_line, "L = 6",
                      "friction that changes with the temperature is computed in steady rolling "
                      "alone, with data of heat",
                      "give T = 3 and H = 3, or L = 0");
        if (one_.has_temperature_memory)
            refuse_at(name_, one_.friction_line, "MEMDST",
                      "friction follows the temperature at once", "give 0");
        if (one_.friction_rate && one_.step.tangential && !one_.step.is_steady())
            refuse_at(name_, one_.friction_line, fmt::format("L = {}", one_.friction_law),
                      "friction that falls with the slip velocity is computed in steady rolling "
                      "alone",
                      "give T = 3, or L = 0");
        if (one_.step.tangential && one_.friction_coefficient == 0)
            refuse_at(name_, one_.friction_line, "FSTAT = 0",
                      "no tangential problem is solved without friction",
                      "give T = 0, or a positive FSTAT");
        if (one_.digits.material == 4 && one_.third_body->yield_stress > 0 &&
            one_.step.is_rolling() && one_.third_body->hardening != 0)
            refuse_at(name_, one_.third_body->line,
                      fmt::format("K_TAU = {}", 1e-9 * one_.third_body->hardening),
                      "a layer that hardens does not roll on here", "give 0, or T = 1");
        if (one_.influence != 2 && one_.influence != 9)
            refuse_at(
                name_, one_.materials_line, fmt::format("C = {}", one_.influence),
                "only half-spaces with constant tractions per cell and coefficients of a file "
                "are read",
                "give 2 or 9");
        if (one_.has_extra_slip)
            refuse_at(name_, one_.digits.lines[1], fmt::format("E = {}", one_.digits.extra),
                      "creepages are the same everywhere but for spin: no slip per cell",
                      "give E = 0 and CKSI, CETA, CPHI");
    }

    void check_body() const {
        const UndeformedDistance& body = one_.distance;
        if (body.planform != 1)
            refuse_at(name_, body.line, fmt::format("IPLAN = {}", body.planform),
                      "no planform is cut out of the cells", "give 1");
        if (body.heights) {
            if (!is_close(one_.spacing[0], one_.spacing[1]))
                refuse_at(name_, one_.cells_line, "DX, DY", "heights stand on squares here",
                          "give the same size, or a quadratic body by IBASE = 1");
            return;
        }
        if (one_.is_hertzian && body.curvature[0] == 0)
            refuse_at(name_, one_.cells_line, "IPOTCN = -6",
                      "there are no contacts of half ellipses",
                      "give the cells by 1 and the body by IBASE");
        if (body.is_turned)
            refuse_at(name_, body.data_line, "B(2)", "the body's axes must be those of x and y",
                      "turn the axes");
        for (const int axis : {0, 1})
            if (!(body.curvature[axis] >= 0))
                refuse_at(name_, body.data_line, axis == 0 ? "B(1)" : "B(3)",
                          "a body must be convex", "correct it");
        if (body.curvature[0] == 0 || body.is_inclined)
            refuse_at(name_, body.data_line, "B(I)",
                      "a body must be curved along x, and where it is inclined", "correct it");
        if ((one_.n_y == 1) != (body.curvature[1] == 0))
            refuse_at(
                name_, body.data_line, fmt::format("MY = {}", one_.n_y),
                "a body that is straight along y has one row of cells; one that is curved, more",
                "give MY = 1 with B(3) = 0, or more rows");
    }

    void check_motion() const {
        if (one_.digits.material == 1 && !one_.step.is_steady())
            refuse_at(name_, one_.digits.lines[1], "M = 1",
                      "viscoelastic bodies are read in steady rolling alone, as CONTACT takes them",
                      "give T = 3");
    }

    const ProgramCase& one_;
    const std::string& name_;
};

}  // namespace

void check_known(const ProgramCase& one, const std::string& name) {
    KnownCase(one, name).check();
}

}  // namespace tricontact::contact_program
