// What models make of the bodies of a case, said without a report.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "comparisons/quantities/quantities.h"
#include "comparisons/run/reading.h"
#include "contact/models/model_kind.h"

namespace tricontact::comparisons::limitations_test {
namespace {

contact::Case sphere_on_layer() {
    contact::Case c;
    c.indenter.radius = .04;
    c.substrate = {5.2e6, .3};
    c.layer.thickness = 8e-3;
    c.friction.coefficient = .57;
    c.load.normal_force = 20;
    c.load.tangential_ratio = .3;
    return c;
}

std::string said(const contact::Case& c, const std::vector<std::string>& models) {
    return fmt::format("{}", fmt::join(body_limitations(c, models), " "));
}

// A half-space is never taken for a layer without a word; what sees the layer leaves nothing out.
TEST(BodyLimitations, NameTheLayerThatIsNotSeen) {
    for (const char* model : {contact::models::mdr, contact::models::bem})
        EXPECT_NE(said(sphere_on_layer(), {model}).find("the thickness of the layer is not seen"),
                  std::string::npos)
            << model;
    EXPECT_NE(said(sphere_on_layer(), {"mdr"}).find("uncoupled (Dundurs' β = 0.29)"),
              std::string::npos);
    EXPECT_EQ(said(sphere_on_layer(), {contact::models::bem_layer}), "");
    contact::Case half_space = sphere_on_layer();
    half_space.layer = {};
    half_space.substrate.poisson = .5;
    EXPECT_EQ(said(half_space, {"mdr", "bem"}), "");
}

TEST(BodyLimitations, NameSidesAndDirection) {
    contact::Case c = sphere_on_layer();
    c.layer.width = .06;
    EXPECT_NE(said(c, {"bem-layer"}).find("BEM layer leaves out substrate.width"),
              std::string::npos);
    EXPECT_EQ(said(c, {"fem"}).find("width"), std::string::npos);
    c.indenter.material = contact::Material{2e7, .3};
    EXPECT_NE(said(c, {"fem"}).find("FEM leaves out indenter.young"), std::string::npos);
    c.rolling.emplace().amplitude = 1e-3;
    EXPECT_NE(said(c, {"mdr"}).find("cannot distinguish rolling along the load"),
              std::string::npos);
}

// A cylinder of finite size on its hub: what small strains and pairs that stay leave out is said
// where it rolls, of the models that mesh it.
TEST(Limitations, NameWhatRollingBodiesLeaveOut) {
    contact::Case c = sphere_on_layer();
    c.indenter.shape = contact::Case::Shape::cylinder;
    c.indenter.material = c.substrate;
    c.indenter.body = {.form = contact::ElasticBody::Form::cylinder,
                       .support = contact::ElasticBody::Support::hub,
                       .hub_radius = .01};
    std::vector<Results> results(2);
    results[0].model = contact::models::bem;
    results[1].model = contact::models::fem_plane;
    for (Results& r : results) {
        r.set(quantities::contact_radius, 2e-3);
        r.set(quantities::final_shift, -1e-4);
    }
    const auto sentences = [&] {
        return fmt::format("{}", fmt::join(limitations(c, results), " "));
    };
    EXPECT_EQ(sentences().find("creeps"), std::string::npos);
    c.rolling.emplace().amplitude = 1e-3;
    EXPECT_NE(sentences().find("FEM plane strain: without a tangential force too the cylinder "
                               "creeps by about (a/R)² = 0.0025 of its way"),
              std::string::npos)
        << sentences();
    EXPECT_NE(sentences().find("the shift is 5.0 % of the contact radius"), std::string::npos)
        << sentences();
    EXPECT_EQ(sentences().find("BEM: without"), std::string::npos);
}

}  // namespace
}  // namespace tricontact::comparisons::limitations_test
