#include <memory>
#include <numbers>

#include "benchmarks/decks/closed_families.h"
#include "benchmarks/decks/deck_family.h"
#include "benchmarks/decks/deck_texts.h"

namespace tricontact::benchmarks {

namespace {

class FlatFace final : public contact::Indenter {
  public:
    double height(double, double) const override { return 0; }
    contact::Vector2 slope(double, double) const override { return {0, 0}; }
};

DeckModel punch_model(const std::string& name) {
    DeckModel model;
    model.name = name;
    model.title = "Rigid flat punch with a sharp edge on a half-space";
    model.a = 5;
    model.young = 5.2;
    model.poisson = .3;
    model.indenter = std::make_shared<FlatFace>();
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

}  // namespace

std::vector<DeckFile> complete_punch_deck(const DeckWishes& wishes) {
    const DeckModel model = punch_model(wishes.problem);
    const DeckFamily family = make_family(model, wishes);
    std::vector<DeckFile> files;
    for (const DeckRun& run : family.runs)
        files.insert(files.end(), run.files.begin(), run.files.end());
    files.push_back({"README.txt", readme_text(model, family, false)});
    return files;
}

}  // namespace tricontact::benchmarks
