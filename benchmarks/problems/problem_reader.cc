#include <algorithm>
#include <deque>

#include "benchmarks/problems/problem.h"
#include "benchmarks/reference/quantity_units.h"
#include "io/keys/key_checks.h"

namespace tricontact::benchmarks {

namespace {

using io::Document;
using io::Key;

constexpr const char* section_of_targets = "target";

const std::vector<io::PlacedKey<Problem>>& problem_keys() {
    using io::at;
    static const std::vector<io::PlacedKey<Problem>> keys{
        {io::text_key("title", R"("Sphere on a half-space")", "what the problem is"),
         at<&Problem::title>},
        {io::choice_key(
             "group", {{"half-space"}, {"layer"}, {"bodies"}, {"friction"}, {"rolling"}, {"patch"}},
             R"("layer")", "what it is about"),
         at<&Problem::group>},
        {io::text_key("tests", R"("penalty, kinematics")", "what it tests"), at<&Problem::tests>},
        {io::text_key("text", R"("A rigid sphere ...")", "the problem, and why it is one"),
         at<&Problem::text>},
        {io::text_key("case", R"("title = ...")", "the case file"), at<&Problem::case_text>},
        {io::list_of(
             io::choice_key("traps", {}, R"(["a penalty lowers the force"])", "what can go wrong")),
         at<&Problem::traps>},
        {io::list_of(io::choice_key("sources", {}, R"(["Hertz, 1882"])", "publications")),
         at<&Problem::sources>},
        {io::text_key("twin", R"("layer_pressed")", "the control experiment"), at<&Problem::twin>}};
    return keys;
}

/// Without a default: a problem may have none.
const Key& decks_key() {
    static const Key key =
        io::list_of(io::choice_key("decks", {{"axisymmetric"}, {"plane"}, {"half"}},
                                   R"(["axisymmetric"])", "kinds of decks that are written"));
    return key;
}

Key unit_key() {
    std::vector<io::Choice> words;
    for (const QuantityUnit& unit : quantity_units())
        if (!unit.word.empty()) words.push_back({unit.word});
    return io::choice_key("unit", words, R"("MPa")", "of value and bar; without it a ratio");
}

/// The keys of a target, by their names in its section.
const std::vector<io::PlacedKey<Target>>& target_keys() {
    using io::at;
    static const std::vector<io::PlacedKey<Target>> keys{
        {io::text_key("quantity", R"("peak_pressure")",
                      "key of the quantity; without it the name of the section"),
         at<&Target::key>},
        {io::text_key("title", R"("largest stress over p0")", "where it is no such quantity"),
         at<&Target::title>},
        {io::number_key("value", {}, "2798.3", "the number"), at<&Target::value>},
        {unit_key(), at<&Target::unit>},
        {io::number_key("bar", io::from_zero(1e15), "0.05", "half width"), at<&Target::bar>},
        {io::text_key("source", R"("Hertz, 1882")", "where it is from"), at<&Target::source>},
        {io::boolean_key("solution", "false", "whether it is of this problem"),
         at<&Target::is_solution>},
        {io::text_key("remark", R"("of a finite block")", "why not"), at<&Target::remark>}};
    return keys;
}

/// A choice is kept by its word.
void read_into(const Key& key, const io::Entry& entry, const io::Field& field) {
    auto* const* word = std::get_if<std::string*>(&field);
    if (key.kind == Key::Kind::choice && word)
        **word = io::read_choice(key, entry).word;
    else
        io::read_field(key, entry, field);
}

/// Keys with the section of a target before their names.
struct SectionKeys {
    std::deque<std::string> paths;
    std::deque<Key> keys;

    void add(const std::string& section) {
        for (Key key : target_keys()) {
            key.path = paths.emplace_back(section + '.' + std::string(key.path));
            keys.push_back(std::move(key));
        }
    }
};

bool is_target(std::string_view path) {
    return path.starts_with("target.");
}

void check_target(const Target& target, const Document& document, const std::string& section) {
    const auto refuse = [&](const std::string& rule, const std::string& remedy) {
        io::fail(document.find_section(section)->place, '[' + section + ']', rule, remedy);
    };
    if (target.title.empty())
        refuse("has no title, and " + target.key + " is no key of a quantity",
               "add title = \"...\"");
    if (target.source.empty()) refuse("names no source", "add source = \"...\"");
    if (target.is_solution == !target.remark.empty())
        refuse("a number of another problem, and only that, has a remark",
               "give solution = false and a remark, or neither");
    if (title_of_quantity(target.key).empty()) return;
    const QuantityUnit* unit = find_unit(target.unit);
    if (!unit || !measures(*unit, target.key))
        refuse("unit does not fit " + target.key,
               "write for example unit = \"" +
                   std::string(usual_unit(target.key, Geometry::spatial).word) + '"');
}

Target read_target(const Document& document, const std::string& section) {
    Target target;
    target.key = section.substr(section.find('.') + 1);
    for (const auto& key : target_keys()) {
        const std::string path = section + '.' + std::string(key.path);
        Key placed = key;
        placed.path = path;
        if (const io::Entry* entry = document.find(path))
            read_into(placed, *entry, key.field(target));
        else if (key.path == "value")
            io::fail(document.find_section(section)->place, "", "missing key " + path,
                     "add value = 2798.3");
    }
    if (target.title.empty()) target.title = title_of_quantity(target.key);
    if (const QuantityUnit* unit = find_unit(target.unit)) target.unit_size = unit->size;
    check_target(target, document, section);
    target.value *= target.unit_size;
    target.bar *= target.unit_size;
    return target;
}

}  // namespace

Problem parse_problem(std::string_view text, const std::string& name) {
    const Document document = io::parse_document(text, name + ".toml", is_target);
    SectionKeys sections;
    for (const Document::Section& section : document.sections)
        if (section.name != section_of_targets) sections.add(section.name);
    std::vector<const Key*> known{&decks_key()};
    for (const Key& key : problem_keys()) known.push_back(&key);
    for (const Key& key : sections.keys) known.push_back(&key);
    const io::KeyList keys(known, "benchmarks/problems/problem.h");
    for (const Document::Section& section : document.sections)
        if (section.name != section_of_targets && !is_target(section.name))
            io::fail(section.place, "", "unknown section [" + section.name + ']',
                     "sections are [target.NAME]");
    io::check_known(document, keys, {.sections = {section_of_targets}});
    Problem problem;
    problem.name = name;
    for (const auto& key : problem_keys()) {
        const io::Entry* entry = document.find(key.path);
        if (entry)
            read_into(key, *entry, key.field(problem));
        else if (key.path != "case" && key.path != "twin")  // may be left out
            io::refuse_missing(key, document, keys);
    }
    if (const io::Entry* entry = document.find(decks_key().path))
        io::read_field(decks_key(), *entry, &problem.decks);
    for (const Document::Section& section : document.sections)
        if (is_target(section.name)) problem.targets.push_back(read_target(document, section.name));
    return problem;
}

}  // namespace tricontact::benchmarks
