// Words from files as one line: what is made blank, what is no UTF-8, and where a long text ends.
#include "processing/one_line.h"

#include <gtest/gtest.h>

namespace echolucent {
namespace {

TEST(OneLine, LeavesLettersOfAllLanguagesAlone) {
    for (const char* text : {"", "a b", "Müller", "心臓", "\U0001f9e1", "\u00a0\u2027\u202f\u2065\u206a", "±½ 30°"})
        EXPECT_EQ(oneLine(text), text);
}

TEST(OneLine, MakesBlanksOfWhatControls) {
    std::string text;
    for (int code = 0; code < 0x20; ++code) text += static_cast<char>(code);
    EXPECT_EQ(oneLine(text + "\x7f\u0080\u009f"), std::string(0x20 + 3, ' '));
    EXPECT_EQ(oneLine("\u2028\u2029\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2068\u2069"), std::string(11, ' '));
}

TEST(OneLine, ShowsBytesThatAreNoUtf8AsSuch) {
    const std::string bad = "\ufffd";
    EXPECT_EQ(oneLine("M\xfcller"), "M" + bad + "ller");
    EXPECT_EQ(oneLine("\x9b"
                      "2J"),
              bad + "2J")
        << "a control character of Latin-1";
    EXPECT_EQ(oneLine("\xc2"), bad) << "half a letter at the end";
    EXPECT_EQ(oneLine("\xc0\x9b"), bad + bad) << "a control character spelled too long";
    EXPECT_EQ(oneLine("\xe0\x80\x9b"), bad + bad + bad);
    EXPECT_EQ(oneLine("\xed\xa0\x80"), bad + bad + bad) << "half of a surrogate";
    EXPECT_EQ(oneLine("\xf4\x90\x80\x80\xf5"), bad + bad + bad + bad + bad) << "beyond the last letter";
}

TEST(OneLine, EndsAfterAWholeLetter) {
    EXPECT_EQ(oneLine("abc", 3), "abc");
    EXPECT_EQ(oneLine("abcd", 3), "abc...");
    EXPECT_EQ(oneLine("ab\u00fc", 3), "ab...");
    EXPECT_EQ(oneLine("\x01", 0), "...");
}

TEST(OneLine, LettersAreCountedAndCutWhole) {
    const std::string text = "M\u00fc\u5fc3\U0001f9e1x";
    EXPECT_EQ(letterCount(""), 0u);
    EXPECT_EQ(letterCount(text), 5u);
    EXPECT_EQ(firstLetters(text, 0), "");
    EXPECT_EQ(firstLetters(text, 2), "M\u00fc");
    EXPECT_EQ(firstLetters(text, 4), "M\u00fc\u5fc3\U0001f9e1");
    EXPECT_EQ(firstLetters(text, 5), text);
    EXPECT_EQ(firstLetters(text, 6), text);
}

}  // namespace
}  // namespace echolucent
