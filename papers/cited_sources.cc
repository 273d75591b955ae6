#include "papers/cited_sources.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>
#include <utility>

#include "comparisons/quantities/quantity.h"
#include "comparisons/reproduction/kept_numbers.h"
#include "contact/models/model_kind.h"

namespace tricontact::papers {

namespace {

/// Sources of what is neither a quantity nor a model: of numbers by their keys, of reports by their
/// kinds, of theories by the names of their curves.
constexpr std::array<std::pair<const char*, const char*>, 19> further_sources{{
    {"numerical_error", "Roache (1998)"},
    {"refinement", "Roache (1998)"},
    {"posterior", "Goodman and Weare (2010), Foreman-Mackey et al. (2013)"},
    {"mu_e_error", "White (1997), Geyer (1992), Geweke (1992), Bartlett (1948)"},
    {"lyapunov", "Benettin, Galgani, Giorgilli and Strelcyn (1980)"},
    {"half-space", "Hertz (1882), Johnson (1985)"},
    {"layer", "Sneddon (1951), Lebedev and Ufliand (1958)"},
    {"Half-space deviation",
     "Hertz (1882), Johnson (1985), Sneddon (1951), Lebedev and Ufliand "
     "(1958), Mindlin (1949), Dimitriadis et al. (2002)"},
    {"Finite strains", "Ogden (1984)"},
    {"Wear",
     "Archard (1953), Fouvry, Kapsa and Vincent (1996), Popov (2014), Dimaki, Dmitriev, Chai and "
     "Popov (2014)"},
    {"relaxation", "Lee and Radok (1960), Tschoegl (1989)"},
    {"Carter", "Carter (1926)"},
    {"Vermeulen and Johnson", "Vermeulen and Johnson (1964)"},
    {"Kalker, linear", "Kalker (1967)"},
    {"cubic law with Kalker's C_11", "Kalker (1967), Shen, Hedrick and Elkins (1983)"},
    {"Bentall and Johnson, all sticks", "Bentall and Johnson (1967)"},
    {"Bentall and Johnson, all slips", "Bentall and Johnson (1967)"},
    {"Hunter", "Hunter (1961)"},
    {"Persson", "Persson (2001), Bush, Gibson and Thomas (1975)"},
}};

/// Words by which sources are found: of the reports, of the quantities among the numbers, of the
/// models that these are of.
std::string citing_words(const std::vector<report::Document>& documents,
                         const std::map<std::string, std::string>& numbers) {
    std::string words;
    std::set<std::string> names;  // of keys, models, reports, curves
    for (const report::Document& document : documents) {
        words += words_of(document);
        names.insert(document.kind);
        for (const report::Figure& figure : figures_of(document))
            for (const report::Curve& curve : figure.curves) names.insert(curve.name);
    }
    const auto add = [&](const std::string& path) {
        for (std::size_t begin = 0; begin <= path.size();) {
            const auto end = std::min(path.find('/', begin), path.size());
            names.insert(path.substr(begin, end - begin));
            begin = end + 1;
        }
    };
    for (const auto& [name, text] : numbers) {
        names.insert(std::filesystem::path(name).stem().string());
        if (name.ends_with("/history.csv")) continue;  // zeros of what the model does not know
        for (const comparisons::KeptNumber& number : comparisons::numbers_in(name, text)) {
            const bool is_input = number.quantity.starts_with("case/");
            if (is_input || number.text.empty() || number.text == "null") continue;
            if (number.quantity == "heading") continue;
            add(number.quantity);
            std::string plain = number.text;
            std::erase(plain, '"');
            names.insert(plain);
        }
    }
    for (const comparisons::Quantity* q : comparisons::all_quantities())
        if (names.contains(q->key)) words += std::string(q->source) + '\n';
    for (const contact::ModelKind& model : contact::model_kinds())
        if (names.contains(model.name)) words += std::string(model.sources) + '\n';
    for (const auto& [name, cited] : further_sources)
        if (names.contains(name)) words += std::string(cited) + '\n';
    return words;
}

}  // namespace

report::Sources cited_sources(const std::vector<report::Document>& documents,
                              const std::map<std::string, std::string>& numbers) {
    return report::cited_in(citing_words(documents, numbers));
}

}  // namespace tricontact::papers
