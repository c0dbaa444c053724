// The Qt Test classes of one program, by name. `PROGRAM` runs them all, each in its own process. `PROGRAM CLASS
// [FUNCTION[:ROW]...] [QTEST OPTIONS]` runs one class, or those functions of it, in the present process.
#pragma once

#include <QCoreApplication>
#include <QObject>
#include <QStringList>
#include <QTest>
#include <functional>
#include <map>
#include <memory>
#include <string>

namespace echolucent {

/// ms that a test waits for things that come at once in a working program.
inline constexpr int patience = 30000;

/// Whether this process runs the long tests (`--long`). Some functions take more inputs then.
[[nodiscard]] bool isLongRun();

[[nodiscard]] const std::string& runningClass();

/// A test class as main() finds it. ECHOLUCENT_TEST_CLASS behind its definition registers it.
struct TestClass {
    std::function<std::unique_ptr<QObject>()> make;
    QStringList longFunctions;  ///< the functions that ask isLongRun(); the long run runs them again
};
/// The classes of this program, by name.
[[nodiscard]] std::map<std::string, TestClass>& testClasses();

/// What a test starts as another process of this program. The first word of the command line names it.
struct DrivenProgram {
    std::function<void()> beforeApplication;                    ///< runs before there is an application
    std::function<int(const QStringList& arguments)> whatRuns;  ///< runs in the application; returns the exit status
};
/// The driven programs of this program, by their word.
[[nodiscard]] std::map<std::string, DrivenProgram>& drivenPrograms();

/// The application that the classes need. Each program links one definition of it.
[[nodiscard]] std::unique_ptr<QCoreApplication> makeTestApplication(int& count, char** arguments);

/// If the running test has failed, saves the screen as failed/CLASS.FUNCTION.ROW.png beside the programs' folder.
/// Fixtures call it before their windows close. Only programs with a screen have it.
void keepPictureOfFailure();

}  // namespace echolucent

/// Qt waits 5 s: too short under a sanitizer, or on a machine that is busy elsewhere.
#undef QTRY_VERIFY
#define QTRY_VERIFY(statement) QTRY_VERIFY_WITH_TIMEOUT(statement, echolucent::patience)
#undef QTRY_VERIFY2
#define QTRY_VERIFY2(statement, description) QTRY_VERIFY2_WITH_TIMEOUT(statement, description, echolucent::patience)
#undef QTRY_COMPARE
#define QTRY_COMPARE(computed, expected) QTRY_COMPARE_WITH_TIMEOUT(computed, expected, echolucent::patience)

/// After the class come the names of its long functions.
#define ECHOLUCENT_TEST_CLASS(Class, ...)                                                                        \
    [[maybe_unused]] static const bool registered##Class =                                                       \
        echolucent::testClasses()                                                                                \
            .try_emplace(#Class, echolucent::TestClass{[] { return std::make_unique<Class>(); }, {__VA_ARGS__}}) \
            .second;
