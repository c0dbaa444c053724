// Controls in a row that goes on in the next line if the window is narrow.
#pragma once

#include <QLayout>
#include <vector>

namespace echolucent {

/// A line takes as many items as fit at their preferred width. The layout is never narrower than its widest item. Items
/// that expand share the free room of their line; the others keep their width. If a line holds items from before and
/// after addStretch(), the later ones stand at the line's right end.
class FlowLayout : public QLayout {
    Q_OBJECT

public:
    explicit FlowLayout(int spacing, QWidget* parent = nullptr);
    ~FlowLayout() override;

    /// How many lines a width takes.
    [[nodiscard]] int rows(int width) const;

    void addStretch() { m_stretchBefore = count(); }

    void addItem(QLayoutItem* item) override { m_items.push_back(item); }
    [[nodiscard]] int count() const override { return static_cast<int>(m_items.size()); }
    [[nodiscard]] QLayoutItem* itemAt(int index) const override;
    QLayoutItem* takeAt(int index) override;
    [[nodiscard]] Qt::Orientations expandingDirections() const override { return {}; }
    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override { return arrange({0, 0, width, 0}, false); }
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSize() const override;
    void setGeometry(const QRect& rect) override;

private:
    /// A line: the items from `first` to before `end`, hidden ones among them.
    struct Line {
        int first = 0, end = 0;
        int width = 0, height = 0;
        int wide = 0;  ///< items that expand
    };
    [[nodiscard]] std::vector<Line> lines(int width) const;
    /// Places the items in the rectangle, or only measures them. Returns their height.
    int arrange(const QRect& rect, bool apply) const;

    std::vector<QLayoutItem*> m_items;
    int m_stretchBefore = -1;  // the first item behind the stretch
};

}  // namespace echolucent
