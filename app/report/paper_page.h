// A report on sheets of A4, as PDF.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/pages/html_page.h"
#include "processing/progress.h"

namespace echolucent {

/// The parts of HtmlPage that a case report has, for paper. Text is plain. Works in any thread of a program that has a
/// QGuiApplication.
class PaperPage {
public:
    explicit PaperPage(std::string title) : m_title(std::move(title)) {}
    void heading(const std::string& text);
    void paragraph(const std::string& text);
    /// Adds a text that keeps its ends of lines.
    void lines(const std::string& text);
    /// As HtmlPage::table().
    void table(const std::vector<std::string>& columns, const std::vector<std::vector<std::string>>& rows,
               const std::string& caption = {}, const std::vector<int>& widths = {});
    void plot(const Plot& plot);
    /// Begins the first sheet. Its pictures shrink until it fits one side.
    void beginSheet();
    /// Throws std::invalid_argument if the bytes of a picture do not fill it.
    void pictures(const std::vector<PagePicture>& row, PictureRow how = PictureRow::beside);
    /// Ends the first sheet. What follows has a title of its own.
    void appendix(const std::string& title);
    /// The file. Each sheet says at its foot that this is not a medical device. `creator` names the program. The
    /// result is empty only if progress.cancel was raised. Throws std::bad_alloc if there is no memory for it.
    [[nodiscard]] std::optional<std::string> pdf(const std::string& creator, const Progress& progress = {}) const;

    /// Where parts are written.
    struct Paper;

private:
    using Part = std::function<void(Paper&)>;
    std::string m_title;
    std::vector<Part> m_sheet, m_rest;
    bool m_inAppendix = false;
    void add(Part part) { (m_inAppendix ? m_rest : m_sheet).push_back(std::move(part)); }
};

}  // namespace echolucent
