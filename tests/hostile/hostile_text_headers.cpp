#include "hostile_file.h"

namespace echolucent {

std::vector<HostileFile> hostileTextHeaders() { return {}; }

}  // namespace echolucent
