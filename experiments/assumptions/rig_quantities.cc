#include "experiments/assumptions/rig_quantities.h"

#include <algorithm>
#include <ranges>
#include <string>

namespace tricontact::experiments {

namespace {

std::vector<std::string> words_of(std::string_view symbols) {
    std::vector<std::string> words;
    for (const auto word : std::views::split(symbols, ' '))
        words.emplace_back(word.begin(), word.end());
    return words;
}

const RigSymbol* stated(const Rig& rig, std::string_view symbol) {
    const auto& symbols = rig_symbols(rig.kind);
    const auto one = std::ranges::find(symbols, symbol, &RigSymbol::symbol);
    return one == symbols.end() ? nullptr : &*one;
}

const DerivedQuantity* derived(const Rig& rig, std::string_view symbol) {
    const auto& quantities =
        rig.kind == Rig::Kind::micro_walking ? walking_quantities() : rolling_quantities();
    const auto one = std::ranges::find(quantities, symbol, &DerivedQuantity::symbol);
    return one == quantities.end() ? nullptr : &*one;
}

std::optional<Given> quantity_of(const Rig& rig, const std::string& symbol) {
    const std::string shown = symbol.substr(0, symbol.find('\''));
    if (rig.has(symbol))
        return Given{shown, rig[symbol], std::string(io::si_unit(stated(rig, symbol)->dimension)),
                     std::string(symbol), rig.correlations};
    const DerivedQuantity* quantity = derived(rig, symbol);
    if (!quantity) return {};
    if (const auto value = quantity->of(rig))
        return Given{shown, *value, std::string(quantity->unit)};
    return {};
}

// The keys without which a quantity is not known.
void add_missing(Assumption& assumption, const Rig& rig, const std::string& symbol) {
    if (quantity_of(rig, symbol)) return;
    const DerivedQuantity* quantity = derived(rig, symbol);
    if (quantity)
        for (const std::string& other : words_of(quantity->given))
            add_missing(assumption, rig, other);
    else if (const std::string path(stated(rig, symbol)->path);
             std::ranges::count(assumption.missing, path) == 0)
        assumption.missing.push_back(path);
}

bool is_known(const Rig& rig, const Formula& formula) {
    return std::ranges::all_of(words_of(formula.given), [&](const std::string& symbol) {
        return quantity_of(rig, symbol).has_value();
    });
}

}  // namespace

std::vector<Given> given(const Rig& rig, std::string_view symbols) {
    std::vector<Given> result;
    for (const std::string& symbol : words_of(symbols))
        result.push_back(quantity_of(rig, symbol).value());
    return result;
}

Calculation calculate(const Rig& rig, const Formula& f) {
    return calculate(f.name, f.symbol, f.formula, f.source, f.unit, given(rig, f.given),
                     f.function);
}

std::optional<Estimate> result_if_known(const Rig& rig, const Formula& formula) {
    if (!is_known(rig, formula)) return {};
    return calculate(rig, formula).result;
}

std::vector<Calculation> known(const Rig& rig, const std::vector<const Formula*>& formulas) {
    std::vector<Calculation> result;
    for (const Formula* formula : formulas)
        if (is_known(rig, *formula)) result.push_back(calculate(rig, *formula));
    return result;
}

bool has_all(Assumption& assumption, const Rig& rig, std::string_view symbols) {
    bool all = true;
    for (const std::string& symbol : words_of(symbols)) {
        all = all && quantity_of(rig, symbol).has_value();
        add_missing(assumption, rig, symbol);
    }
    return all;
}

bool decide(Assumption& assumption, const Rig& rig, const Formula& formula,
            Criterion::Relation relation, double threshold, std::string reason) {
    if (!has_all(assumption, rig, formula.given)) return false;
    assumption.criteria.push_back(
        {calculate(rig, formula), relation, threshold, std::move(reason)});
    return true;
}

}  // namespace tricontact::experiments
