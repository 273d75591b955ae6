# A digest of sources as a unit of C++: what they hold and their paths within the project, so that it
# is the same on every machine and in every clone. Written only when it changes.
# cmake -DROOT=DIR -DLIST=FILE -DUNIT=FILE -DHEADER=FILE -DFUNCTION=NAME -P sources_digest.cmake
file(STRINGS ${LIST} sources)
set(digests "")
foreach(source IN LISTS sources)
    file(SHA256 ${ROOT}/${source} digest)
    string(APPEND digests "${source} ${digest}\n")
endforeach()
string(SHA256 digest "${digests}")
file(CONFIGURE OUTPUT ${UNIT} CONTENT [[
#include "@HEADER@"

std::string_view tricontact::@FUNCTION@() {
    return "@digest@";
}
]] @ONLY)
