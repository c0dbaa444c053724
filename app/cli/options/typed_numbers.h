// Numbers on the command line, as the window understands them.
#pragma once

namespace CLI {
class App;
}

namespace echolucent::cli {

/// Lets all options of one number, of the program and of its commands, understand a comma as typedNumber() does. A
/// number with two meanings is refused. Call it once all options are there.
void understandCommas(CLI::App& program);

}  // namespace echolucent::cli
