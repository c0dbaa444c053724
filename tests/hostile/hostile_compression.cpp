#include "hostile_file.h"

namespace echolucent {

std::vector<HostileFile> hostileCompression() { return {}; }

}  // namespace echolucent
