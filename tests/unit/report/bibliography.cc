#include "report/bibliography.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace tricontact::report::bibliography_test {
namespace {

std::vector<std::string> keys_in(const std::string& text) {
    std::vector<std::string> keys;
    for (const Source* source : cited_in(text)) keys.push_back(source->key);
    return keys;
}
using Keys = std::vector<std::string>;

TEST(Bibliography, AuthorsAndYearAreACitation) {
    EXPECT_EQ(keys_in("As Johnson (1985), 4.2, says"), Keys{"Johnson1985"});
    EXPECT_EQ(keys_in("(Roache 1998, ch. 5)"), Keys{"Roache1998"});
    EXPECT_EQ(keys_in("Klarbring, Ciavarella and Barber (2007); Wetter (2016), 3.2.13"),
              (Keys{"KlarbringCiavarellaBarber2007", "Wetter2016"}));
    EXPECT_EQ(keys_in("Cattaneo (1938), Mindlin (1949)"), (Keys{"Cattaneo1938", "Mindlin1949"}));
    EXPECT_EQ(keys_in("Saltelli et al. (2010)"), Keys{"Saltelli2010"});
    EXPECT_EQ(keys_in("Popov and Hess (2015)"), Keys{"PopovHess2015"});
    EXPECT_EQ(keys_in("Vingsbo and Söderberg (1988)"), Keys{"VingsboSoderberg1988"});
}

TEST(Bibliography, OtherWordsAreNone) {
    EXPECT_EQ(keys_in("Hertz, Johnson and 1985"), Keys{});
    EXPECT_EQ(keys_in("Johnson (1986)"), Keys{});
    // The last author of another publication.
    EXPECT_EQ(keys_in("Carslaw and Archard (1953)"), Keys{});
    EXPECT_EQ(keys_in("MacArchard (1953)"), Keys{});
}

// What BibTeX's styles ask of each kind of entry (btxdoc, section 3.1).
TEST(Bibliography, EntriesAreWhole) {
    std::set<std::string> keys;
    for (const Source& source : all_sources()) {
        EXPECT_TRUE(keys.insert(source.key).second) << source.key;
        std::vector<std::string> fields{"author", "title", "year"};
        const std::string& entry = source.entry;
        const std::string kind = entry.substr(1, entry.find('{') - 1);
        if (kind == "article") fields.emplace_back("journal");
        if (kind == "book" || kind == "incollection") fields.emplace_back("publisher");
        if (kind == "incollection") fields.emplace_back("booktitle");
        if (kind == "phdthesis") fields.emplace_back("school");
        EXPECT_GT(fields.size(), 3U) << entry;
        for (const std::string& field : fields)
            EXPECT_NE(entry.find("\n  " + field + " = {"), std::string::npos) << entry << field;
        EXPECT_EQ(std::ranges::count(entry, '{'), std::ranges::count(entry, '}')) << entry;
        EXPECT_TRUE(entry.ends_with("\n}")) << entry;
    }
    EXPECT_TRUE(
        std::ranges::is_sorted(keys_in(bibtex(cited_in("Wetter (2016)"), "1", "2001-02-03"))));
}

TEST(Bibliography, TheProgramIsASourceToo) {
    const std::string text = bibtex(cited_in("Archard (1953)"), "1.2.3", "2001-02-03");
    EXPECT_TRUE(text.starts_with("@misc{Tricontact,"));
    EXPECT_NE(text.find("note = {Version 1.2.3, 2001-02-03}"), std::string::npos) << text;
    EXPECT_NE(text.find("\n  year = {2001},"), std::string::npos) << text;
    EXPECT_NE(text.find("\n@article{Archard1953,"), std::string::npos);
}

TEST(Bibliography, WordsOfADocumentAreAllItSays) {
    const Document document{
        .lead = "lead",
        .comparison = DocumentTable{.id = "a",
                                    .note = "note",
                                    .columns = {{"heading"}},
                                    .rows = {{std::string("cell")}}},
        .verdicts = {{Verdict::Standing::holds, "verdict"}},
        .sections = {{"s",
                      "S",
                      {"paragraph"},
                      {{.id = "f", .caption = "caption", .curves = {{.name = "curve"}}}}}}};
    const std::string words = words_of(document);
    for (const char* word :
         {"lead", "note", "heading", "cell", "verdict", "paragraph", "caption", "curve"})
        EXPECT_NE(words.find(word), std::string::npos) << word;
}

}  // namespace
}  // namespace tricontact::report::bibliography_test
