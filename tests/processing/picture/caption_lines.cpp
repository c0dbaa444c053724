// Where the caption of a picture is broken so that it fits.
#include <gtest/gtest.h>

#include <string>

#include "processing/picture/annotation_layout.h"

namespace echolucent {
namespace {

/// Each byte counts 1; the dot between two facts has two bytes, and with its blanks four.
double bytesOf(const std::string& line) { return static_cast<double>(line.size()); }

TEST(CaptionLines, BreakBeforeTheFactThatIsTooWide) {
    const std::string caption = "onto the back · front, bowed · smoothed";
    EXPECT_EQ(captionWithin(caption, 100, bytesOf), caption);
    EXPECT_EQ(captionWithin(caption, 41, bytesOf), caption) << "it just fits";
    EXPECT_EQ(captionWithin(caption, 40, bytesOf), "onto the back · front, bowed\nsmoothed");
    EXPECT_EQ(captionWithin(caption, 29, bytesOf), "onto the back · front, bowed\nsmoothed");
    EXPECT_EQ(captionWithin(caption, 28, bytesOf), "onto the back\nfront, bowed · smoothed");
    EXPECT_EQ(captionWithin(caption, 5, bytesOf), "onto the back\nfront, bowed\nsmoothed") << "a fact is never cut";
}

TEST(CaptionLines, KeepTheLinesThatThereAre) {
    EXPECT_EQ(captionWithin("", 5, bytesOf), "");
    EXPECT_EQ(captionWithin("a · b\nc · d", 100, bytesOf), "a · b\nc · d");
    EXPECT_EQ(captionWithin("a · b\nc · d", 4, bytesOf), "a\nb\nc\nd");
}

}  // namespace
}  // namespace echolucent
