#include "hostile_file.h"

namespace echolucent {

std::vector<HostileFile> hostileDicomSeries() { return {}; }

}  // namespace echolucent
