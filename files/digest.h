#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

struct XXH3_state_s;

namespace tricontact::files {

/// 128 bits of all bytes that were added (XXH3): against accidents, not against forgers.
class Digest {
  public:
    Digest();

    Digest& add(const void* bytes, std::size_t n);
    /// A text with its length before it: two of them one after the other are not the same as one.
    Digest& operator<<(std::string_view text);
    /// As 32 hexadecimal digits.
    std::string text() const;

  private:
    std::unique_ptr<XXH3_state_s, void (*)(XXH3_state_s*)> state_;
};

/// Of these bytes and nothing else.
std::string digest_of(std::string_view bytes);

}  // namespace tricontact::files
