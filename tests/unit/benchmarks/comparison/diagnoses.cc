// Each diagnosis with a case in which it appears, and one in which it must not.
#include "benchmarks/comparison/diagnoses.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "tests/unit/benchmarks/foreign.h"

namespace tricontact::benchmarks {
namespace diagnosed {

Submission family() {
    return foreign::submission({"getfem_q2_family_4.csv", "getfem_q2_family_8.csv",
                                "getfem_q2_family_16.csv", "getfem_q2_family_32.csv"});
}

Submission meshes() {
    Submission s =
        foreign::submission({"getfem_q2_1.csv", "getfem_q2_0.5.csv", "getfem_q2_0.25.csv"});
    s.contact.kinematics = ContactMethod::Kinematics::undeformed;
    return s;
}

std::vector<double>& values(MeshField& field, Meaning meaning) {
    return std::ranges::find(field.columns, meaning, &FieldColumn::meaning)->values;
}

Submission with(Submission s, const std::function<void(MeshField&)>& change) {
    for (MeshField& field : s.meshes) change(field);
    return s;
}

void expect_only_with(const char* id, const Submission& shown, const Submission& not_shown) {
    EXPECT_TRUE(foreign::has(foreign::compared(shown), id)) << id;
    EXPECT_FALSE(foreign::has(foreign::compared(not_shown), id)) << id;
}

TEST(Diagnoses, NothingIsFoundInAGoodFamily) {
    Submission s = family();
    s.contact.kinematics = ContactMethod::Kinematics::undeformed;
    const Comparison c = foreign::compared(s);
    EXPECT_TRUE(c.diagnoses.empty()) << c.diagnoses.front().sentence;
}

TEST(Diagnoses, Penalty) {
    Submission soft = meshes(), stiff = meshes();
    soft.contact.stiffness = 260e9;
    stiff.contact.stiffness = 2.6e13;
    expect_only_with("penalty", soft, stiff);
}

TEST(Diagnoses, DisplacedSurface) {
    Submission displaced = meshes();
    displaced.contact.kinematics = ContactMethod::Kinematics::displaced;
    expect_only_with("displaced_surface", displaced, meshes());
}

TEST(Diagnoses, UnknownKinematics) {
    // Forces 2.2 % too large, as the displaced surface would have it, and nobody says why.
    const auto larger = [](MeshField& f) { f.totals.at("normal_force").value *= 1.022; };
    Submission unknown = with(meshes(), larger);
    const Submission said = unknown;
    unknown.contact.kinematics = ContactMethod::Kinematics::unknown;
    expect_only_with("kinematics_unknown", unknown, said);
}

TEST(Diagnoses, FiniteStrains) {
    Submission finite = meshes();
    finite.contact.kinematics = ContactMethod::Kinematics::finite;
    expect_only_with("finite_strain", finite, meshes());
}

TEST(Diagnoses, FiniteBlock) {
    Submission narrow = meshes(), wide = meshes();
    narrow.block_width = 8e-3;
    wide.block_width = 48e-3;
    expect_only_with("block", narrow, wide);
}

TEST(Diagnoses, FacetedIndenter) {
    // h^2/(8 R) = 3 um of 350 um at h = 1 mm; on faces of a quarter it is a sixteenth.
    Submission coarse = foreign::submission({"getfem_q2_1.csv"}), fine = meshes();
    coarse.contact.faceted_indenter = fine.contact.faceted_indenter = true;
    expect_only_with("indenter_facets", coarse, fine);
}

TEST(Diagnoses, AlternatingPressureAndFacets) {
    Submission rough = with(meshes(), [](MeshField& f) {
        auto& p = values(f, Meaning::pressure);
        for (std::size_t i = 0; i < p.size(); ++i) p[i] *= i % 2 ? 1.2 : .8;
    });
    rough.contact.stiffness = 8e12;
    expect_only_with("alternating", rough, meshes());
    expect_only_with("facets", rough, meshes());
}

TEST(Diagnoses, SpikeAtTheAxis) {
    expect_only_with("axis_spike",
                     with(family(),
                          [](MeshField& f) {
                              auto& p = values(f, Meaning::pressure);
                              p[0] *= -.8;
                              p[1] *= 2.3;
                          }),
                     family());
}

TEST(Diagnoses, ResultantOfTheField) {
    expect_only_with("resultant_mismatch",
                     with(meshes(),
                          [](MeshField& f) {
                              for (double& p : values(f, Meaning::pressure)) p *= 1.25;
                          }),
                     meshes());
}

TEST(Diagnoses, Equilibrium) {
    const auto base = [](double share) {
        return with(meshes(), [share](MeshField& f) {
            Total total = f.totals.at("normal_force");
            total.value *= -share;
            f.totals["balancing_force"] = total;
        });
    };
    expect_only_with("equilibrium", base(.97), base(1));
}

TEST(Diagnoses, OtherLoad) {
    const auto pressed = [](double depth) {
        return with(meshes(), [depth](MeshField& f) {
            f.totals["indentation"] = {depth, "mm", "file"};
        });
    };
    expect_only_with("load", pressed(.36e-3), pressed(.35e-3));
}

TEST(Diagnoses, OtherParameters) {
    // Plane stress in place of plane strain: all tractions times 1 - nu^2.
    const double factor = 1 - .3 * .3;
    const Submission stiff = with(meshes(), [factor](MeshField& f) {
        for (double& p : values(f, Meaning::pressure)) p *= factor;
        f.totals.at("normal_force").value *= factor;
    });
    expect_only_with("parameters", stiff, meshes());
    const Comparison c = foreign::compared(stiff);
    const auto found = std::ranges::find(c.diagnoses, "parameters", &Diagnosis::id);
    EXPECT_NE(found->sentence.find("plane stress"), std::string::npos) << found->sentence;
}

TEST(Diagnoses, MeshesThatAreNoFamily) {
    // Sizes that do not go with the numbers of points.
    Submission wrong = meshes();
    wrong.meshes[0].totals.at("size").value = 1.2e-3;
    wrong.meshes[1].totals.at("size").value = 1.1e-3;
    wrong.meshes[2].totals.at("size").value = 1e-3;
    expect_only_with("family", wrong, meshes());
    const Comparison c = foreign::compared(wrong);
    EXPECT_EQ(c.standing, Standing::not_resolved);
    EXPECT_NE(c.blame.find("no family"), std::string::npos);
}

TEST(Diagnoses, NumbersOfElementsShowIt) {
    Submission wrong = meshes();
    wrong.meshes[0].n_elements = 1000;
    wrong.meshes[1].n_elements = 4000;
    wrong.meshes[2].n_elements = 6000;  // layers that were not refined
    expect_only_with("family", wrong, meshes());
}

TEST(Diagnoses, EdgeBetweenNodes) {
    expect_only_with("edge_places", meshes(), family());
}

TEST(Diagnoses, FewElements) {
    Submission coarse = foreign::submission({"getfem_q2_1.csv"});
    coarse.meshes[0].totals.at("size").value = 2e-3;
    expect_only_with("few_elements", coarse, meshes());
}

}  // namespace diagnosed
}  // namespace tricontact::benchmarks
