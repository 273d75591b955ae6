#pragma once

#include <map>
#include <string>

namespace tricontact::io {

/// Files by their names, relative with '/' between folders.
using ZipFiles = std::map<std::string, std::string>;

/// A zip archive of the files, in the order of their names, without dates and owners: same files,
/// same bytes. Throws contact::InputError if they are more than read_zip() takes.
std::string zip_of(const ZipFiles& files);

/// The files of an archive, into memory alone. Throws contact::InputError, naming the archive,
/// where it is no zip archive or a part of one; where a name leads out of it, stands twice or is
/// that of a link; where a file is encrypted, or damaged by its checksum; and where it holds more
/// than 10000 files or 500 MB, whatever sizes it states.
ZipFiles read_zip(const std::string& path);

}  // namespace tricontact::io
