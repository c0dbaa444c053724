#include "hostile_file.h"

namespace echolucent {

std::vector<HostileFile> hostileDicomStructure() { return {}; }

}  // namespace echolucent
