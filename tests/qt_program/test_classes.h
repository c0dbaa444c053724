// The Qt Test classes of one program, by name. `PROGRAM` runs them all, each in a process of its own; `PROGRAM CLASS
// [FUNCTION[:ROW]...] [QTEST OPTIONS]` runs one in its own process, or those functions of it.
#pragma once

#include <QCoreApplication>
#include <QObject>
#include <QStringList>
#include <functional>
#include <map>
#include <memory>
#include <string>

namespace echolucent {

/// ms that a test waits for what comes at once in a program that works.
inline constexpr int patience = 30000;

/// Whether this process runs the long tests (`--long`), in which some functions take more inputs.
[[nodiscard]] bool isLongRun();

/// The name of the class that runs in this process.
[[nodiscard]] const std::string& runningClass();

/// A test class as main() finds it. Every class registers itself, by ECHOLUCENT_TEST_CLASS behind its definition.
struct TestClass {
    std::function<std::unique_ptr<QObject>()> make;
    QStringList longFunctions;  ///< the functions that ask isLongRun(): the long run runs these again
};
/// The classes of this program, by name.
[[nodiscard]] std::map<std::string, TestClass>& testClasses();

/// What a test starts as another process of this same program, by the first word of its command line.
struct DrivenProgram {
    std::function<void()> beforeApplication;                    ///< runs before there is an application
    std::function<int(const QStringList& arguments)> whatRuns;  ///< runs in the application; gives the status
};
/// The driven programs of this program, by their word.
[[nodiscard]] std::map<std::string, DrivenProgram>& drivenPrograms();

/// The application that the classes of this program need. Each program links one definition of it.
[[nodiscard]] std::unique_ptr<QCoreApplication> makeTestApplication(int& count, char** arguments);

/// Saves the screen as failed/CLASS.FUNCTION.ROW.png beside the programs' folder, if the test that runs has failed.
/// Fixtures call it before their windows close. Only programs with a screen have it.
void keepPictureOfFailure();

}  // namespace echolucent

/// The names behind the class are those of its long functions.
#define ECHOLUCENT_TEST_CLASS(Class, ...)                                                                        \
    [[maybe_unused]] static const bool registered##Class =                                                       \
        echolucent::testClasses()                                                                                \
            .try_emplace(#Class, echolucent::TestClass{[] { return std::make_unique<Class>(); }, {__VA_ARGS__}}) \
            .second;
