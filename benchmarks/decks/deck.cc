#include "benchmarks/decks/deck.h"

#include <fmt/format.h>

#include "benchmarks/decks/deck_family.h"
#include "benchmarks/decks/deck_texts.h"
#include "benchmarks/decks/mesh_texts.h"
#include "contact/base/error.h"

namespace tricontact::benchmarks {

std::string add_run(DeckFamily& family, const DeckModel& model) {
    DeckRun& run = family.runs.emplace_back();
    run.n = coarsest_elements(model) << (family.runs.size() - 1);
    run.size = model.a / run.n;
    return fmt::format("{}_n{}", model.name, run.n);
}

DeckFamily make_family(const DeckModel& model, const DeckWishes& wishes) {
    if (wishes.code == "calculix") return inp_family(model, wishes, false);
    if (wishes.code == "abaqus") return inp_family(model, wishes, true);
    if (wishes.code == "freefem") return freefem_family(model, wishes);
    if (wishes.code == "getfem") return getfem_family(model, wishes);
    if (wishes.code == "mesh") return mesh_family(model, wishes);
    throw contact::InputError("deck: no deck for \"" + wishes.code +
                              "\"; choose of calculix, abaqus, freefem, getfem, mesh");
}

std::vector<DeckFile> write_deck(const Reference& reference, const DeckWishes& wishes) {
    const DeckModel model = make_deck_model(reference, wishes);
    const DeckFamily family = make_family(model, wishes);
    std::vector<DeckFile> files;
    for (const DeckRun& run : family.runs)
        files.insert(files.end(), run.files.begin(), run.files.end());
    files.push_back({"submission.toml", submission_text(model, family)});
    files.push_back({"README.txt", readme_text(model, family, true)});
    return files;
}

}  // namespace tricontact::benchmarks
