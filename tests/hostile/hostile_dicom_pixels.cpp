#include "hostile_file.h"

namespace echolucent {

std::vector<HostileFile> hostileDicomPixels() { return {}; }

}  // namespace echolucent
