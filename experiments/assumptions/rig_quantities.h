#pragma once

#include <array>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <vector>

#include "contact/base/number_text.h"
#include "experiments/assumptions/assumption.h"
#include "experiments/assumptions/rig.h"

// The quantities of a rig, and its formulas with these put in.
namespace tricontact::experiments {

using contact::quantity;
using contact::significant;
using contact::with_error;

/// What goes into a formula, in the order in which it is shown. L is that of a cylinder: rigs of
/// other shapes go without it.
class Inputs {
  public:
    using Member = RigNumber RigData::*;

    constexpr Inputs(std::initializer_list<Member> members) {
        for (const Member one : members) members_[n_++] = one;
    }
    constexpr const Member* begin() const { return members_.data(); }
    constexpr const Member* end() const { return members_.data() + n_; }
    friend constexpr Inputs operator+(Inputs left, const Inputs& right) {
        for (const Member one : right) left.members_[left.n_++] = one;
        return left;
    }

  private:
    std::array<Member, 12> members_{};
    std::size_t n_ = 0;
};

/// A formula of a rig. Its function is given what `given` lists, and nothing else: all other
/// numbers are not known to it.
struct Formula {
    const char *name, *symbol, *formula, *source, *unit;  ///< as Calculation's
    Inputs given;
    double (*function)(const RigData&);

    constexpr Formula(const char* its_name, const char* its_symbol, const char* text,
                      const char* its_source, const char* its_unit, Inputs inputs,
                      double (*of_data)(const RigData&))
        : name(its_name),
          symbol(its_symbol),
          formula(text),
          source(its_source),
          unit(its_unit),
          given(inputs),
          function(of_data) {}
};

/// A number of a rig in its formulas.
struct RigQuantity {
    std::string_view symbol;  ///< as it is shown
    Inputs::Member number;
    io::Dimension dimension = io::Dimension::none;
    std::string_view path = {};             ///< of its key: "indenter.radius"; empty: it has none
    const Formula* formula = nullptr;       ///< that it follows from where it is not stated, or ...
    RigNumber (*of)(const Rig&) = nullptr;  ///< ... what it is then
};
const std::vector<RigQuantity>& rig_quantities(Rig::Kind kind);

/// A number as the rig states it, or as it follows; may be not known.
RigNumber number_of(const Rig& rig, Inputs::Member member);

/// A formula with the numbers of a rig put in. Throws std::domain_error if one is not known.
Calculation calculate(const Rig& rig, const Formula& formula);
/// The same, of a function that knows more; `constants`: what is shown of that.
Calculation calculate(const Rig& rig, std::string name, std::string symbol, std::string formula,
                      std::string source, std::string unit, const Inputs& given,
                      std::function<double(const RigData&)> function,
                      std::vector<Given> constants = {});
/// Of |with/without - 1|, both in this unit.
Calculation relative_difference(std::string name, std::string symbol, std::string formula,
                                std::string source, Given with, Given without);

/// Of those formulas whose quantities are all known.
std::vector<Calculation> known(const Rig& rig, const std::vector<const Formula*>& formulas);
/// Whether the rig has all of these; keys without which it has not are missing.
bool has_all(Assumption& assumption, const Rig& rig, const Inputs& inputs);
/// Adds a criterion, and is true; if the rig lacks a datum of it, those keys are missing.
bool decide(Assumption& assumption, const Rig& rig, const Formula& formula,
            Criterion::Relation relation, double threshold, std::string reason);

}  // namespace tricontact::experiments
