#include "hostile_file.h"

namespace echolucent {

std::vector<HostileFile> hostileNifti() { return {}; }

}  // namespace echolucent
