#pragma once

#include <string>
#include <vector>

#include "papers/archive.h"

namespace CLI {
class App;
}  // namespace CLI

namespace tricontact::papers {

/// What becomes of an option of a command that exports: it goes into the archive, or belongs to
/// that call alone (where it writes, with how many threads, what it says).
enum class ArchivedOption { kept, own_matter, unknown };
ArchivedOption archived_option(const std::string& name);

/// The arguments of a call that go into the archive. Throws std::logic_error for an option that no
/// list names: whoever adds one decides.
std::vector<std::string> archived_arguments(const CLI::App& parser);

/// Arguments of an archive of an earlier version, whose options had other names, as this one has
/// them.
std::vector<std::string> arguments_now(std::vector<std::string> arguments);

/// Throws contact::InputError naming `archive` unless the arguments are such as
/// archived_arguments() gives, and their values lead to files of the archive, or to none.
void check_archived_arguments(const CLI::App& parser, const std::string& archive,
                              const io::ZipFiles& files, const std::vector<std::string>& arguments);

}  // namespace tricontact::papers
