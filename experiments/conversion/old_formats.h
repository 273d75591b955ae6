#pragma once

#include <string>
#include <string_view>

namespace tricontact::experiments {

/// How a file begins that converted() writes.
inline constexpr std::string_view converted_beginning = "# Converted from ";

/// A rig file, an experiment file or a measurement as they were before one case file described a
/// rig, as such a case file: comments are lost, errors stand behind the values. `name` of the file,
/// `output` of the new one: the files that it names are named from there. Throws
/// contact::InputError where it is of another kind; where what a case needs is not in the file, the
/// text says so in a comment.
std::string converted(std::string_view text, const std::string& name, const std::string& output);

}  // namespace tricontact::experiments
