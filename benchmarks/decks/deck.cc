#include "benchmarks/decks/deck.h"

#include "benchmarks/decks/deck_family.h"
#include "benchmarks/decks/deck_texts.h"
#include "contact/base/error.h"

namespace tricontact::benchmarks {

std::vector<DeckFile> write_deck(const Reference& reference, const DeckWishes& wishes) {
    const DeckModel model = make_deck_model(reference, wishes);
    DeckFamily family;
    if (wishes.code == "calculix" || wishes.code == "abaqus")
        family = inp_family(model, wishes, wishes.code == "abaqus");
    else if (wishes.code == "freefem")
        family = freefem_family(model, wishes);
    else if (wishes.code == "getfem")
        family = getfem_family(model, wishes);
    else
        throw contact::InputError("deck: no deck for " + wishes.code +
                                  "; choose of calculix, abaqus, freefem, getfem, mesh");
    std::vector<DeckFile> files;
    for (const DeckRun& run : family.runs)
        files.insert(files.end(), run.files.begin(), run.files.end());
    files.push_back({"submission.toml", submission_text(model, family)});
    files.push_back({"README.txt", readme_text(model, family)});
    return files;
}

}  // namespace tricontact::benchmarks
