#include <memory>

#include "benchmarks/decks/closed_families.h"
#include "benchmarks/decks/deck_family.h"
#include "benchmarks/decks/deck_texts.h"
#include "contact/bodies/shapes_of_revolution.h"

namespace tricontact::benchmarks {

namespace {

DeckModel punch_model(const std::string& name) {
    DeckModel model;
    model.name = name;
    model.title = "Rigid flat punch with a sharp edge on a half-space";
    model.a = 5;
    model.young = 5.2;
    model.poisson = .3;
    model.indenter = flat_face();
    model.gap = "0";
    model.is_half_space = model.has_sharp_edge = true;
    model.width = model.thickness = half_space_block * model.a;
    model.contact_reach = model.indenter_reach = model.a;
    model.depth_scale = .35;
    // The pressure is infinite at the edge: K by the mean pressure, with a lesser effect.
    model.stiffness = 1000;
    model.steps.push_back({.normal = model.depth_scale, .increments = 1});
    model.remarks.push_back(
        "Closed form (Boussinesq 1885): F_N = 2 a E* d = 20 N, p = F_N/(2 pi a sqrt(a^2 - r^2)): "
        "0.12732 MPa on the axis, 0.29210 MPa at r = 0.9 a.");
    model.remarks.push_back(
        "The punch ends at r = a, a node of every mesh, and the pressure is infinite there: "
        "the largest value of a mesh means nothing. The force converges with the order 1 of the "
        "size "
        "of elements.");
    return model;
}

// The face of a punch of revolution, taken along x.
DeckModel pad_model(const std::string& name) {
    DeckModel model;
    model.shape = DeckModel::Shape::plane;
    model.name = name;
    model.title = "Rigid punch, flat 5 mm to either side, its edges rounded by R = 100 mm";
    model.a = 10;
    model.young = 5.2;
    model.poisson = .3;
    model.indenter = std::make_shared<contact::RoundedPunch>(5e-3, .1);
    model.gap = "0.5*(r-5+abs(r-5))*0.5*(r-5+abs(r-5))/(2*100)";
    model.is_half_space = true;
    model.width = model.thickness = half_space_block * model.a;
    model.contact_reach = 1.5 * model.a;
    model.indenter_reach = 2 * model.a;
    model.depth_scale = 1.5;  // of a block of this size
    model.stiffness = 75;     // .0015 mm at the largest pressure
    model.overlap = .03;
    model.steps.push_back({.is_force = true, .normal = 1.754814, .increments = 1});
    model.remarks.push_back(
        "Closed form (Ciavarella, Hills and Monno 1998): a = 10 mm, p = 0.070705 MPa in the middle "
        "and 0.079693 MPa at x = 9 mm; the largest, 0.11765 MPa, is at x = 6.37 mm.");
    return model;
}

}  // namespace

std::vector<DeckFile> complete_punch_deck(const DeckWishes& wishes) {
    return family_files(punch_model(wishes.problem), wishes);
}

std::vector<DeckFile> rounded_punch_plane_deck(const DeckWishes& wishes) {
    return family_files(pad_model(wishes.problem), wishes);
}

}  // namespace tricontact::benchmarks
