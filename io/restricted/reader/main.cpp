// The program that reads strangers' files for the workstation and the command line, and can do nothing else.
#include <cstdlib>
#include <string_view>

#include "io/restricted/reader_service.h"

/// The workstation starts it; a person may run "echolucent-reader --try" to see what the kernel refuses it.
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
