#include "hostile_file.h"

namespace echolucent {

std::vector<HostileFile> hostileKretz() { return {}; }

}  // namespace echolucent
