// The program that reads strangers' files for the workstation and the command line. It can do nothing else.
#include <string_view>

#include "io/restricted/reader_service.h"

/// The workstation starts it. A person may run "echolucent-reader --try" to see what the kernel refuses.
int main(int count, char** arguments) {
    using namespace echolucent::restricted;
    ReaderStart start;
    for (int index = 1; index < count; ++index) {
        const std::string_view argument = arguments[index];
        if (argument == "--try") return tryWhatIsForbidden();
        if (argument == "--load-ahead") start.loadsAhead = true;
    }
    return serveReader(start);
}
