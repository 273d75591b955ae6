#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "contact/case.h"
#include "io/case/case_keys.h"
#include "io/keys/toml_document.h"
#include "io/keys/uncertain_number.h"
#include "statistics/correlations.h"

namespace tricontact::io {

struct Study;

/// A number of a file that states how uncertain it is.
struct UncertainKey {
    const Key* key = nullptr;
    UncertainNumber number;
    std::string place;  ///< file:line:column
};

/// Those of a document, of these keys, in the order of the text. Throws contact::InputError at a
/// number that is a setting of the computation, not a property of a rig, and where a number with
/// its standard error subtracted or added is out of its range.
std::vector<UncertainKey> uncertain_keys(const Document& document, const KeyList& keys);

/// substrate.young is the unrelaxed modulus.
bool states_unrelaxed(const Document& document);
/// Those of a case's file as the case holds them: an unrelaxed modulus as the relaxed one. Throws
/// contact::InputError also where its uncertainty does not go to that in proportion.
std::vector<UncertainKey> uncertain_numbers(const Document& document, const contact::Case& c);

/// Correlations of uncertain numbers, from [correlation] with a line
///     "substrate.young and friction.coefficient" = -0.5
/// for each pair. Throws contact::InputError where a key has no uncertainty, a coefficient is not
/// between -1 and 1, a pair stands twice, or no numbers can have all of them.
statistics::Correlations correlations(const Document& document,
                                      const std::vector<UncertainKey>& uncertain);

/// Checks names and combinations of all keys and, with their values, those that only a rig has:
/// the commands that use them read them. Throws contact::InputError.
void check_known_of_rig(const Document& document, const KeyList& all,
                        const std::vector<Key>& rig_keys);

/// A case file with overrides, its names and the keys of its rig checked: for commands that do
/// without some of the case. Throws contact::InputError, also where `section` is missing:
/// "<missing>; <remedy>".
Document read_rig_document(const std::string& path, const std::vector<std::string>& overrides);
Document read_rig_document(const std::string& path, const std::vector<std::string>& overrides,
                           std::string_view section, const std::string& missing,
                           const std::string& remedy);

/// A case file as a rig is described by it: commands that need no uncertainties read its case.
struct RigFile {
    Document document;                      ///< overrides included
    contact::Case c;                        ///< by the values
    std::vector<UncertainKey> uncertain;    ///< numbers of the case as it holds them, and others
    statistics::Correlations correlations;  ///< of these, by their keys

    /// Those of a case's keys.
    std::vector<UncertainKey> uncertain_of_case() const;
    /// What the file states of a key, as the case holds it; empty: nothing.
    std::optional<statistics::Estimate> number(std::string_view path) const;
};

/// What of a case file only commands about rigs read: its sections beside the case, "[rig]" and the
/// like, and uncertainty_mark where a number of the case states its uncertainty.
inline constexpr const char* uncertainty_mark = "±";
std::vector<std::string> rig_parts(const std::string& path,
                                   const std::vector<std::string>& overrides = {});
/// The same of the case of a study, with what the study sets and varies in it.
std::vector<std::string> rig_parts(const Study& study);

/// Throws contact::InputError as read_case() and uncertain_numbers().
RigFile read_rig_file(const std::string& path, const std::vector<std::string>& overrides = {});
RigFile parse_rig_file(std::string_view text, const std::string& name,
                       const std::vector<std::string>& overrides = {});

}  // namespace tricontact::io
