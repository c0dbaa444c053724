#include <QStringList>
#include <QTest>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

#include "tests/qt_program/test_classes.h"

namespace echolucent {

std::map<std::string, TestClass>& testClasses() {
    static std::map<std::string, TestClass> classes;
    return classes;
}

std::map<std::string, DrivenProgram>& drivenPrograms() {
    static std::map<std::string, DrivenProgram> programs;
    return programs;
}

namespace {

std::string nameOfRunningClass;

constexpr const char* longRun = "ECHOLUCENT_LONG_RUN";

/// Which of the classes a run without a class takes.
struct Choice {
    bool isLong = false;
    int part = 0, parts = 1;  ///< every parts-th class, from this one on
};

/// --long takes the long functions with all their inputs; --part 2/3 takes the second third.
bool isChoice(const QStringList& words, Choice& choice) {
    for (int i = 0; i < words.size(); ++i) {
        const QStringList part = i + 1 < words.size() ? words[i + 1].split('/') : QStringList();
        if (words[i] == "--long") {
            choice.isLong = true;
        } else if (words[i] == "--part" && part.size() == 2) {
            choice.part = part[0].toInt() - 1;
            choice.parts = part[1].toInt();
            ++i;
        } else {
            return false;
        }
    }
    return choice.parts > 0 && choice.part >= 0 && choice.part < choice.parts;
}

int runOne(const std::string& name, int count, char** arguments) {
    const std::unique_ptr<QCoreApplication> application = makeTestApplication(count, arguments);
    application->setAttribute(Qt::AA_Use96Dpi);
    const std::unique_ptr<QObject> test = testClasses().at(name).make();
    QStringList words(arguments, arguments + count);
    words.removeAt(1);
    nameOfRunningClass = name;
    return QTest::qExec(test.get(), words);
}

/// Runs a class, or these functions of it, in a process of its own; 0 if it ends well. That process begins as a copy of
/// this one: all libraries are loaded, which takes a program that is started a quarter of a second.
int runApart(const char* program, const QStringList& words) {
    std::fflush(stdout);
    const pid_t process = fork();
    if (process == 0) {
        std::vector<QByteArray> texts{program};
        for (const QString& word : words) texts.push_back(word.toLocal8Bit());
        std::vector<char*> arguments;
        for (QByteArray& text : texts) arguments.push_back(text.data());
        arguments.push_back(nullptr);
        std::exit(runOne(words.first().toStdString(), static_cast<int>(arguments.size()) - 1, arguments.data()));
    }
    int status = 0;
    while (waitpid(process, &status, 0) < 0)
        if (errno != EINTR) return 1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

/// Each class gets a process of its own: theme, style, environment and settings of one never reach another, and the
/// classes behind one that crashes still run.
int runEach(const char* program, const Choice& choice) {
    QStringList failed;
    int place = 0, run = 0;
    if (choice.isLong) qputenv(longRun, "1");
    for (const auto& [name, testClass] : testClasses()) {
        if (choice.isLong && testClass.longFunctions.isEmpty()) continue;
        if (place++ % choice.parts != choice.part) continue;
        ++run;
        QStringList words{QString::fromStdString(name)};
        if (choice.isLong) words += testClass.longFunctions;
        if (runApart(program, words) != 0) failed << words.first();
    }
    if (run == 0) failed << "no class was run";
    if (!failed.isEmpty()) std::printf("FAILED: %s\n", qPrintable(failed.join(", ")));
    return failed.isEmpty() ? 0 : 1;
}

/// Several classes, each with functions of it: `CLASS FUNCTION... CLASS FUNCTION...`, each class in its own process.
int runNamed(const char* program, const QStringList& words) {
    int failed = 0;
    for (qsizetype first = 0, next = 0; first < words.size(); first = next) {
        for (next = first + 1; next < words.size() && !testClasses().contains(words[next].toStdString());) ++next;
        if (runApart(program, words.mid(first, next - first)) != 0) ++failed;
    }
    return failed == 0 ? 0 : 1;
}

}  // namespace

const std::string& runningClass() { return nameOfRunningClass; }

bool isLongRun() { return qEnvironmentVariableIsSet(longRun); }

}  // namespace echolucent

int main(int count, char** arguments) {
    using namespace echolucent;
    const QStringList words(arguments + 1, arguments + count);
    const std::string first = words.isEmpty() ? "" : words.first().toStdString();
    if (const auto driven = drivenPrograms().find(first); driven != drivenPrograms().end()) {
        if (driven->second.beforeApplication) driven->second.beforeApplication();
        const std::unique_ptr<QCoreApplication> application = makeTestApplication(count, arguments);
        return driven->second.whatRuns(words);
    }
    if (testClasses().contains(first)) {
        const auto classes = std::count_if(
            words.begin(), words.end(), [](const QString& word) { return testClasses().contains(word.toStdString()); });
        return classes == 1 ? runOne(first, count, arguments) : runNamed(arguments[0], words);
    }
    if (Choice choice; isChoice(words, choice)) return runEach(arguments[0], choice);
    if (words[0] == "--long") {
        qputenv(longRun, "1");
        return runNamed(arguments[0], words.mid(1));
    }
    std::printf("%s [--long] [--part N/M] | [--long] CLASS [FUNCTION[:ROW]...] [CLASS ...]\nThe classes are:\n",
                arguments[0]);
    for (const auto& [name, testClass] : testClasses())
        std::printf("  %s%s\n", name.c_str(), testClass.longFunctions.isEmpty() ? "" : " (with long functions)");
    return 2;
}
