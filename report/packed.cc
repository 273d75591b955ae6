#include "report/packed.h"

#include <zlib.h>

#include <stdexcept>

#include "report/base64.h"

namespace tricontact::report {

std::string packed(std::string_view bytes) {
    uLongf size = compressBound(bytes.size());
    std::string stream(size, '\0');
    const int code = compress2(reinterpret_cast<Bytef*>(stream.data()), &size,
                               reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(),
                               Z_DEFAULT_COMPRESSION);
    if (code != Z_OK) throw std::runtime_error("zlib: error " + std::to_string(code));
    return base64({stream.data(), size});
}

}  // namespace tricontact::report
