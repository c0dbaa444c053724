// Numbers on the command line: a comma is understood, and the language of the machine changes nothing.
#include <clocale>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "program.h"

namespace echolucent {
namespace {

/// Sets a variable of the environment for a while.
class Environment {
public:
    Environment(const char* name, const std::string& value) : m_name(name) {
        if (const char* before = std::getenv(name)) m_before = before;
        setenv(name, value.c_str(), 1);
    }
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;
    ~Environment() {
        if (m_before)
            setenv(m_name, m_before->c_str(), 1);
        else
            unsetenv(m_name);
    }

private:
    const char* m_name;
    std::optional<std::string> m_before;
};

/// What a phantom's truth and import report say: numbers that were typed, written and read again.
std::string numbersOf(const std::string& nearCut) {
    const Folder folder;
    const std::string volume = folder / "VOLUME.MHA";
    const Outcome made = runProgram("phantom " + volume + " --size 16 --spacing 0.75 --near " + nearCut + " --truth " +
                                    folder / "truth.json");
    EXPECT_EQ(made.status, 0) << made.errors;
    const Outcome info = runProgram("info --json " + volume);
    EXPECT_EQ(info.status, 0) << info.errors;
    const std::string truth = contentsOf(folder / "truth.json");
    EXPECT_EQ(nlohmann::json::parse(truth).at("view").at("near_mm"), 1.5);
    return truth + info.output;
}

TEST(Numbers, ACommaIsAPoint) {
    const std::string pointed = numbersOf("1.5");
    EXPECT_NE(pointed.find("0.75"), std::string::npos);
    EXPECT_EQ(numbersOf("1,5"), pointed);
}

TEST(Numbers, AreTheSameInEveryLanguage) {
    const std::string plain = numbersOf("1.5");
    const std::string before = std::setlocale(LC_ALL, nullptr);
    int tried = 0;
    for (const std::string language : {"de_DE.UTF-8", "tr_TR.UTF-8", "ar_EG.UTF-8", "fa_IR.UTF-8"}) {
        const bool known = std::setlocale(LC_ALL, language.c_str()) != nullptr;
        std::setlocale(LC_ALL, before.c_str());
        if (!known) continue;
        ++tried;
        const Environment all("LC_ALL", language), lang("LANG", language);
        EXPECT_EQ(numbersOf("1,5"), plain) << language;
    }
    if (tried == 0) GTEST_SKIP() << "this machine knows none of these languages";
}

}  // namespace
}  // namespace echolucent
