#include "comparisons/quantities/model_traits.h"

#include <fmt/format.h>

#include <vector>

#include "comparisons/quantities/reference.h"
#include "contact/models/model_kind.h"

namespace tricontact::comparisons {

namespace {

// In the order in which sentences name them.
constexpr struct {
    Trait trait;
    const char* name;
} traits[] = {{springs, "springs on a line"},
              {half_space, "half-space"},
              {half_space_indenter, "indenter as half-space"},
              {uncoupled, "no coupling"},
              {small_strains, "small strains"}};

}  // namespace

unsigned traits_of(const contact::Case& c, const std::string& model) {
    const contact::ModelKind& kind = contact::model_kind(model);
    unsigned set = 0;
    if (kind.is_on_line()) set |= springs;
    if (c.layer.thickness && kind.is_half_space() && !is_tabulated(c, model)) set |= half_space;
    if (c.indenter.body && !kind.sees_indenter_body) set |= half_space_indenter;
    if (!couples(c, model)) set |= uncoupled;
    if (c.law != contact::Case::Law::linear && !kind.sees_finite_strains) set |= small_strains;
    return set;
}

std::string names_of(unsigned set) {
    std::vector<std::string> names;
    for (const auto& [trait, name] : traits)
        if (set & trait) names.emplace_back(name);
    return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace tricontact::comparisons
