#include "app/report/paper_page.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QImage>
#include <QPainter>
#include <QPainterPath>
#include <QPdfWriter>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextTable>
#include <QUrl>
#include <algorithm>
#include <cmath>
#include <new>
#include <stdexcept>
#include <utility>

#include "widgets/plots/plot_painting.h"

namespace echolucent {

namespace {

constexpr double sideMargin = 14.0, upperMargin = 12.0, footHeight = 7.0;  // mm
constexpr double paperWidth = 210.0 - 2.0 * sideMargin;                    // mm, of A4
constexpr double textPoints = 9.5, titlePoints = 15.0, headingPoints = 11.0, smallPoints = 8.0;
constexpr int dotsPerInch = 300;
constexpr double mmPerInch = 25.4;

QString wordsOf(const std::string& text) { return QString::fromStdString(text); }

/// QTextDocument counts in pixels of a plain screen, whose number in a mm only a picture tells.
double pixelsPerMm() { return QImage(1, 1, QImage::Format_RGB32).logicalDpiX() / mmPerInch; }

bool isNumber(const std::string& text) {
    bool is = false;
    (void)wordsOf(text).toDouble(&is);
    return is;
}

QImage imageOf(const PagePicture& picture) {
    if (picture.rgb.size() != std::size_t{3} * static_cast<std::size_t>(picture.width * picture.height))
        throw std::invalid_argument("PaperPage::pictures: the bytes do not fill the picture");
    QImage image =
        QImage(picture.rgb.data(), picture.width, picture.height, qsizetype{3} * picture.width, QImage::Format_RGB888)
            .copy();
    if (image.isNull()) throw std::bad_alloc();
    return image;
}

/// The plot in the colours of paper, without its title.
QImage imageOf(const Plot& titled) {
    constexpr double scale = 3.0, width = 640.0, areaHeight = 250.0;
    Plot plot = titled;
    plot.title.clear();
    QFont font;
    font.setPixelSize(12);
    const double height = PlotPainting::heightFor(plot, width, areaHeight, font);
    QImage image(QSize(qRound(width * scale), qRound(height * scale)), QImage::Format_RGB32);
    if (image.isNull()) throw std::bad_alloc();
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.scale(scale, scale);
    painter.setFont(font);
    const PlotPaint paper{.ground = Qt::white,
                          .text = Qt::black,
                          .secondary = Qt::black,
                          .grid = QColor("#d5d9de"),
                          .frame = Qt::gray,
                          .band = QColor("#e6ebf0")};
    PlotPainting(plot, QRectF(0, 0, width, height), painter).paint(painter, paper);
    painter.end();
    return image;
}

/// A picture of a row, made once for all sizes that are tried.
struct CaptionedImage {
    QString caption;
    QImage image;
};

QTextCharFormat letters(double points, bool bold = false) {
    QTextCharFormat format;
    format.setFontPointSize(points);
    format.setFontWeight(bold ? QFont::Bold : QFont::Normal);
    return format;
}

}  // namespace

struct PaperPage::Paper {
    Paper(QTextDocument& to, double share) : document(to), cursor(&to), pictureShare(share) {}

    QTextDocument& document;
    QTextCursor cursor;
    double pictureShare;  ///< of the largest size of pictures
    int images = 0;

    void block(const QString& text, const QTextCharFormat& format, double above) {
        cursor.movePosition(QTextCursor::End);
        QTextBlockFormat space;
        space.setTopMargin(above * pixelsPerMm());
        document.isEmpty() ? cursor.setBlockFormat(space) : cursor.insertBlock(space);
        cursor.insertText(text, format);
    }
    void image(QTextCursor& at, const QImage& picture, double widthMm) {
        const QString name = QStringLiteral("picture:%1").arg(images++);
        document.addResource(QTextDocument::ImageResource, QUrl(name), picture);
        QTextImageFormat format;
        format.setName(name);
        format.setWidth(widthMm * pixelsPerMm());
        format.setHeight(widthMm * pixelsPerMm() * picture.height() / std::max(1, picture.width()));
        at.insertImage(format);
    }
    /// The caption and the picture below it.
    void captioned(QTextCursor& at, const CaptionedImage& picture, double widthMm, bool isFirst) {
        if (!isFirst) at.insertBlock();
        at.insertText(picture.caption, letters(smallPoints));
        at.insertBlock();
        image(at, picture.image, widthMm);
    }
    QTextTable* grid(int rows, const std::vector<double>& percent, int headerRows = 0) {
        cursor.movePosition(QTextCursor::End);
        QTextTableFormat format;
        format.setBorder(0);
        format.setHeaderRowCount(headerRows);  // they stand again on each sheet that the table reaches
        format.setCellPadding(0.8 * pixelsPerMm());
        format.setCellSpacing(0);
        format.setWidth(QTextLength(QTextLength::PercentageLength, 100));
        QList<QTextLength> widths;
        for (const double share : percent)
            widths << (share > 0.0 ? QTextLength(QTextLength::PercentageLength, share) : QTextLength());
        format.setColumnWidthConstraints(widths);
        return cursor.insertTable(rows, static_cast<int>(percent.size()), format);
    }
};

void PaperPage::heading(const std::string& text) {
    add([text](Paper& paper) { paper.block(wordsOf(text), letters(headingPoints, true), 2.5); });
}

void PaperPage::paragraph(const std::string& text) {
    add([text](Paper& paper) { paper.block(wordsOf(text), letters(textPoints), 1.0); });
}

void PaperPage::lines(const std::string& text) {
    add([text](Paper& paper) {
        paper.block(wordsOf(text).replace('\n', QChar::LineSeparator), letters(textPoints), 0.5);
    });
}

void PaperPage::table(const std::vector<std::string>& columns, const std::vector<std::vector<std::string>>& rows,
                      const std::string& caption, const std::vector<int>& widths) {
    add([=](Paper& paper) {
        if (!caption.empty()) paper.block(wordsOf(caption), letters(smallPoints), 2.0);
        std::vector<double> percent(columns.size(), 0.0);
        std::copy_n(widths.begin(), std::min(widths.size(), percent.size()), percent.begin());
        QTextTable* table = paper.grid(static_cast<int>(rows.size()) + 1, percent, 1);
        const auto fill = [&](int row, int column, const std::string& text, bool bold) {
            QTextCursor at = table->cellAt(row, column).firstCursorPosition();
            QTextBlockFormat side;
            side.setAlignment(!bold && isNumber(text) ? Qt::AlignRight : Qt::AlignLeft);
            at.setBlockFormat(side);
            at.insertText(wordsOf(text), letters(textPoints - 0.5, bold));
        };
        for (std::size_t c = 0; c < columns.size(); ++c) fill(0, static_cast<int>(c), columns[c], true);
        for (std::size_t r = 0; r < rows.size(); ++r)
            for (std::size_t c = 0; c < std::min(columns.size(), rows[r].size()); ++c)
                fill(static_cast<int>(r) + 1, static_cast<int>(c), rows[r][c], false);
    });
}

void PaperPage::plot(const Plot& plot) {
    add([title = wordsOf(plot.title), image = imageOf(plot)](Paper& paper) {
        constexpr double width = 150.0;  // mm
        paper.block(title, letters(smallPoints), 2.0);
        paper.cursor.insertBlock();
        paper.image(paper.cursor, image, width);
    });
}

void PaperPage::beginSheet() {
    add([title = m_title](Paper& paper) { paper.block(wordsOf(title), letters(titlePoints, true), 0.0); });
}

void PaperPage::pictures(const std::vector<PagePicture>& pictures, PictureRow how) {
    if (pictures.empty()) return;
    std::vector<CaptionedImage> row;
    for (const PagePicture& picture : pictures) row.push_back({wordsOf(picture.caption), imageOf(picture)});
    add([row, how](Paper& paper) {
        constexpr double largeShare = 0.74, gap = 3.0, highest = 150.0;  // mm
        const bool beside = how == PictureRow::beside && row.size() > 1;
        const double aspect = static_cast<double>(row[0].image.width()) / std::max(1, row[0].image.height());
        const double room = beside ? largeShare * paperWidth - gap : paperWidth - gap;
        const double large = std::min(room, highest * aspect) * paper.pictureShare;
        const double count = static_cast<double>(row.size() - 1);
        if (beside) {
            QTextTable* table = paper.grid(1, {100.0 * largeShare, 100.0 * (1.0 - largeShare)});
            QTextCursor left = table->cellAt(0, 0).firstCursorPosition();
            QTextCursor right = table->cellAt(0, 1).firstCursorPosition();
            paper.captioned(left, row[0], large, true);
            const double small = ((1.0 - largeShare) * paperWidth - gap) * paper.pictureShare;
            for (std::size_t i = 1; i < row.size(); ++i) paper.captioned(right, row[i], small, i == 1);
            return;
        }
        paper.block({}, letters(smallPoints), 1.0);
        paper.captioned(paper.cursor, row[0], large, true);
        if (row.size() < 2) return;
        QTextTable* table = paper.grid(1, std::vector<double>(row.size() - 1, 100.0 / count));
        for (std::size_t i = 1; i < row.size(); ++i) {
            QTextCursor at = table->cellAt(0, static_cast<int>(i) - 1).firstCursorPosition();
            paper.captioned(at, row[i], (paperWidth / count - gap) * paper.pictureShare, true);
        }
    });
}

void PaperPage::appendix(const std::string& title) {
    m_inAppendix = true;
    add([title](Paper& paper) { paper.block(wordsOf(title), letters(titlePoints, true), 0.0); });
}

std::optional<std::string> PaperPage::pdf(const std::string& creator, const Progress& progress) const {
    QBuffer bytes;
    bytes.open(QIODevice::WriteOnly);
    QPdfWriter writer(&bytes);
    writer.setTitle(wordsOf(m_title));
    writer.setCreator(wordsOf(creator));
    writer.setResolution(dotsPerInch);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins({sideMargin, upperMargin, sideMargin, upperMargin}, QPageLayout::Millimeter);
    const double perMm = pixelsPerMm(), zoom = dotsPerInch / (perMm * mmPerInch);
    const QSizeF body(writer.width() / zoom, writer.height() / zoom - footHeight * perMm);
    const auto fill = [&](QTextDocument& document, const std::vector<Part>& parts, double share) {
        QFont font(QStringLiteral("sans-serif"));
        font.setPointSizeF(textPoints);
        document.setDefaultFont(font);
        document.setUseDesignMetrics(true);
        document.setDocumentMargin(0.0);
        document.setPageSize(body);
        Paper paper(document, share);
        for (const Part& part : parts) part(paper);
    };
    QPainter painter(&writer);
    // Pictures of measurements stay as they are, to the bit.
    painter.setRenderHint(QPainter::LosslessImageRendering);
    int sides = 0;
    const auto draw = [&](const QTextDocument& document) {
        for (int page = 0; page < document.pageCount(); ++page) {
            if (sides++ > 0) writer.newPage();
            painter.save();
            painter.scale(zoom, zoom);
            // In pixels, since the painter would make points of its own resolution of them.
            QFont foot = document.defaultFont();
            foot.setPixelSize(qRound(smallPoints / 72.0 * mmPerInch * perMm));
            painter.setFont(foot);
            painter.drawText(QRectF(0, body.height(), body.width(), footHeight * perMm),
                             Qt::AlignLeft | Qt::AlignBottom, QStringLiteral("Echolucent is not a medical device."));
            painter.translate(0, -page * body.height());
            QAbstractTextDocumentLayout::PaintContext context;
            context.clip = QRectF(QPointF(0, page * body.height()), body);
            // Whatever theme the window has, paper is white.
            context.palette.setColor(QPalette::Text, Qt::black);
            painter.setClipRect(context.clip);
            document.documentLayout()->draw(&painter, context);
            painter.restore();
        }
    };
    constexpr double least = 0.25, step = 0.05;
    for (double share = 1.0;; share -= step) {
        if (progress.cancelled()) return std::nullopt;
        progress.at(1.0 - share);
        QTextDocument sheet;
        fill(sheet, m_sheet, share);
        if (sheet.pageCount() > 1 && share > least) continue;
        draw(sheet);
        break;
    }
    if (progress.cancelled()) return std::nullopt;
    progress.at(0.8);
    if (!m_rest.empty()) {
        QTextDocument rest;
        fill(rest, m_rest, 1.0);
        draw(rest);
    }
    painter.end();
    return bytes.data().toStdString();
}

}  // namespace echolucent
