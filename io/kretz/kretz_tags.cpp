#include "io/kretz/kretz_tags.h"

#include <fmt/format.h>

namespace echolucent {

std::string tagText(KretzTag tag) { return fmt::format("{:04X}:{:04X}", tag.group, tag.element); }

}  // namespace echolucent
